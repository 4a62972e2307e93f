#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Tries the present situation many times, and saves it as a test, by the console's command test.
class SituationTest : public Dialog {
 public:
  explicit SituationTest(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* form = new QFormLayout;
    layout->addLayout(form);
    condition_ = makeControl<QLineEdit>(
        "condition", "What is to happen, such as: score.red > 0 or distance(red4, ball) < 200",
        "score.red > 0");
    form->addRow("Until", condition_);
    seconds_ = makeControl<QDoubleSpinBox>("seconds", "A run that takes longer has failed");
    seconds_->setRange(0.1, 1200);
    seconds_->setValue(20);
    seconds_->setSuffix(" s");
    form->addRow("Within", seconds_);
    runs_ = makeControl<QSpinBox>("runs", "Each run has the next seed");
    runs_->setRange(1, 1000);
    runs_->setValue(10);
    form->addRow("Runs", runs_);
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    addButton(*buttons, *this, "try", "Try",
              "Begins so many times with all that was done so far, and lists how it ended; "
              "this simulation is left alone (Shift+F5 stops)",
              [this] { tryIt(); });
    addButton(*buttons, *this, "save", "Save as test…",
              "Writes what is on the field now as a script, which fails if the condition does "
              "not hold in time: simgt console SCENE --script TEST",
              [this] { save(); });
    buttons->addStretch();
    state_ = new QLabel{"Robots, balls, score and state of the game as they are now"};
    state_->setObjectName("state");
    state_->setWordWrap(true);
    layout->addWidget(state_);
    results_ = new QTreeWidget;
    results_->setObjectName("results");
    results_->setRootIsDecorated(false);
    results_->setHeaderLabels({"Run", "Seed", "Result", "Seconds", "Red", "Blue"});
    results_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    layout->addWidget(results_, 1);
  }

  QJsonObject settings() const override {
    return {{"condition", condition_->text()},
            {"seconds", seconds_->value()},
            {"runs", runs_->value()}};
  }
  void restore(const QJsonObject& settings) override {
    if (settings["condition"].isString()) condition_->setText(settings["condition"].toString());
    seconds_->setValue(settings["seconds"].toDouble(seconds_->value()));
    runs_->setValue(settings["runs"].toInt(runs_->value()));
  }
  void refresh() override {}

 private:
  QString condition() const { return "\"" + condition_->text().simplified() + "\""; }

  void tryIt() {
    const QString table = QString::fromStdString((folder_.path() / "situation.csv").string());
    const QString line = QString{"test situation %1 %2 %3 \"%4\""}
                             .arg(runs_->value())
                             .arg(seconds_->value())
                             .arg(condition(), table);
    state_->setText("Trying…");
    session().execute(line.toStdString(), this, [this, table](const Result<void>& done) {
      if (!done) return state_->setText(QString::fromStdString(done.error().text()));
      showResults(table);
    });
  }

  void showResults(const QString& table) {
    const auto text = readFile(table.toStdString());
    if (!text) return state_->setText(QString::fromStdString(text.error().text()));
    results_->clear();
    int reached = 0;
    QStringList lines = QString::fromStdString(*text).split('\n', Qt::SkipEmptyParts);
    lines.removeFirst();
    for (const QString& line : lines) {
      // The result stands in the middle and may hold commas.
      const QStringList cells = line.split(',');
      constexpr int before = 2, behind = 5;
      auto* row = new QTreeWidgetItem{results_};
      row->setText(0, cells.value(0));
      row->setText(1, cells.value(1));
      QString result = cells.mid(before, cells.size() - before - behind).join(',');
      if (result.startsWith('"')) result = result.mid(1, result.size() - 2).replace("\"\"", "\"");
      row->setText(2, result);
      for (int i = 0; i < 3; ++i) row->setText(3 + i, cells.value(cells.size() - behind + i));
      reached += result != "timeout";
    }
    state_->setText(QString{"It happened in %1 of %2 runs"}.arg(reached).arg(lines.size()));
  }

  void save() {
    const QString file = QFileDialog::getSaveFileName(this, "Save as test",
                                                      "out/tests/situation.con", "Scripts (*.con)");
    if (file.isEmpty()) return;
    const QString line =
        QString{"test save \"%1\" %2 %3"}.arg(file).arg(seconds_->value()).arg(condition());
    session().execute(line.toStdString(), this, [this, file](const Result<void>& done) {
      state_->setText(done ? file + " is written" : QString::fromStdString(done.error().text()));
    });
  }

  QLineEdit* condition_;
  QDoubleSpinBox* seconds_;
  QSpinBox* runs_;
  QLabel* state_;
  QTreeWidget* results_;
  TemporaryFolder folder_;  ///< Of the table that the console writes.
};

const RegisterDialog<SituationTest> registeredSituationTest{
    {.id = "situation",
     .title = "Situation as test",
     .group = "Session",
     .help = "Tries what is on the field now many times, and saves it as a test"}};

}  // namespace
}  // namespace gt
