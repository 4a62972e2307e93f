#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "session/ComparedRuns.h"
#include "workbench/Background.h"
#include "workbench/Control.h"
#include "workbench/CustomPlot.h"
#include "workbench/Dialog.h"
#include "workbench/DifferenceTree.h"
#include "workbench/PlotColors.h"

namespace gt {
namespace {

constexpr const char* asRecorded = "as recorded";
constexpr const char* replayedAsIs = "replayed";
/// Points farther apart are not joined, in s.
constexpr double joined = 0.5;

/// Compares two logs, or the results of two solutions on one log, value by value.
class CompareLogs : public Dialog {
 public:
  explicit CompareLogs(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* grid = new QGridLayout;
    layout->addLayout(grid);
    for (int i = 0; i < 2; ++i) addSide(*grid, i);
    grid->setColumnStretch(1, 1);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    addButton(*row, *this, "compare", "Compare", "Compares both sides, time by time",
              [this] { compare(); });
    addButton(*row, *this, "stop", "Stop", "Shows what was compared so far",
              [this] { work_.stop(); });
    progress_ = new QProgressBar;
    progress_->setRange(0, 1000);
    progress_->setMaximumWidth(160);
    row->addWidget(progress_);
    state_ = new QLabel{"Choose two logs, or one log and two solutions of a task"};
    state_->setObjectName("state");
    state_->setWordWrap(true);
    row->addWidget(state_, 1);
    addFilter(*layout);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts, 1);
    tree_ = new DifferenceTree;
    tree_->setObjectName("differences");
    tree_->chosen = [this] { chosen(); };
    tree_->marked = [this](Time time) { showMark(time); };
    QObject::connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this] { jump(); });
    parts->addWidget(tree_);
    addPlot(*parts);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    showRunning();
  }

  QJsonObject settings() const override {
    QJsonArray sides;
    for (const Side& side : sides_)
      sides.append(
          QJsonArray{side.file->text(), side.task->currentText(), side.solution->currentText()});
    return {{"sides", sides}, {"onlyDifferent", onlyDifferent_->isChecked()}};
  }
  void restore(const QJsonObject& settings) override {
    const QJsonArray sides = settings["sides"].toArray();
    for (int i = 0; i < 2 && i < sides.size(); ++i) {
      sides_[i].file->setText(sides[i][0].toString());
      sides_[i].task->setCurrentText(sides[i][1].toString());
      sides_[i].solution->setCurrentText(sides[i][2].toString());
    }
    onlyDifferent_->setChecked(settings["onlyDifferent"].toBool(true));
  }
  void refresh() override { showRunning(); }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) setPlotColors(*plot_, palette());
    Dialog::changeEvent(event);
  }

 private:
  struct Side {
    QLineEdit* file;
    QComboBox* task;
    QComboBox* solution;
  };

  void addSide(QGridLayout& grid, int i) {
    const QString letter = i == 0 ? "A" : "B";
    Side& side = sides_[i];
    auto* name = new QLabel{letter};
    name->setStyleSheet(QString{"font-weight: bold; color: %1"}.arg(QColor{sideColors[i]}.name()));
    grid.addWidget(name, i, 0);
    side.file = makeControl<QLineEdit>("file" + letter, "The log on this side (.mcap, .log)");
    side.file->setPlaceholderText(i == 0 ? "A log" : "Another log; empty: the same one");
    side.file->setMinimumWidth(120);
    grid.addWidget(side.file, i, 1);
    auto* choose = makeControl<QPushButton>("choose" + letter, "Chooses a log", "Choose…");
    QObject::connect(choose, &QPushButton::clicked, this, [this, file = side.file] {
      const QString chosen = QFileDialog::getOpenFileName(this, "Compare a log", "out/logs",
                                                          "Logs (*.mcap *.log);;All (*)");
      if (!chosen.isEmpty()) file->setText(chosen);
    });
    grid.addWidget(choose, i, 2);
    side.task = new QComboBox;
    side.task->setObjectName("task" + letter);
    side.task->setToolTip(
        "As it was recorded, or replayed: with the solutions that it was "
        "recorded with, but for one of this task");
    side.task->addItems({asRecorded, replayedAsIs});
    for (const auto& [task, solutions] : tasks_) side.task->addItem(QString::fromStdString(task));
    grid.addWidget(side.task, i, 3);
    side.solution = new QComboBox;
    side.solution->setObjectName("solution" + letter);
    side.solution->setToolTip("Which solution of the task runs");
    for (QComboBox* box : {side.task, side.solution}) {
      box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      box->setMinimumContentsLength(8);
      box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    side.solution->setEnabled(false);
    QObject::connect(side.task, &QComboBox::currentTextChanged, this,
                     [this, solution = side.solution](const QString& task) {
                       solution->clear();
                       const auto known = tasks_.find(task.toStdString());
                       solution->setEnabled(known != tasks_.end());
                       if (known == tasks_.end()) return;
                       for (const std::string& each : known->second)
                         solution->addItem(QString::fromStdString(each));
                     });
    grid.addWidget(side.solution, i, 4);
  }

  void addFilter(QVBoxLayout& layout) {
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    filter_ = makeControl<QLineEdit>("filter", "Lists only values whose names hold these letters");
    filter_->setPlaceholderText("Find a value");
    filter_->setClearButtonEnabled(true);
    QObject::connect(filter_, &QLineEdit::textChanged, this, [this] { filter(); });
    row->addWidget(filter_, 1);
    onlyDifferent_ = makeControl<QCheckBox>(
        "onlyDifferent", "Leaves out what is the same on both sides", "Only differences");
    onlyDifferent_->setChecked(true);
    QObject::connect(onlyDifferent_, &QCheckBox::toggled, this, [this] { filter(); });
    row->addWidget(onlyDifferent_);
    addButton(*row, *this, "previous", "Previous", "Goes to the difference before",
              [this] { tree_->goOn(-1); });
    addButton(*row, *this, "next", "Next", "Goes to the next difference of the chosen row",
              [this] { tree_->goOn(1); });
    addButton(*row, *this, "jump", "Show there",
              "Has two robots run on both logs up to the marked time, to be looked at by the "
              "viewers (context menu Robot)",
              [this] { jump(); });
  }

  void addPlot(QSplitter& parts) {
    plot_ = new QCustomPlot;
    plot_->setObjectName("curves");
    plot_->setMinimumHeight(130);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot_->axisRect()->setRangeZoom(Qt::Horizontal);
    plot_->axisRect()->setRangeDrag(Qt::Horizontal);
    for (int i = 0; i < 2; ++i) {
      QCPGraph* graph = plot_->addGraph();
      graph->setName(i == 0 ? "A" : "B");
      graph->setPen(QPen{QColor{sideColors[i]}, 1.5});
      graph->setScatterStyle(QCPScatterStyle{QCPScatterStyle::ssDisc, 3});
    }
    mark_ = new QCPItemStraightLine{plot_};
    mark_->setVisible(false);
    plot_->legend->setVisible(true);
    keepLegendInside(*plot_);
    plot_->xAxis->setLabel("s");
    QObject::connect(plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
      const double seconds = plot_->xAxis->pixelToCoord(event->pos().x());
      const double most = inSeconds(tree_->comparison().end);
      tree_->mark(Time{std::llround(1000 * std::clamp(seconds, 0.0, std::max(most, 0.0)))});
    });
    setPlotColors(*plot_, palette());
    parts.addWidget(plot_);
  }

  /// The run that is chosen at a side; B's log is A's if no other is chosen.
  ComparedRun run(int i) const {
    const Side& side = sides_[i];
    const QString file = side.file->text().trimmed();
    ComparedRun run{(file.isEmpty() ? sides_[0].file->text().trimmed() : file).toStdString()};
    run.replayed = side.task->currentIndex() > 0;
    if (side.task->currentIndex() > 1) {
      run.task = side.task->currentText().toStdString();
      run.solution = side.solution->currentText().toStdString();
    }
    return run;
  }

  void compare() {
    runs_[0] = run(0);
    runs_[1] = run(1);
    state_->setText("Comparing…");
    waiting_ = true;
    // What logs without a setup need is the session's.
    session().ask(
        this, [](Console& console) { return console.session().logOptions(); },
        [this](const LogRobotOptions& options) {
          waiting_ = false;
          work_.start(
              this,
              [a = runs_[0], b = runs_[1], options](const Background::Progress& progress) {
                return compareRuns(a, b, options, progress);
              },
              [this](Result<LogComparison>& comparison) { show(comparison); });
        });
  }

  void showRunning() {
    const bool running = waiting_ || work_.running();
    progress_->setVisible(running);
    progress_->setValue(static_cast<int>(1000 * work_.share()));
    if (auto* stop = findChild<QPushButton*>("stop")) stop->setEnabled(running);
    if (auto* button = findChild<QPushButton*>("compare")) button->setEnabled(!running);
  }

  void show(Result<LogComparison>& comparison) {
    showRunning();
    if (!comparison) return state_->setText(QString::fromStdString(comparison.error().text()));
    tree_->take(std::move(*comparison));
    const LogComparison& known = tree_->comparison();
    const auto same = std::ranges::count_if(known.topics, &ComparedTopic::same);
    std::size_t inputs = 0, sameInputs = 0;
    for (const ComparedTopic& topic : known.topics) {
      inputs += topic.input;
      sameInputs += topic.input && topic.same();
    }
    QString result =
        QString{"%1 of %2 representations are the same"}.arg(same).arg(known.topics.size());
    if (inputs > 0) result += inputs == sameInputs ? ", all inputs among them" : "; inputs differ";
    if (known.stopped)
      result += QString{", up to %1 s, where it was stopped"}.arg(inSeconds(known.end));
    state_->setText(result);
    plot_->xAxis->setRange(inSeconds(known.begin), inSeconds(known.end));
    filter();
  }
  void filter() { tree_->filter(filter_->text().trimmed(), onlyDifferent_->isChecked()); }

  void chosen() {
    const DifferentValue* value = tree_->chosenValue();
    for (int i = 0; i < 2; ++i) {
      QVector<double> times, values;
      double last = 0;
      if (value)
        for (const DifferentValue::Point& point : value->points) {
          const double now = inSeconds(point.time);
          if (!times.isEmpty() && now - last > joined) {
            times << (now + last) / 2;
            values << std::numeric_limits<double>::quiet_NaN();
          }
          times << now;
          values << (i == 0 ? point.a : point.b);
          last = now;
        }
      plot_->graph(i)->setData(times, values, true);
    }
    plot_->yAxis->setLabel(value ? QString::fromStdString(value->path) : QString{});
    plot_->yAxis->rescale();
    plot_->yAxis->scaleRange(1.1);
    if (value && tree_->markedTime() == never()) tree_->mark(value->first);
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }

  void showMark(Time time) {
    const double at = inSeconds(time);
    mark_->point1->setCoords(at, 0);
    mark_->point2->setCoords(at, 1);
    mark_->setPen(QPen{palette().color(QPalette::Highlight), 1.5});
    mark_->setVisible(true);
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }
  /// Lets a robot run on each of both logs, with its solution, and stop at the marked time.
  void jump() {
    if (tree_->comparison().topics.empty() || tree_->markedTime() == never()) return;
    session().ask(
        this,
        [](Console& console) {
          std::set<std::string> names;
          for (const auto& robot : console.session().robots()) names.insert(robot->name());
          return names;
        },
        [this](std::set<std::string>& names) { jumpWith(names); });
  }
  void jumpWith(std::set<std::string>& names) {
    std::string both;
    for (const ComparedRun& run : runs_) {
      std::string& name = robots_[run.log + "\n" + run.task + "\n" + run.solution];
      if (name.empty() || !names.contains(name)) {
        name = nameFor(run, names);
        names.insert(name);
        session().execute("sl " + name + " \"" + run.log + "\"");
        session().executeFor(name, "lp pause");
        if (!run.task.empty()) session().executeFor(name, "sr " + run.task + " " + run.solution);
      }
      session().executeFor(name, "lp time " + std::to_string(inSeconds(tree_->markedTime())));
      both += " " + name;
    }
    session().execute("robot" + both);
  }
  /// A robot's name that no other one has.
  static std::string nameFor(const ComparedRun& run, const std::set<std::string>& names) {
    QString begin = QFileInfo{QString::fromStdString(run.log)}.completeBaseName().replace(' ', '_');
    if (!run.solution.empty()) begin += "-" + QString::fromStdString(run.solution);
    QString name = begin;
    for (int i = 2; names.contains(name.toStdString()); ++i)
      name = QString{"%1-%2"}.arg(begin).arg(i);
    return name.toStdString();
  }

  const std::map<std::string, std::vector<std::string>> tasks_ = allSolutions();
  Side sides_[2];
  QLineEdit* filter_;
  QCheckBox* onlyDifferent_;
  QProgressBar* progress_;
  QLabel* state_;
  DifferenceTree* tree_;
  QCustomPlot* plot_;
  QCPItemStraightLine* mark_;
  ComparedRun runs_[2];
  std::map<std::string, std::string> robots_;  ///< That were made to show a side.
  bool waiting_ = false;
  Background work_;
};

const RegisterDialog<CompareLogs> registeredCompareLogs{
    {.id = "compare",
     .title = "Compare logs",
     .group = "Session",
     .help = "Two logs, or two solutions on the same log, side by side: where they differ",
     .place = DialogPlace::center,
     .several = true}};

}  // namespace
}  // namespace gt
