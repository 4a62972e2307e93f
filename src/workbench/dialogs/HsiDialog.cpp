#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QSlider>
#include <QVBoxLayout>
#include <array>
#include <optional>

#include "base/File.h"
#include "colors/ColorTableFile.h"
#include "colors/HsiEditor.h"
#include "views/painting/ColorClassViews.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/ImageSource.h"
#include "workbench/SendToRobots.h"
#include "workbench/SheetWidget.h"

namespace gt {
namespace {

constexpr std::size_t imageCount = 4;
constexpr int zoom = 4;
constexpr std::array hsiChannels{"Hue", "Saturation", "Intensity"};
constexpr std::array hsiHighest{360, 100, 100};

void showImage(SheetWidget& sheet, const Image& image, int scale) {
  sheet.showSheet(std::make_shared<const Sheet>(imageSheet(image, scale)));
}
void showClasses(SheetWidget& sheet, const Image& image, const ColorTable64& table, int scale) {
  sheet.showSheet(std::make_shared<const Sheet>(pictureSheet(classesOf(image, table), scale)));
}

/// Report J.6.2: color classes as sectors of the HSI space, by sliders, or by clicking on pixels of
/// the zoomed image: the left button grows the class, the right one shrinks it.
class HsiDialog : public Dialog {
 public:
  explicit HsiDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* grid = new QGridLayout;
    layout->addLayout(grid, 1);
    for (std::size_t i = 0; i < imageCount; ++i) addImage(*grid, i);
    addControls(*layout);
    auto* zoomed = new QHBoxLayout;
    layout->addLayout(zoomed, 2);
    for (SheetWidget** sheet : {&zoomedImage_, &zoomedClasses_}) {
      *sheet = new SheetWidget;
      (*sheet)->setCursor(Qt::CrossCursor);
      (*sheet)->clicked = [this](const QPointF& at, Qt::MouseButton button) { click(at, button); };
      zoomed->addWidget(*sheet);
    }
    zoomedImage_->setObjectName("zoom");
    zoomedClasses_->setObjectName("zoomClasses");
    zoomedImage_->showText("A click on an image shows it here.");
    showSliders();
  }

  void refresh() override { source_.refresh(); }
  std::optional<Unsaved> unsaved() override {
    if (!changed_) return std::nullopt;
    return Unsaved{"the HSI colors", [this] { return save(); }};
  }

 private:
  struct Slot {
    SheetWidget* image = nullptr;
    SheetWidget* classes = nullptr;
    std::optional<Image> taken;
  };

  void addImage(QGridLayout& grid, std::size_t i) {
    const int column = static_cast<int>(i);
    Slot& slot = slots_[i];
    slot.image = new SheetWidget;
    slot.image->setObjectName(QString{"image%1"}.arg(i + 1));
    slot.image->setToolTip("A click zooms");
    slot.image->clicked = [this, i](const QPointF&, Qt::MouseButton) {
      zoomed_ = i;
      showZoom();
    };
    slot.classes = new SheetWidget;
    grid.addWidget(slot.image, 0, column);
    grid.addWidget(slot.classes, 1, column);
    auto* row = new QHBoxLayout;
    grid.addLayout(row, 2, column);
    const QString name = QString{"capture%1"}.arg(i + 1);
    addButton(*row, *this, name.toLatin1(), "Capture", "Takes the robot's image of now", [this, i] {
      if (newest_) take(i, *newest_);
    });
    if (i > 0) return;
    update_ = makeControl<QCheckBox>("update", "Shows the robot's images as they come", "Update");
    update_->setChecked(true);
    row->addWidget(update_);
  }
  void addControls(QBoxLayout& layout) {
    auto* grid = new QGridLayout;
    layout.addLayout(grid);
    class_ = makeControl<QComboBox>("class", "The class that is edited");
    for (std::size_t i = 1; i < enumCount<ColorClass>; ++i)
      class_->addItem(QString::fromStdString(std::string{enumNames<ColorClass>[i]}));
    QObject::connect(class_, &QComboBox::currentIndexChanged, this, [this] { showSliders(); });
    grid->addWidget(class_, 0, 0);
    for (std::size_t i = 0; i < sliders_.size(); ++i) {
      auto* slider = sliders_[i] = new QSlider{Qt::Horizontal};
      const QString channel = hsiChannels[i / 2];
      slider->setObjectName((i % 2 ? "max" : "min") + channel);
      slider->setRange(0, hsiHighest[i / 2]);
      slider->setToolTip((i % 2 ? "Largest " : "Smallest ") + channel.toLower());
      QObject::connect(slider, &QSlider::valueChanged, this, [this] { takeSliders(); });
      const int row = static_cast<int>(i / 2), column = static_cast<int>(i % 2);
      if (column == 0) grid->addWidget(new QLabel{channel}, row, 1);
      grid->addWidget(slider, row, 2 + column);
    }
    auto* buttons = new QHBoxLayout;
    layout.addLayout(buttons);
    addButton(*buttons, *this, "undo", "Undo", "Takes the last change back", [this] {
      if (editor_.undo()) changed();
    });
    addButton(*buttons, *this, "send", "Send",
              "Sends the classes to the connected robots as a color table",
              [this] { sendToRobots(this->session(), table_, "The color table"); });
    addButton(*buttons, *this, "load", "Load…", "Reads classes (.hsi)", [this] { load(); });
    addButton(*buttons, *this, "save", "Save…",
              "Writes the classes (.hsi), and the table of the same name (.c64)",
              [this] { save(); });
  }

  ColorClass chosen() const { return static_cast<ColorClass>(class_->currentIndex() + 1); }

  void take(std::size_t i, const Image& image) {
    Slot& slot = slots_[i];
    slot.taken = image;
    showImage(*slot.image, image, 1);
    showClasses(*slot.classes, image, table_, 1);
    if (zoomed_ == i) showZoom();
  }
  void showZoom() {
    if (!zoomed_ || !slots_[*zoomed_].taken) return;
    showImage(*zoomedImage_, *slots_[*zoomed_].taken, zoom);
    showClasses(*zoomedClasses_, *slots_[*zoomed_].taken, table_, zoom);
  }
  void click(const QPointF& at, Qt::MouseButton button) {
    if (!zoomed_ || !slots_[*zoomed_].taken || at.x() < 0 || at.y() < 0) return;
    const Image& image = *slots_[*zoomed_].taken;
    const int x = static_cast<int>(at.x()) / zoom, y = static_cast<int>(at.y()) / zoom;
    if (x >= image.info.width || y >= image.info.height) return;
    // Whoever clicks on an image wants it to stay.
    if (*zoomed_ == 0) update_->setChecked(false);
    if (button == Qt::LeftButton)
      editor_.include(chosen(), image.at(x, y));
    else if (button == Qt::RightButton)
      editor_.exclude(chosen(), image.at(x, y));
    changed();
  }

  void showSliders() {
    const HsiRange& range = editor_.colors().ranges[chosen()];
    const std::array ranges{range.hue, range.saturation, range.intensity};
    for (std::size_t i = 0; i < sliders_.size(); ++i) {
      const QSignalBlocker quiet{sliders_[i]};
      sliders_[i]->setValue(ranges[i / 2][i % 2]);
    }
  }
  void takeSliders() {
    const auto range = [&](std::size_t i) {
      return ColorRange{sliders_[i]->value(), sliders_[i + 1]->value()};
    };
    HsiRange edited;
    edited.hue = range(0);
    edited.saturation = range(2);
    edited.intensity = range(4);
    editor_.setRange(chosen(), edited);
    changed();
  }
  void changed() {
    changed_ = true;
    table_ = editor_.colors().table();
    showSliders();
    for (Slot& slot : slots_)
      if (slot.taken) showClasses(*slot.classes, *slot.taken, table_, 1);
    showZoom();
  }

  void load() {
    const QString file = QFileDialog::getOpenFileName(this, "Load", "config", "HSI colors (*.hsi)");
    if (file.isEmpty()) return;
    const auto read = readHsiColors(file.toStdString());
    if (!read) return report(read.error());
    editor_ = HsiEditor{*read};
    changed();
    changed_ = false;
  }
  bool save() {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save", "colors.hsi", "HSI colors (*.hsi)");
    if (file.isEmpty()) return false;
    const QFileInfo place{file};
    const QString stem = place.path() + "/" + place.completeBaseName();
    auto done = writeFile((stem + ".hsi").toStdString(), hsiText(editor_.colors()));
    if (done) done = writeFile((stem + ".c64").toStdString(), colorTableBytes(table_));
    if (!done) report(done.error());
    if (done) changed_ = false;
    return static_cast<bool>(done);
  }
  void report(const Error& error) {
    QMessageBox::warning(this, "HSI", QString::fromStdString(error.text()));
  }

  std::array<Slot, imageCount> slots_;
  QCheckBox* update_ = nullptr;
  QComboBox* class_;
  std::array<QSlider*, 6> sliders_{};
  SheetWidget* zoomedImage_;
  SheetWidget* zoomedClasses_;
  std::optional<std::size_t> zoomed_;
  HsiEditor editor_;
  ColorTable64 table_;
  bool changed_ = false;
  std::optional<Image> newest_;
  ImageSource source_{session(), *this, [this](Image image) {
                        newest_ = std::move(image);
                        if (update_->isChecked() || !slots_[0].taken) take(0, *newest_);
                      }};
};

const RegisterDialog<HsiDialog> registeredHsiDialog{
    {.id = "hsi",
     .title = "HSI",
     .group = "Colors",
     .help = "Color classes as sectors of hue, saturation and intensity",
     .report = "J.6.2",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
