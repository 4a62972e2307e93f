#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "simulation/scene/Scene.h"
#include "workbench/Background.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int pause = 400;  ///< ms without a key before the text is checked.

std::string fileNameOf(const std::string& file) {
  return std::filesystem::path{file}.filename().string();
}

/// The errors in a text as the scene of a file, to which the text need not be written yet. They
/// name the file without its folder.
std::vector<Error> errorsIn(const std::string& file, const std::string& text) {
  const TemporaryFolder folder;
  const std::string copy = (folder.path() / "checked.scene").string();
  if (const auto done = writeFile(copy, text); !done) return {done.error()};
  std::vector<Error> errors;
  SceneDescription scene = loadScene(copy, errors);
  scene.file = file;
  findSceneFiles(scene, errors);
  for (Error& error : errors)
    if (error.file == copy || error.file == file) error.file = fileNameOf(file);
  return errors;
}

/// Report 5.1.2: a scene's text, with what is wrong with it at its place; the simulation begins
/// with it.
class SceneEditor : public Dialog {
 public:
  explicit SceneEditor(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    const auto button = [&](auto... what) { addButton(*row, *this, what...); };
    button("open", "Open…", "Opens a scene", [this] { chooseFile(); });
    button("current", "Current", "Opens a copy of the scene that is simulated",
           [this] { open(QString::fromStdString(this->session().status().scene), true); });
    button("save", "Save", "Writes the scene", [this] { save(); });
    button("saveAs", "Save as…", "Writes the scene to another file", [this] { saveAs(); });
    button("begin", "Begin", "Writes the scene, and begins the simulation anew with it",
           [this] { begin(); });
    state_ = new QLabel;
    state_->setObjectName("state");
    row->addWidget(state_, 1);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts, 1);
    text_ = new QPlainTextEdit;
    text_->setObjectName("text");
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    text_->setPlaceholderText("A scene (scenes/scene.xsd): who stands where");
    QObject::connect(text_, &QPlainTextEdit::textChanged, this, [this] {
      typed_.start();
      showState();
    });
    parts->addWidget(text_);
    errors_ = makeControl<QListWidget>("errors", "What is wrong; a click goes there");
    QObject::connect(errors_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
      goTo(item->data(Qt::UserRole).toPoint());
    });
    parts->addWidget(errors_);
    parts->setStretchFactor(0, 4);
    parts->setStretchFactor(1, 1);
    showState();
  }

  QJsonObject settings() const override { return {{"file", file_}, {"copy", isCopy_}}; }
  void restore(const QJsonObject& settings) override {
    const QString file = settings["file"].toString();
    if (!file.isEmpty() && file != file_ && !text_->document()->isModified())
      open(file, settings["copy"].toBool());
  }
  std::optional<Unsaved> unsaved() override {
    if (!text_->document()->isModified()) return std::nullopt;
    return Unsaved{"the scene", [this] { return save(); }};
  }
  void refresh() override {
    if (!typed_.isValid() || typed_.elapsed() < pause || checking_.running()) return;
    typed_.invalidate();
    if (file_.isEmpty()) return;
    checking_.start(
        this,
        [file = file_.toStdString(), text = text_->toPlainText().toStdString()](
            const Background::Progress&) { return errorsIn(file, text); },
        [this](const std::vector<Error>& errors) { showErrors(errors); });
  }

 private:
  void showState() {
    state_->setText(file_.isEmpty() ? "No scene"
                                    : QFileInfo{file_}.fileName() + (isCopy_ ? ", a copy" : "") +
                                          (text_->document()->isModified() ? ", changed" : ""));
    state_->setToolTip(file_);
  }
  void showErrors(const std::vector<Error>& errors) {
    errors_->clear();
    QList<QTextEdit::ExtraSelection> marks;
    for (const Error& error : errors) {
      auto* item = new QListWidgetItem{QString::fromStdString(error.text())};
      errors_->addItem(item);
      if (error.file != fileNameOf(file_.toStdString())) continue;
      item->setData(Qt::UserRole, QPoint{error.column, error.line});
      const QTextBlock line = text_->document()->findBlockByNumber(error.line - 1);
      if (!line.isValid()) continue;
      QTextEdit::ExtraSelection mark;
      mark.cursor = QTextCursor{line};
      constexpr QColor wrong{0xe0, 0x40, 0x30, 70};
      mark.format.setBackground(wrong);
      mark.format.setProperty(QTextFormat::FullWidthSelection, true);
      marks << mark;
    }
    text_->setExtraSelections(marks);
    if (errors.empty()) errors_->addItem("Nothing is wrong");
  }
  /// Puts the cursor to a column and line.
  void goTo(const QPoint& place) {
    const QTextBlock block = text_->document()->findBlockByNumber(place.y() - 1);
    if (!block.isValid()) return;
    QTextCursor cursor{block};
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor,
                        std::clamp(place.x() - 1, 0, block.length() - 1));
    text_->setTextCursor(cursor);
    text_->centerCursor();
    text_->setFocus();
  }

  bool mayClose() {
    const auto lost = unsaved();
    return !lost || mayDiscard(this, {*lost});
  }
  void chooseFile() {
    const QString file =
        QFileDialog::getOpenFileName(this, "Open a scene", "scenes", "Scenes (*.scene)");
    if (!file.isEmpty()) open(file, false);
  }
  void open(const QString& file, bool asCopy) {
    if (!mayClose()) return;
    const auto text = readFile(file.toStdString());
    if (!text) return state_->setText(QString::fromStdString(text.error().text()));
    file_ = file;
    isCopy_ = asCopy;
    text_->setPlainText(QString::fromStdString(*text));
    text_->document()->setModified(false);
    showState();
  }
  bool save() { return file_.isEmpty() || isCopy_ ? saveAs() : saveTo(file_); }
  bool saveAs() {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save the scene", file_, "Scenes (*.scene)");
    return !file.isEmpty() && saveTo(file);
  }
  bool saveTo(const QString& file) {
    const auto done = writeFile(file.toStdString(), text_->toPlainText().toStdString());
    if (!done) {
      QMessageBox::warning(this, "Save the scene", QString::fromStdString(done.error().text()));
      return false;
    }
    file_ = file;
    isCopy_ = false;
    text_->document()->setModified(false);
    typed_.start();  // what the scene names lies elsewhere now
    showState();
    return true;
  }
  void begin() {
    if (text_->document()->isEmpty() || !save()) return;
    session().execute("scene \"" + file_.toStdString() + "\"", this,
                      [this](const Result<void>& done) {
                        state_->setText(done ? QFileInfo{file_}.fileName() + " is simulated"
                                             : QString::fromStdString(done.error().text()));
                      });
  }

  QLabel* state_;
  QPlainTextEdit* text_;
  QListWidget* errors_;
  QString file_;
  bool isCopy_ = false;  ///< The file is not written without asking.
  QElapsedTimer typed_;  ///< Since the last change that was not checked.
  Background checking_;
};

const RegisterDialog<SceneEditor> registeredSceneEditor{
    {.id = "sceneEditor",
     .title = "Scene editor",
     .group = "Simulator",
     .help = "The text of a scene, with errors at their place; begins the simulation with it",
     .report = "5.1.2",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
