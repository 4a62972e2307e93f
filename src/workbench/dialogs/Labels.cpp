#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QProgressBar>
#include <QShortcut>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "base/File.h"
#include "labels/LabelEditor.h"
#include "labels/LabelScript.h"
#include "representations/infrastructure/Image.h"
#include "session/LabelEvaluation.h"
#include "workbench/Background.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/LabelErrorPlot.h"
#include "workbench/LabelSheet.h"
#include "workbench/SheetWidget.h"

namespace gt {
namespace {

/// The connected robot's image, and what its vision found in it.
struct SeenLabel {
  std::string log{}, played{};  ///< As it was named, and in our format.
  std::string robot{};
  Time position;  ///< Of the log player.
  std::size_t moment = 0;
  Image image{};
  SeenInImage percepts{};
};

template <typename T>
void copyValue(ObservedRobot& robot, T& value) {
  if (const auto known = robot.value<T>()) value = **known;
}

std::optional<SeenLabel> seenBy(Console& console) {
  for (ConsoleRobot* robot : console.selected()) {
    if (!robot->onLog()) continue;
    SeenLabel seen;
    const LogPlayer& player = robot->onLog()->player();
    seen.log = robot->onLog()->file();
    seen.played = player.path();
    seen.robot = robot->name();
    seen.position = player.now();
    seen.moment = player.position();
    ObservedRobot& observed = robot->observed();
    copyValue(observed, seen.image);
    copyValue(observed, seen.percepts.ball);
    copyValue(observed, seen.percepts.landmarks);
    copyValue(observed, seen.percepts.lines);
    copyValue(observed, seen.percepts.players);
    copyValue(observed, seen.percepts.matrix);
    return seen;
  }
  return std::nullopt;
}

/// Labels of a log's images, by hand, and how far vision is from them.
class Labels : public Dialog {
 public:
  explicit Labels(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    addTop(*layout);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts, 1);
    auto* upper = new QSplitter{Qt::Horizontal};
    parts->addWidget(upper);
    sheet_ = new SheetWidget;
    sheet_->setObjectName("image");
    sheet_->setCursor(Qt::CrossCursor);
    sheet_->showText("Let a robot run on a log, and connect it.");
    sheet_->drawn = [this](const QPointF& from, const QPointF& to, bool done) {
      draw(from, to, done);
    };
    upper->addWidget(sheet_);
    list_ = makeControl<QListWidget>("labels", "What is labeled in this image; Delete removes it");
    upper->addWidget(list_);
    upper->setStretchFactor(0, 4);
    upper->setStretchFactor(1, 1);
    auto* removed =
        new QShortcut{QKeySequence::Delete, list_, nullptr, nullptr, Qt::WidgetShortcut};
    QObject::connect(removed, &QShortcut::activated, this, [this] { removeChosen(); });
    auto* lower = new QWidget;
    parts->addWidget(lower);
    addErrors(*new QVBoxLayout{lower});
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    showState();
  }

  QJsonObject settings() const override {
    return {{"file", file_}, {"percepts", percepts_->isChecked()}, {"axis", axis_->currentIndex()}};
  }
  void restore(const QJsonObject& settings) override {
    percepts_->setChecked(settings["percepts"].toBool(true));
    axis_->setCurrentIndex(settings["axis"].toInt());
    const QString file = settings["file"].toString();
    if (!file.isEmpty() && file != file_ && !editor_.changed()) load(file);
  }
  std::optional<Unsaved> unsaved() override {
    if (!editor_.changed()) return std::nullopt;
    return Unsaved{"the labels of images", [this] { return save(); }};
  }

  void refresh() override {
    progress_->setVisible(comparing_.running() || indexing_.running());
    progress_->setValue(
        static_cast<int>(1000 * (comparing_.running() ? comparing_.share() : indexing_.share())));
    const std::uint64_t version = session().version();
    if (asked_ || version == version_) return;
    version_ = version;
    asked_ = true;
    session().ask(this, seenBy, [this](std::optional<SeenLabel>& seen) {
      asked_ = false;
      take(seen);
    });
  }

 private:
  void addTop(QVBoxLayout& layout) {
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    row->addWidget(new QLabel{"Image"});
    number_ = makeControl<QSpinBox>("number", "The image's number in the log, from 0");
    number_->setRange(-1, -1);
    number_->setSpecialValueText("–");
    number_->setKeyboardTracking(false);
    number_->setMinimumWidth(80);
    QObject::connect(number_, &QSpinBox::valueChanged, this, [this](int number) { goTo(number); });
    row->addWidget(number_);
    addButton(*row, *this, "nextLabeled", "Next labeled", "Goes to the next image with labels",
              [this] { goToLabeled(); });
    row->addWidget(new QLabel{"Mark"});
    tool_ = makeControl<QComboBox>(
        "tool",
        "What is marked: a ball from its middle to its rim, lines point by point, "
        "flags, goals and players from corner to corner, down to the ground");
    for (const LabelTool& tool : tools_) tool_->addItem(QString::fromStdString(tool.name));
    tool_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    tool_->setMinimumContentsLength(6);
    QObject::connect(tool_, &QComboBox::currentIndexChanged, this, [this] { editor_.endLine(); });
    row->addWidget(tool_, 1);
    addButton(*row, *this, "newLine", "New line", "The next point begins another line",
              [this] { editor_.endLine(); });
    addButton(*row, *this, "undo", "Undo", "Takes the last change back (Ctrl+Z)",
              [this] { undo(); });
    auto* undoing =
        new QShortcut{QKeySequence::Undo, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut};
    QObject::connect(undoing, &QShortcut::activated, this, [this] { undo(); });
    percepts_ =
        makeControl<QCheckBox>("percepts", "Shows what vision finds, too, in pink", "Percepts");
    percepts_->setChecked(true);
    QObject::connect(percepts_, &QCheckBox::toggled, this, [this] { paint(); });
    row->addWidget(percepts_);
    auto* files = new QHBoxLayout;
    layout.addLayout(files);
    addButton(*files, *this, "open", "Open…", "Reads labels: NAME-labels.csv, NAME-field.csv",
              [this] { open(); });
    addButton(*files, *this, "save", "Save", "Writes labels to where they were read from",
              [this] { save(); });
    addButton(*files, *this, "saveAs", "Save as…", "Writes labels to other files",
              [this] { saveAs(); });
    addButton(*files, *this, "test", "Save image as test…",
              "Writes a script that fails if vision does not find in this image what is labeled",
              [this] { saveTest(); });
    tolerance_ = makeControl<QDoubleSpinBox>("tolerance", "How far a ball may be off in a test");
    tolerance_->setRange(0.5, 100);
    tolerance_->setValue(4);
    tolerance_->setSuffix(" pixels");
    files->addWidget(tolerance_);
    state_ = new QLabel;
    state_->setObjectName("state");
    state_->setWordWrap(true);
    files->addStretch();
    layout.addWidget(state_);
  }

  void addErrors(QVBoxLayout& layout) {
    layout.setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    addButton(*row, *this, "compare", "Compare",
              "Replays the log, and compares what vision finds with all labels",
              [this] { compare(); });
    addButton(*row, *this, "stop", "Stop", "Shows what was compared so far",
              [this] { comparing_.stop(); });
    solution_ = makeControl<QComboBox>("solution", "Which ImageProcessor looks at the images");
    solution_->addItem("as recorded");
    const auto solutions = allSolutions();
    if (const auto known = solutions.find("ImageProcessor"); known != solutions.end())
      for (const std::string& name : known->second)
        solution_->addItem(QString::fromStdString(name));
    row->addWidget(solution_);
    axis_ = makeControl<QComboBox>("axis", "The horizontal axis of the errors below");
    axis_->addItems({"over time", "over distance"});
    QObject::connect(axis_, &QComboBox::currentIndexChanged, this,
                     [this](int axis) { plot_->setOverDistance(axis == 1); });
    row->addWidget(axis_);
    progress_ = new QProgressBar;
    progress_->setRange(0, 1000);
    progress_->setMaximumWidth(120);
    row->addWidget(progress_);
    addButton(*row, *this, "export", "Export…", "Writes all errors as a table (CSV)",
              [this] { exportErrors(); });
    row->addStretch();
    summary_ = new QLabel{"Differences in degrees, as seen from the camera; crosses: not found"};
    summary_->setObjectName("summary");
    summary_->setWordWrap(true);
    layout.addWidget(summary_);
    plot_ = new LabelErrorPlot;
    plot_->setObjectName("errors");
    plot_->clicked = [this](const LabelError& error) { goTo(error.picture); };
    layout.addWidget(plot_, 1);
  }

  // The image.

  void take(std::optional<SeenLabel>& seen) {
    seen_ = std::move(seen);
    picture_ = -1;
    if (!seen_) return sheet_->showText("Let a robot run on a log, and connect it.");
    if (std::exchange(indexed_, seen_->played) != seen_->played) index();
    if (seen_->image.pixels.empty())
      return sheet_->showText(
          "No image yet: choose one by its number. Logs hold images' pixels if they were "
          "recorded by log start, or by simgt play --inputs.");
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (images_[i].taken == seen_->image.time) picture_ = static_cast<int>(i);
    const QSignalBlocker quiet{number_};
    number_->setValue(picture_);
    paint();
  }

  /// Numbers the log's images.
  void index() {
    images_.clear();
    plot_->setErrors({});
    indexing_.start(
        this,
        [log = seen_->played](const Background::Progress& progress) {
          return imagesOf(log, progress);
        },
        [this](Result<std::vector<LoggedImage>>& images) {
          if (!images) return state_->setText(QString::fromStdString(images.error().text()));
          images_ = std::move(*images);
          const QSignalBlocker quiet{number_};
          number_->setMaximum(static_cast<int>(images_.size()) - 1);
          version_ = 0;
        });
  }

  void goTo(int picture) {
    if (!seen_ || picture < 0 || static_cast<std::size_t>(picture) >= images_.size()) return;
    const LoggedImage& image = images_[static_cast<std::size_t>(picture)];
    // Onward it is played; only elsewhere the robot begins anew.
    constexpr std::size_t mostSteps = 2000;
    const std::size_t steps = image.moment + 1 - std::min(seen_->moment, image.moment + 1);
    session().executeFor(seen_->robot, "lp pause");
    session().executeFor(seen_->robot, steps > 0 && steps < mostSteps
                                           ? "lp step " + std::to_string(steps)
                                           : "lp time " + std::to_string(image.played.ms / 1000.0));
  }
  void goToLabeled() {
    const ImageLabels& labels = editor_.labels();
    std::optional<int> next;
    const auto offer = [&](int picture) {
      if (picture > picture_ && (!next || picture < *next)) next = picture;
    };
    for (const auto& [picture, label] : labels.balls) offer(picture);
    for (const auto& [picture, label] : labels.fields) offer(picture);
    if (next) goTo(*next);
  }

  const LabelTool& tool() const { return tools_[static_cast<std::size_t>(tool_->currentIndex())]; }
  static Vector2d pixelAt(const QPointF& onSheet) {
    return Vector2d{onSheet.x(), onSheet.y()} / LabelSheet::zoom;
  }

  /// Shows the image with labels, percepts, and what is being drawn.
  void paint(const QPointF* from = nullptr, const QPointF* to = nullptr) {
    if (!seen_ || seen_->image.pixels.empty()) return;
    LabelSheet sheet{seen_->image};
    if (percepts_->isChecked()) sheet.addPercepts(seen_->percepts);
    sheet.addLabels(editor_.labels(), picture_);
    if (from) sheet.addUnfinished(tool(), pixelAt(*from), pixelAt(*to));
    sheet_->showText({});
    sheet_->showSheet(std::make_shared<const Sheet>(sheet.sheet()));
    showList();
  }

  // The labels.

  void draw(const QPointF& from, const QPointF& to, bool done) {
    if (!seen_ || picture_ < 0) return;
    if (!done) return paint(&from, &to);
    const Vector2d a = pixelAt(from), b = pixelAt(to);
    // A click alone makes neither a circle nor a rectangle.
    const LabelTool::Kind kind = tool().kind;
    const bool needsSize = kind == LabelTool::Kind::ball || kind == LabelTool::Kind::box;
    if (!needsSize || (b - a).norm() >= 1)
      editor_.draw(picture_, seen_->image.time.ms, tool(), a, b);
    showState();
    paint();
  }
  void undo() {
    editor_.undo();
    showState();
    paint();
  }
  void removeChosen() {
    if (!list_->currentItem()) return;
    editor_.remove(picture_, list_->currentItem()->text().toStdString());
    showState();
    paint();
  }

  void showList() {
    QStringList names;
    for (const std::string& name : editor_.names(picture_)) names << QString::fromStdString(name);
    QStringList shown;
    for (int i = 0; i < list_->count(); ++i) shown << list_->item(i)->text();
    if (names == shown) return;
    list_->clear();
    list_->addItems(names);
  }
  void showState() {
    const ImageLabels& labels = editor_.labels();
    state_->setText(QString{"%1%2: balls in %3 images, fields in %4"}
                        .arg(file_.isEmpty() ? "No file" : QFileInfo{file_}.fileName(),
                             editor_.changed() ? ", changed" : "")
                        .arg(labels.balls.size())
                        .arg(labels.fields.size()));
    showList();
  }

  /// The part of a file's name that both files have.
  static QString baseOf(QString file) {
    for (const char* end : {"-labels.csv", "-field.csv", ".csv"})
      if (file.endsWith(end)) return file.chopped(static_cast<qsizetype>(std::strlen(end)));
    return file;
  }
  void load(const QString& base) {
    auto labels = readImageLabels(base.toStdString());
    if (!labels) return state_->setText(QString::fromStdString(labels.error().text()));
    editor_.load(std::move(*labels));
    file_ = base;
    showState();
    paint();
  }
  void open() {
    if (editor_.changed() && !mayDiscard(this, {*unsaved()})) return;
    const QString file = QFileDialog::getOpenFileName(this, "Open labels", "out/labels",
                                                      "Labels (*-labels.csv *-field.csv)");
    if (!file.isEmpty()) load(baseOf(file));
  }
  bool save() { return file_.isEmpty() ? saveAs() : saveTo(file_); }
  bool saveAs() {
    const QString file = QFileDialog::getSaveFileName(
        this, "Save labels", "out/labels/log-labels.csv", "Labels (*-labels.csv)");
    return !file.isEmpty() && saveTo(baseOf(file));
  }
  bool saveTo(const QString& base) {
    QDir{}.mkpath(QFileInfo{base}.absolutePath());
    if (const auto done = writeImageLabels(base.toStdString(), editor_.labels()); !done) {
      QMessageBox::warning(this, "Save labels", QString::fromStdString(done.error().text()));
      return false;
    }
    file_ = base;
    editor_.saved();
    showState();
    return true;
  }

  /// A script for simgt console, which goes to this image of the log.
  void saveTest() {
    if (!seen_ || picture_ < 0 || editor_.names(picture_).empty())
      return state_->setText("Nothing is labeled in this image");
    const QString file = QFileDialog::getSaveFileName(this, "Save image as test",
                                                      "out/tests/image.con", "Scripts (*.con)");
    if (file.isEmpty()) return;
    QDir{}.mkpath(QFileInfo{file}.absolutePath());
    const auto done = writeFile(
        file.toStdString(),
        scriptOfLabels(
            editor_.labels(), picture_,
            QFileInfo{QString::fromStdString(seen_->log)}.absoluteFilePath().toStdString(),
            images_[static_cast<std::size_t>(picture_)].played, tolerance_->value()));
    state_->setText(done ? file + " is written" : QString::fromStdString(done.error().text()));
  }
  // The errors.

  void compare() {
    if (!seen_ || comparing_.running()) return;
    if (editor_.labels().empty()) return summary_->setText("There are no labels");
    ComparedRun run{seen_->log, true};
    if (solution_->currentIndex() > 0) {
      run.task = "ImageProcessor";
      run.solution = solution_->currentText().toStdString();
    }
    session().ask(
        this, [](Console& console) { return console.session().logOptions(); },
        [this, run](const LogRobotOptions& options) {
          summary_->setText("Comparing…");
          comparing_.start(
              this,
              [run, labels = editor_.labels(), options](const Background::Progress& progress) {
                return compareWithLabels(run, labels, options, progress);
              },
              [this](Result<std::vector<LabelError>>& errors) {
                if (!errors)
                  return summary_->setText(QString::fromStdString(errors.error().text()));
                showErrors(std::move(*errors));
              });
        });
  }

  void showErrors(std::vector<LabelError> errors) {
    plot_->setErrors(std::move(errors));
    const QString summary = plot_->summary();
    if (!summary.isEmpty()) summary_->setText(summary + " (crosses: not found, or false)");
  }
  void exportErrors() {
    const QString file =
        QFileDialog::getSaveFileName(this, "Export", "out/labels/errors.csv", "Tables (*.csv)");
    if (file.isEmpty()) return;
    if (const auto done = plot_->exportTo(file.toStdString()); !done)
      summary_->setText(QString::fromStdString(done.error().text()));
  }

  const std::vector<LabelTool> tools_ = labelTools();
  QSpinBox* number_;
  QComboBox* tool_;
  QCheckBox* percepts_;
  QDoubleSpinBox* tolerance_;
  QLabel* state_;
  SheetWidget* sheet_;
  QListWidget* list_;
  QComboBox* solution_;
  QComboBox* axis_;
  QProgressBar* progress_;
  QLabel* summary_;
  LabelErrorPlot* plot_;
  LabelEditor editor_;
  QString file_;  ///< Without what both files' names end with; empty: none.
  std::optional<SeenLabel> seen_;
  std::vector<LoggedImage> images_;
  std::string indexed_;  ///< The log that they are of.
  int picture_ = -1;     ///< That is shown.
  bool asked_ = false;
  std::uint64_t version_ = 0;
  Background indexing_, comparing_;
};

const RegisterDialog<Labels> registeredLabels{
    {.id = "labels",
     .title = "Labels",
     .group = "Session",
     .help = "Marks what can be seen in the images of a log, and shows how far vision is from it",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
