#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "views/Views.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Films a view of the connected robot, or the scene, by the console's command film.
class FilmDialog : public Dialog {
 public:
  explicit FilmDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* form = new QFormLayout;
    layout->addLayout(form);
    view_ = makeControl<QComboBox>("view", "The view that is filmed");
    for (const auto& view : builtInViews()) {
      view_->addItem(QString::fromStdString(view->name()));
      view_->setItemData(view_->count() - 1, QString::fromStdString(view->help()), Qt::ToolTipRole);
    }
    view_->setCurrentText("scene");
    form->addRow("View", view_);
    numbers_ = makeControl<QLineEdit>("numbers", "Numbers of the view, separated by blanks");
    numbers_->setPlaceholderText("Numbers of the view, such as from where it looks");
    form->addRow("Numbers", numbers_);
    auto* row = new QHBoxLayout;
    file_ = makeControl<QLineEdit>("file", "The film (.mp4)", "out/film.mp4");
    row->addWidget(file_);
    addButton(*row, *this, "choose", "Choose…", "Chooses the file", [this] {
      const QString file =
          QFileDialog::getSaveFileName(this, "Film", file_->text(), "Films (*.mp4)");
      if (!file.isEmpty()) file_->setText(file);
    });
    form->addRow("File", row);
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    addButton(*buttons, *this, "start", "Start", "Films 25 images a simulated second", [this] {
      const QString line = "film start \"" + file_->text() + "\" " + view_->currentText() + " " +
                           numbers_->text().simplified();
      execute(line.trimmed().toStdString(), "is being filmed");
    });
    addButton(*buttons, *this, "stop", "Stop", "Ends the film",
              [this] { execute("film stop", "is written"); });
    buttons->addStretch();
    state_ = new QLabel;
    state_->setObjectName("state");
    state_->setWordWrap(true);
    layout->addWidget(state_);
    layout->addStretch();
  }

  QJsonObject settings() const override {
    return {{"view", view_->currentText()}, {"numbers", numbers_->text()}, {"file", file_->text()}};
  }
  void restore(const QJsonObject& settings) override {
    if (settings["view"].isString()) view_->setCurrentText(settings["view"].toString());
    if (settings["numbers"].isString()) numbers_->setText(settings["numbers"].toString());
    if (settings["file"].isString()) file_->setText(settings["file"].toString());
  }
  void refresh() override {}

 private:
  void execute(const std::string& line, const QString& then) {
    session().execute(line, this, [this, then](const Result<void>& done) {
      state_->setText(done ? file_->text() + " " + then
                           : QString::fromStdString(done.error().text()));
    });
  }

  QComboBox* view_;
  QLineEdit* numbers_;
  QLineEdit* file_;
  QLabel* state_;
};

const RegisterDialog<FilmDialog> registeredFilmDialog{
    {.id = "film",
     .title = "Film",
     .group = "Session",
     .help = "Films the scene or another view of the connected robot as MP4",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
