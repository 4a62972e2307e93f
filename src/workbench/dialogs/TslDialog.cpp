#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QSlider>
#include <QVBoxLayout>
#include <array>
#include <optional>

#include "base/File.h"
#include "colors/ClassColors.h"
#include "colors/ColorTableFile.h"
#include "colors/TslColors.h"
#include "colors/TslHistogram.h"
#include "views/painting/ColorClassViews.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/ImageSource.h"
#include "workbench/PlotColors.h"
#include "workbench/SendToRobots.h"
#include "workbench/SheetWidget.h"

namespace gt {
namespace {

constexpr int tslEnlarged = 2;
constexpr int mostNoise = 60;  // standard deviation of each channel's value
constexpr std::array channels{"T'", "S'", "L'"};

/// Report J.6.3: classes by thresholds in the TSL space. Two clicks on the raw image span a
/// rectangle, from whose histograms the thresholds follow.
class TslDialog : public Dialog {
 public:
  explicit TslDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QHBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* images = new QVBoxLayout;
    layout->addLayout(images, 1);
    raw_ = makeControl<SheetWidget>("raw", "Two clicks span a rectangle of the chosen color");
    raw_->setCursor(Qt::CrossCursor);
    raw_->clicked = [this](const QPointF& at, Qt::MouseButton) { click(at); };
    classified_ = new SheetWidget;
    classified_->setObjectName("classified");
    images->addWidget(raw_);
    images->addWidget(classified_);
    auto* right = new QVBoxLayout;
    layout->addLayout(right, 1);
    color_ = makeControl<QComboBox>("color", "Select color: the class that is edited");
    for (std::size_t i = 1; i < enumCount<ColorClass>; ++i)
      color_->addItem(QString::fromStdString(std::string{enumNames<ColorClass>[i]}));
    QObject::connect(color_, &QComboBox::currentIndexChanged, this, [this] { showSliders(); });
    right->addWidget(color_);
    addPlot(*right);
    addSliders(*right);
    addOrder(*right);
    addFileButtons(*right);
    showSliders();
  }

  void refresh() override { source_.refresh(); }
  std::optional<Unsaved> unsaved() override {
    if (!changed_) return std::nullopt;
    return Unsaved{"the TSL colors", [this] { return save(false); }};
  }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::PaletteChange && plot_) setPlotColors(*plot_, palette());
    Dialog::changeEvent(event);
  }

 private:
  void addPlot(QBoxLayout& layout) {
    plot_ = new QCustomPlot;
    plot_->setMinimumHeight(90);
    plot_->xAxis->setRange(0, 255);
    plot_->legend->setVisible(true);
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);  // in one row
    keepLegendInside(*plot_);
    for (std::size_t i = 0; i < channels.size(); ++i) {
      plot_->addGraph()->setName(channels[i]);
      plot_->graph()->setPen(
          QPen{std::array{QColor{200, 60, 160}, QColor{40, 140, 60}, QColor{90, 90, 100}}[i]});
    }
    setPlotColors(*plot_, palette());
    layout.addWidget(plot_, 1);
  }
  void addSliders(QBoxLayout& layout) {
    auto* grid = new QGridLayout;
    layout.addLayout(grid);
    for (std::size_t i = 0; i < sliders_.size(); ++i) {
      auto* slider = sliders_[i] = makeControl<QSlider>(
          QString{"t%1"}.arg(i + 1),
          QString{"%1 of %2"}.arg(i % 2 ? "Maximum" : "Minimum", channels[i / 2]), Qt::Horizontal);
      slider->setRange(0, 255);
      QObject::connect(slider, &QSlider::valueChanged, this, [this] { takeSliders(); });
      const int row = static_cast<int>(i / 2), column = static_cast<int>(i % 2);
      if (column == 0) grid->addWidget(new QLabel{channels[i / 2]}, row, 0);
      grid->addWidget(slider, row, 1 + column);
    }
    auto* noise = makeControl<QSlider>(
        "noise", "Noise on the raw image: how robust the classes are", Qt::Horizontal);
    noise->setRange(0, mostNoise);
    QObject::connect(noise, &QSlider::valueChanged, this, [this](int value) {
      noise_ = value;
      showImages();
    });
    grid->addWidget(new QLabel{"Noise"}, 3, 0);
    grid->addWidget(noise, 3, 1, 1, 2);
  }
  void addOrder(QBoxLayout& layout) {
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    order_ =
        makeControl<QListWidget>("order", "TSL order: where classes overlap, the upper one counts");
    order_->setMaximumHeight(110);
    row->addWidget(order_, 1);
    auto* buttons = new QVBoxLayout;
    row->addLayout(buttons);
    const auto move = [this](auto change) {
      return [this, change] {
        if (const auto* item = order_->currentItem()) {
          const auto chosen = enumValue<ColorClass>(item->text().toStdString());
          if (chosen) change(colors_, *chosen);
          changed();
        }
      };
    };
    addButton(*buttons, *this, "up", "Up", "Moves the class up",
              move([](TslColors& colors, ColorClass chosen) { colors.moveUp(chosen); }));
    addButton(*buttons, *this, "down", "Down", "Moves the class down",
              move([](TslColors& colors, ColorClass chosen) { colors.moveDown(chosen); }));
    addButton(*buttons, *this, "auto", "Auto", "Thresholds from what was selected",
              [this] { takeHistogram(); });
  }
  void addFileButtons(QBoxLayout& layout) {
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    addButton(*row, *this, "load", "Load…", "Reads classes (.tsl)", [this] { load(); });
    addButton(*row, *this, "save", "Save…", "Writes the classes (.tsl)", [this] { save(false); });
    addButton(*row, *this, "saveYuv", "Save YUV…", "Writes the classes as table (.c64)",
              [this] { save(true); });
    addButton(*row, *this, "send", "Send",
              "Sends the classes to the connected robots, as table and as thresholds", [this] {
                sendToRobots(this->session(), colors_, "The TSL colors");
                sendToRobots(this->session(), colors_.table(), "The color table");
              });
  }

  ColorClass chosen() const { return static_cast<ColorClass>(color_->currentIndex() + 1); }

  void click(const QPointF& at) {
    if (!image_) return;
    const QPoint place{static_cast<int>(at.x()) / tslEnlarged,
                       static_cast<int>(at.y()) / tslEnlarged};
    if (!corner_) {
      corner_ = place;
      return;
    }
    const QRect span = QRect{*corner_, place}.normalized();
    corner_.reset();
    histogram_ = {};
    histogram_.add(*image_, {span.left(), span.top(), span.right(), span.bottom()});
    showHistogram();
  }
  void takeHistogram() {
    if (histogram_.luminance().total() == 0) return;
    TslThresholds found = histogram_.thresholds();
    const TslThresholds& before = colors_.classes[chosen()];
    found.priority = before.empty() ? static_cast<int>(colors_.order().size()) : before.priority;
    colors_.classes[chosen()] = found;
    showSliders();
    changed();
  }
  void showHistogram() {
    const std::array found{&histogram_.tint(), &histogram_.saturation(), &histogram_.luminance()};
    double most = 1;
    for (std::size_t i = 0; i < found.size(); ++i) {
      QVector<double> values, counts;
      for (std::size_t value = 0; value < found[i]->counts().size(); ++value) {
        values << static_cast<double>(value);
        counts << static_cast<double>(found[i]->counts()[value]);
        most = std::max(most, counts.back());
      }
      plot_->graph(static_cast<int>(i))->setData(values, counts, true);
    }
    plot_->yAxis->setRange(0, most);
    plot_->replot();
  }

  void showSliders() {
    const TslThresholds& shown = colors_.classes[chosen()];
    const std::array ranges{shown.tint, shown.saturation, shown.luminance};
    for (std::size_t i = 0; i < sliders_.size(); ++i) {
      const QSignalBlocker quiet{sliders_[i]};
      sliders_[i]->setValue(ranges[i / 2][i % 2]);
    }
  }
  void takeSliders() {
    TslThresholds& edited = colors_.classes[chosen()];
    if (edited.empty()) edited.priority = static_cast<int>(colors_.order().size());
    for (const auto& [range, first] : {std::pair{&edited.tint, std::size_t{0}},
                                       {&edited.saturation, std::size_t{2}},
                                       {&edited.luminance, std::size_t{4}}})
      *range = {sliders_[first]->value(), sliders_[first + 1]->value()};
    changed();
  }
  void changed() {
    changed_ = true;
    showOrder();
    showImages();
  }
  void showOrder() {
    const QString current = order_->currentItem() ? order_->currentItem()->text() : QString{};
    order_->clear();
    for (const ColorClass known : colors_.order()) {
      order_->addItem(QString::fromStdString(std::string{enumName(known)}));
      if (order_->item(order_->count() - 1)->text() == current)
        order_->setCurrentRow(order_->count() - 1);
    }
  }
  void showImages() {
    if (!image_) return;
    const Image shown = noise_ > 0 ? withNoise(*image_, noise_, random_) : *image_;
    raw_->showSheet(std::make_shared<const Sheet>(imageSheet(shown, tslEnlarged)));
    RgbImage classes{shown.info.width, shown.info.height, {}};
    for (const Pixel& pixel : shown.pixels) {
      const Color color = displayColor(colors_[pixel]);
      classes.pixels.insert(classes.pixels.end(), {color.r, color.g, color.b});
    }
    classified_->showSheet(
        std::make_shared<const Sheet>(pictureSheet(std::move(classes), tslEnlarged)));
  }

  void load() {
    const QString file = QFileDialog::getOpenFileName(this, "Load", "config", "TSL colors (*.tsl)");
    if (file.isEmpty()) return;
    const auto read = readTslColors(file.toStdString());
    if (!read) return report(read.error());
    colors_ = *read;
    showSliders();
    changed();
    changed_ = false;
  }
  bool save(bool table) {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save", table ? "coltable.c64" : "coltable.tsl",
                                     table ? "Tables (*.c64)" : "TSL colors (*.tsl)");
    if (file.isEmpty()) return false;
    const auto done = table ? writeFile(file.toStdString(), colorTableBytes(colors_.table()))
                            : writeFile(file.toStdString(), tslText(colors_));
    if (!done) report(done.error());
    if (done && !table) changed_ = false;
    return static_cast<bool>(done);
  }
  void report(const Error& error) {
    QMessageBox::warning(this, "TSL", QString::fromStdString(error.text()));
  }

  SheetWidget* raw_;
  SheetWidget* classified_;
  QComboBox* color_;
  QCustomPlot* plot_ = nullptr;
  std::array<QSlider*, 6> sliders_{};
  QListWidget* order_;
  TslColors colors_;
  TslHistogram histogram_;
  std::optional<QPoint> corner_;
  int noise_ = 0;
  Random random_{1};
  bool changed_ = false;
  std::optional<Image> image_;
  ImageSource source_{session(), *this, [this](Image image) {
                        image_ = std::move(image);
                        showImages();
                      }};
};

const RegisterDialog<TslDialog> registeredTslDialog{
    {.id = "tsl",
     .title = "TSL",
     .group = "Colors",
     .help = "Color classes by thresholds of tint, saturation and luminance",
     .report = "J.6.3",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
