#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <optional>

#include "base/File.h"
#include "colors/ColorTableEditor.h"
#include "colors/ColorTableFile.h"
#include "views/painting/ColorClassViews.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/SendToRobots.h"
#include "workbench/SheetWidget.h"

namespace gt {
namespace {

constexpr int interval = 200;  // ms
constexpr int enlarged = 4;

/// An image of the connected robot, and its color table if that was asked for.
struct Seen {
  std::optional<Image> image;
  std::optional<ColorTable64> table;
};

Seen lookAt(Console& console, bool table) {
  Seen seen;
  const auto first = console.firstRobot();
  if (!first) return seen;
  ObservedRobot& robot = (*first)->observed();
  if (const auto image = robot.value<Image>(); image && !(*image)->pixels.empty())
    seen.image = **image;
  if (table)
    if (const auto known = robot.value<ColorTable64>()) seen.table = **known;
  return seen;
}

/// Report J.6.1: makes a color table by clicking on images. The left button gives the color of a
/// pixel the chosen class, the right one takes its class.
class ColorTableDialog : public Dialog {
 public:
  explicit ColorTableDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* grid = new QGridLayout;
    layout->addLayout(grid);
    class_ = makeControl<QComboBox>("class", "The class that the left button gives");
    for (const std::string_view name : enumNames<ColorClass>)
      class_->addItem(QString::fromStdString(std::string{name}));
    class_->setCurrentIndex(static_cast<int>(ColorClass::orange));
    grid->addWidget(class_, 0, 0);
    const auto button = [&](const char* name, const char* text, const char* help, int row,
                            int column, auto pressed) {
      auto* made = makeControl<QPushButton>(name, help, text);
      QObject::connect(made, &QPushButton::clicked, this, pressed);
      grid->addWidget(made, row, column);
    };
    const auto edit = [this](auto change) {
      return [this, change] {
        change();
        changed_ = started_ = true;
        showClasses();
      };
    };
    button("undo", "Undo", "Takes the last step back", 0, 1, edit([this] { editor_.undo(); }));
    button("clear", "Clear class", "Removes all colors from the chosen class", 0, 2,
           edit([this] { editor_.clear(chosen()); }));
    button("reset", "Reset", "Removes the class of every color", 0, 3,
           edit([this] { editor_.reset(); }));
    button("remove", "Remove", "Removes colors that have none of their class near", 1, 0,
           edit([this] { editor_.removeIsolated(selected()); }));
    button("median", "Median", "Adds colors that have enough of the class near", 1, 1,
           edit([this] { editor_.median(rule(), selected()); }));
    neighbors_ = spin("neighbors", 1, 26, 6, "neighbors ", "So many colors of the class are near");
    distance_ = spin("distance", 1, 8, 1, "distance ", "How far away those may be");
    grid->addWidget(neighbors_, 1, 2);
    grid->addWidget(distance_, 1, 3);
    all_ = check(*grid, "allColors", "All colors", "Filters work on all classes", 2, 0);
    reassign_ = check(*grid, "reassign", "Allow reassign",
                      "The median may change colors that have a class", 2, 1);
    autoRemove_ = check(*grid, "autoRemove", "Auto remove", "Removes with each image", 2, 2);
    autoMedian_ = check(*grid, "autoMedian", "Auto median", "Adds with each image", 2, 3);
    button("fromRobot", "From robot", "Goes on from the robot's color table", 3, 0,
           [this] { started_ = false; });
    button("send", "Send", "Sends the table to the connected robots, which use it at once", 3, 1,
           [this] { sendToRobots(this->session(), editor_.table(), "The color table"); });
    button("open", "Open…", "Reads a color table (.c64)", 3, 2, [this] {
      const QString file = QFileDialog::getOpenFileName(this, "Open", "config", "Tables (*.c64)");
      if (!file.isEmpty()) report(open(file.toStdString()));
    });
    button("save", "Save…", "Writes the color table (.c64)", 3, 3, [this] { save(); });
    hold_ = check(*grid, "hold", "Hold the image", "Keeps the image that is shown", 4, 0);
    image_ = new SheetWidget;
    image_->setObjectName("image");
    classes_ = new SheetWidget;
    classes_->setObjectName("classes");
    auto* images = new QHBoxLayout;
    layout->addLayout(images, 1);
    for (SheetWidget* sheet : {image_, classes_}) {
      sheet->clicked = [this](const QPointF& at, Qt::MouseButton pressed) { click(at, pressed); };
      sheet->setCursor(Qt::CrossCursor);
      images->addWidget(sheet);
    }
    classes_->setToolTip("The image by the classes of this table");
  }

  std::optional<Unsaved> unsaved() override {
    if (!changed_) return std::nullopt;
    return Unsaved{"the color table", [this] { return save(); }};
  }

  void refresh() override {
    if (asked_ || (hold_->isChecked() && started_ && seen_)) return;
    if (clock_.isValid() && clock_.elapsed() < interval) return;
    if (started_ && seen_ && session().version() == version_) return;
    version_ = session().version();
    clock_.start();
    asked_ = true;
    session().ask(
        this, [table = !started_](Console& console) { return lookAt(console, table); },
        [this](Seen& seen) { take(std::move(seen)); });
  }

 private:
  QSpinBox* spin(const char* name, int low, int high, int value, const char* text,
                 const char* help) {
    auto* made = makeControl<QSpinBox>(name, help);
    made->setRange(low, high);
    made->setValue(value);
    made->setPrefix(text);
    return made;
  }
  QCheckBox* check(QGridLayout& grid, const char* name, const char* text, const char* help, int row,
                   int column) {
    auto* made = makeControl<QCheckBox>(name, help, text);
    grid.addWidget(made, row, column);
    return made;
  }
  ColorClass chosen() const { return static_cast<ColorClass>(class_->currentIndex()); }
  std::optional<ColorClass> selected() const {
    return all_->isChecked() ? std::nullopt : std::optional{chosen()};
  }
  MedianRule rule() const {
    return {neighbors_->value(), distance_->value(), reassign_->isChecked()};
  }
  void report(const Result<void>& done) {
    if (!done)
      QMessageBox::warning(this, "Color table", QString::fromStdString(done.error().text()));
  }

  bool save() {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save", "coltable.c64", "Tables (*.c64)");
    if (file.isEmpty()) return false;
    const auto done = writeFile(file.toStdString(), colorTableBytes(editor_.table()));
    report(done);
    if (done) changed_ = false;
    return static_cast<bool>(done);
  }

  Result<void> open(const std::string& file) {
    const auto table = readColorTable(file);
    if (!table) return table.error();
    editor_ = ColorTableEditor{*table};
    started_ = true;
    changed_ = false;
    showClasses();
    return {};
  }

  void take(Seen seen) {
    asked_ = false;
    if (seen.table && !started_) {
      editor_ = ColorTableEditor{*seen.table};
      started_ = true;
      changed_ = false;
    }
    if (seen.image && !(hold_->isChecked() && seen_)) {
      seen_ = std::move(seen.image);
      image_->showSheet(std::make_shared<const Sheet>(imageSheet(*seen_, enlarged)));
      if (autoRemove_->isChecked() || autoMedian_->isChecked()) {
        editor_.onPicture({autoRemove_->isChecked(), autoMedian_->isChecked(), selected(), rule()});
        changed_ = true;
      }
    }
    if (!seen_) image_->showText("The connected robot has no image yet.");
    showClasses();
  }

  void showClasses() {
    if (seen_)
      classes_->showSheet(std::make_shared<const Sheet>(
          pictureSheet(classesOf(*seen_, editor_.table()), enlarged)));
  }

  void click(const QPointF& at, Qt::MouseButton pressed) {
    const int x = static_cast<int>(at.x()) / enlarged, y = static_cast<int>(at.y()) / enlarged;
    if (!seen_ || at.x() < 0 || at.y() < 0 || x >= seen_->info.width || y >= seen_->info.height)
      return;
    changed_ = started_ = true;
    if (pressed == Qt::LeftButton)
      editor_.set(seen_->at(x, y), chosen());
    else if (pressed == Qt::RightButton)
      editor_.remove(seen_->at(x, y));
    showClasses();
  }

  QComboBox* class_;
  QSpinBox* neighbors_;
  QSpinBox* distance_;
  QCheckBox* all_;
  QCheckBox* reassign_;
  QCheckBox* autoRemove_;
  QCheckBox* autoMedian_;
  QCheckBox* hold_;
  SheetWidget* image_;
  SheetWidget* classes_;
  ColorTableEditor editor_;
  std::optional<Image> seen_;
  bool started_ = false, asked_ = false;  ///< Started: the robot's table is not waited for.
  bool changed_ = false;                  ///< Since the table was read or saved.
  std::uint64_t version_ = 0;
  QElapsedTimer clock_;
};

const RegisterDialog<ColorTableDialog> registeredColorTableDialog{
    {.id = "colorTable",
     .title = "Color table",
     .group = "Colors",
     .help = "Makes a color table by clicking on images of the robot",
     .report = "J.6.1",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
