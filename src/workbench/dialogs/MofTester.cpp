#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <filesystem>

#include "base/File.h"
#include "base/UserFolder.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// The file of the executed lines, which a saved state executes again.
Result<std::string> fileOfTriedLines() {
  const std::string folder = userFolder(UserFolder::state);
  if (folder.empty())
    return Error{.what = "there is no folder for lines that are tried: set XDG_STATE_HOME"};
  return folder + "/tried.mof";
}

/// Report J.5.4: executes lines of joint data, and reads them from the robot.
class MofTester : public Dialog {
 public:
  explicit MofTester(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    lines_ = new QPlainTextEdit;
    lines_->setObjectName("lines");
    lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
    lines_->setFont(QFont{"DejaVu Sans Mono"});
    lines_->setPlaceholderText(
        "Lines of a motion description: angles in mrad, whether to "
        "interpolate, and for how many frames of 8 ms");
    layout->addWidget(lines_);
    auto* first = new QHBoxLayout;
    auto* second = new QHBoxLayout;
    layout->addLayout(first);
    layout->addLayout(second);
    const auto button = [&](QHBoxLayout* row, auto... what) { addButton(*row, *this, what...); };
    button(first, "execute", "Execute", "Executes all lines that hold joint data",
           [this] { execute(); });
    loop_ = makeControl<QCheckBox>("loop", "Begins again after the last line", "Loop");
    first->addWidget(loop_);
    button(first, "stop", "Stop", "The joints stay where they are",
           [this] { this->session().execute("mof stop"); });
    button(first, "read", "Read", "Adds a line that brings the joints to where they are now",
           [this] { read(); });
    button(second, "takeOver", "Take over", "Has the solution Debug of MotionControl execute lines",
           [this] { this->session().execute("sr MotionControl Debug"); });
    button(second, "open", "Open…", "Reads a motion description", [this] {
      const QString file = QFileDialog::getOpenFileName(this, "Open", "motions", "Motions (*.mof)");
      if (const auto text = readFile(file.toStdString()))
        lines_->setPlainText(QString::fromStdString(*text));
    });
    button(second, "save", "Save…", "Writes a motion description", [this] {
      const QString file =
          QFileDialog::getSaveFileName(this, "Save", "motions/new.mof", "Motions (*.mof)");
      if (file.isEmpty()) return;
      if (const auto done = writeFile(file.toStdString(), text()); !done)
        QMessageBox::warning(this, "Save", QString::fromStdString(done.error().text()));
    });
  }

  QJsonObject settings() const override { return {{"lines", lines_->toPlainText()}}; }
  void restore(const QJsonObject& settings) override {
    lines_->setPlainText(settings["lines"].toString());
  }
  void refresh() override {}

 private:
  std::string text() const { return lines_->toPlainText().toStdString() + "\n"; }

  void execute() {
    const auto file = writeLines();
    if (!file) {
      QMessageBox::warning(this, "Execute", QString::fromStdString(file.error().text()));
      return;
    }
    session().execute(std::string{"mof "} + (loop_->isChecked() ? "loop " : "execute ") + "\"" +
                      *file + "\"");
  }

  /// Returns the file.
  Result<std::string> writeLines() const {
    const auto file = fileOfTriedLines();
    if (!file) return file.error();
    std::error_code ignored;  // then writing reports what is wrong
    std::filesystem::create_directories(std::filesystem::path{*file}.parent_path(), ignored);
    if (const auto done = writeFile(*file, text()); !done) return done.error();
    return file;
  }

  void read() {
    // The command prints the line, perhaps behind the robot's name.
    session().execute("mof read", this,
                      [this, seen = session().printed()](const Result<void>& done) {
                        if (!done) return;
                        std::uint64_t since = seen;
                        for (const std::string& line : session().linesSince(since)) {
                          const QString text = QString::fromStdString(line);
                          if (text.startsWith('>') || text.count(' ') < 10) continue;
                          lines_->appendPlainText(text.section(": ", -1));
                        }
                      });
  }

  QPlainTextEdit* lines_;
  QCheckBox* loop_;
};

const RegisterDialog<MofTester> registeredMofTester{
    {.id = "mof",
     .title = "Mof tester",
     .group = "Robots",
     .help = "Executes lines of a motion description, and reads the joints as such a line",
     .report = "J.5.4",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
