#include <QCheckBox>

#include "representations/perception/ColorTable64.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

TEST_F(DialogTest, AColorTableIsMadeByClicking) {
  ASSERT_TRUE(execute("run 500 ms"));
  window->open("colorTable");
  auto* image = dynamic_cast<SheetWidget*>(widget<QWidget>("colorTable", "image"));
  ASSERT_TRUE(image);
  EXPECT_TRUE(until([&] { return image->sheet() != nullptr; }));
  widget<QCheckBox>("colorTable", "hold")->setChecked(true);
  choose("colorTable", "class", "pink");
  const QPoint middle{image->width() / 2, image->height() / 2};
  const QPointF place = image->toSheet(middle);
  const auto classThere = [&] {
    return on([place](Console& console) {
      ObservedRobot& robot = (*console.firstRobot())->observed();
      const Image seen = **robot.value<Image>();
      const Pixel pixel = seen.at(static_cast<int>(place.x()) / 4, static_cast<int>(place.y()) / 4);
      return (**robot.value<ColorTable64>())[pixel];
    });
  };
  const ColorClass before = classThere();
  ASSERT_NE(before, ColorClass::pink);
  QTest::mouseClick(image, Qt::LeftButton, {}, middle);
  finish();
  EXPECT_EQ(classThere(), before) << "nothing goes to the robot before the button is pressed";
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == ColorClass::pink; }));
  click("colorTable", "undo");
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == before; }));
  QTest::mouseClick(image, Qt::RightButton, {}, middle);
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == ColorClass::noColor; }));
}

}  // namespace
}  // namespace gt
