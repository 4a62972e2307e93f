#include <QCheckBox>
#include <QFile>
#include <QListWidget>
#include <QSlider>
#include <cmath>

#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "representations/infrastructure/CameraSettings.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// A robot that has the ball before its eyes.
class ColorDialogTest : public WindowTest {
 protected:
  ColorDialogTest() : WindowTest{"scenes/one-robot.scene"} {
    EXPECT_TRUE(execute("sr BehaviorControl disabled"));
    EXPECT_TRUE(execute("hcm lookStraightAhead"));
    EXPECT_TRUE(execute("place red3 0 0 0"));
    EXPECT_TRUE(execute("place ball 600 0"));
    EXPECT_TRUE(execute("run 1s"));
    image_ =
        on([](Console& console) { return **(*console.firstRobot())->observed().value<Image>(); });
  }

  /// A pixel of the middle of the ball, by color.
  QPoint ball() const {
    QPoint sum;
    int count = 0;
    for (int y = 0; y < image_.info.height; ++y)
      for (int x = 0; x < image_.info.width; ++x) {
        const Pixel& p = image_.at(x, y);
        if (p.cr < 170 || p.cb > 110) continue;
        sum += QPoint{x, y};
        ++count;
      }
    EXPECT_GT(count, 20);
    return sum / std::max(count, 1);
  }
  /// Clicks on a pixel of an image that is shown in some scale.
  void clickPixel(SheetWidget& sheet, const QPoint& pixel,
                  Qt::MouseButton button = Qt::LeftButton) {
    ASSERT_TRUE(sheet.sheet());
    const double scale = static_cast<double>(sheet.sheet()->width()) / image_.info.width;
    // The widget's point whose place on the sheet is the pixel.
    const QPointF origin = sheet.toSheet({0, 0}), unit = sheet.toSheet({1, 1}) - origin;
    const QPointF wanted = QPointF{pixel} * scale + QPointF{scale / 2, scale / 2};
    QTest::mouseClick(
        &sheet, button, {},
        QPointF{(wanted.x() - origin.x()) / unit.x(), (wanted.y() - origin.y()) / unit.y()}
            .toPoint());
  }
  ColorClass classOf(const Pixel& pixel) {
    return on([pixel](Console& console) {
      return (**(*console.firstRobot())->observed().value<ColorTable64>())[pixel];
    });
  }

  Image image_;
};

TEST_F(ColorDialogTest, HsiColorsAreMadeBySlidersAndByClicksOnTheZoomedImage) {
  window->open("hsi");
  auto* small = widget<SheetWidget>("hsi", "image1");
  EXPECT_TRUE(until([&] { return small->sheet() != nullptr; }));
  choose("hsi", "class", "pink");
  clickPixel(*small, ball());
  auto* zoom = widget<SheetWidget>("hsi", "zoom");
  EXPECT_TRUE(until([&] { return zoom->sheet() && !zoom->waitsForPainting(); }));
  const Pixel orange = image_.at(ball().x(), ball().y());
  EXPECT_NE(classOf(orange), ColorClass::pink);
  for (const int x : {-4, 0, 4})
    for (const int y : {-4, 0, 4}) clickPixel(*zoom, ball() + QPoint{x, y});
  const auto slider = [&](const char* name) { return widget<QSlider>("hsi", name)->value(); };
  const auto chosen = [&] {
    HsiRange range;
    range.hue = {slider("minHue"), slider("maxHue")};
    range.saturation = {slider("minSaturation"), slider("maxSaturation")};
    range.intensity = {slider("minIntensity"), slider("maxIntensity")};
    return range;
  };
  EXPECT_TRUE(chosen().contains(hsiOf(orange)));
  click("hsi", "send");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  HsiColors made;
  made.ranges[ColorClass::pink] = chosen();
  EXPECT_EQ(on([](Console& console) {
              return (**(*console.firstRobot())->observed().value<ColorTable64>()).classes;
            }),
            made.table().classes);
  EXPECT_TRUE(window->dialog("hsi")->unsaved());
  const HsiRange before = chosen();
  clickPixel(*zoom, ball(), Qt::RightButton);
  EXPECT_NE(chosen(), before);
  click("hsi", "undo");
  EXPECT_EQ(chosen(), before);
  // By sliders: all that is as orange as the ball.
  const int hue = hsiOf(orange).hue;
  widget<QSlider>("hsi", "minHue")->setValue(std::max(hue - 10, 0));
  widget<QSlider>("hsi", "maxHue")->setValue(hue + 10);
  widget<QSlider>("hsi", "minSaturation")->setValue(20);
  widget<QSlider>("hsi", "maxSaturation")->setValue(100);
  widget<QSlider>("hsi", "minIntensity")->setValue(5);
  widget<QSlider>("hsi", "maxIntensity")->setValue(100);
  const HsiRange slid = chosen();
  EXPECT_TRUE(slid.contains(hsiOf(orange)));
  EXPECT_EQ(slid.saturation, (ColorRange{20, 100}));
  click("hsi", "send");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(classOf(orange), ColorClass::pink);
}

TEST_F(ColorDialogTest, TslColorsFollowFromARectangle) {
  window->open("tsl");
  auto* raw = widget<SheetWidget>("tsl", "raw");
  EXPECT_TRUE(until([&] { return raw->sheet() && !raw->waitsForPainting(); }));
  choose("tsl", "color", "pink");
  const QPoint at = ball();
  clickPixel(*raw, at - QPoint{2, 2});
  clickPixel(*raw, at + QPoint{2, 2});
  click("tsl", "auto");
  const Tsl seen = tslOf(image_.at(at.x(), at.y()));
  EXPECT_LE(widget<QSlider>("tsl", "t5")->value(), seen.luminance);
  EXPECT_GE(widget<QSlider>("tsl", "t6")->value(), seen.luminance);
  click("tsl", "send");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  const auto sent =
      on([](Console& console) { return **(*console.firstRobot())->observed().value<TslColors>(); });
  EXPECT_TRUE(sent.classes[ColorClass::pink].contains(seen));
  EXPECT_EQ(sent.order(), std::vector{ColorClass::pink});
  // A second class comes behind the first, and is moved before it.
  choose("tsl", "color", "orange");
  click("tsl", "auto");
  auto* order = widget<QListWidget>("tsl", "order");
  ASSERT_EQ(order->count(), 2);
  EXPECT_EQ(order->item(1)->text(), "orange");
  order->setCurrentRow(1);
  click("tsl", "up");
  EXPECT_EQ(order->item(0)->text(), "orange");
  // Noise changes the image that is shown.
  const QImage before = raw->image(1);
  widget<QSlider>("tsl", "noise")->setValue(40);
  EXPECT_NE(raw->image(1), before);
}

TEST_F(ColorDialogTest, TheCameraIsSetByTheToolbar) {
  window->bringToFront("camera");
  choose("camera", "whiteBalance", "FL");
  choose("camera", "shutter", "fast");
  choose("camera", "gain", "low");
  click("camera", "send");
  finish();
  ASSERT_TRUE(execute("run 500 ms"));
  EXPECT_EQ(value("CameraSettings.gain"), "gain_low");
  EXPECT_EQ(value("CameraSettings.shutterSpeed"), "shutter_fast");
  // Images are darker now.
  const auto brightness = [](const Image& image) {
    double sum = 0;
    for (const Pixel& pixel : image.pixels) sum += pixel.y;
    return sum / static_cast<double>(image.pixels.size());
  };
  const Image now =
      on([](Console& console) { return **(*console.firstRobot())->observed().value<Image>(); });
  EXPECT_LT(brightness(now), 0.8 * brightness(image_));
}

}  // namespace
}  // namespace gt
