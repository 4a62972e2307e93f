#include <QJsonArray>
#include <QLabel>
#include <QMenu>

#include "workbench/TestWindow.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

TEST_F(WindowTest, ThingsArePutOnTheFieldByTheContextMenu) {
  auto* field = dynamic_cast<ViewDialog*>(window->dialog("field"));
  ASSERT_TRUE(field);
  EXPECT_TRUE(until([&] { return field->sheet().sheet() != nullptr; }));
  const auto put = [&](const QString& what, double x, double y) {
    QMenu menu;
    const Sheet& sheet = *field->sheet().sheet();
    field->sheet().addActions(menu, {sheet.width() / 2.0 + x * fieldViewScale,
                                     sheet.height() / 2.0 - y * fieldViewScale});
    for (QAction* action : menu.actions().front()->menu()->actions())
      if (action->text() == what) action->trigger();
  };
  const auto stands = [&](const std::string& what, const std::string& where) {
    return until([&] { return value(what + ".x") + " " + value(what + ".y") == where; });
  };
  put("ball", 700, -300);
  EXPECT_TRUE(stands("ball", "700 -300"));
  // The blue team looks from the other side.
  field->setRobot("blue1");
  put("red2", 800, 100);
  EXPECT_TRUE(stands("red2", "-800 -100"));
}

TEST_F(DialogTest, ViewersSayWhyDrawingsDoNotCome) {
  window->bringToFront("field");
  auto* hint = widget<QLabel>("field", "hint");
  const auto says = [&](const char* text) {
    return until([&] {
      EXPECT_TRUE(execute("run 80 ms"));
      return hint->isVisible() == (*text != 0) && (!*text || hint->text().contains(text));
    });
  };
  const auto drawn = [](Console& console) {
    return (*console.firstRobot())->observed().drawings().contains("SelfLocator/pose");
  };
  EXPECT_TRUE(says("") && until([&] {
                EXPECT_TRUE(execute("run 80 ms"));
                return on(drawn);
              }));
  ASSERT_TRUE(execute("dk SelfLocator/pose off"));
  EXPECT_TRUE(says("SelfLocator/pose (off)"));
  EXPECT_FALSE(on(drawn));
  Q_EMIT hint->linkActivated("on");
  finish();
  EXPECT_TRUE(says(""));
  EXPECT_TRUE(on(drawn));
  ASSERT_TRUE(execute("sr BallLocator disabled"));
  EXPECT_TRUE(says("BallLocator/ball (BallLocator is disabled)"));
  QJsonObject settings = window->dialog("field")->settings();
  settings["drawings"] = QJsonArray{"NoModule/nothing"};
  window->dialog("field")->restore(settings);
  EXPECT_TRUE(says("NoModule/nothing (unknown to red3)"));
}

TEST_F(WindowTest, EightImagesShowRobotsOfTheirOwn) {
  Dialog* dialog = window->open("images");
  QJsonObject settings = dialog->settings();
  QJsonArray fields = settings["fields"].toArray();
  ASSERT_EQ(fields.size(), 8);
  fields[2] = QJsonObject{{"robot", "blue3"}, {"image", "image"}};
  settings["fields"] = fields;
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings()["fields"].toArray()[2].toObject()["robot"].toString(), "blue3");
  ASSERT_TRUE(execute("run 200 ms"));
  auto* own = dynamic_cast<ViewDialog*>(dialog->findChild<Dialog*>("field3"));
  auto* classes = dynamic_cast<ViewDialog*>(dialog->findChild<Dialog*>("field2"));
  ASSERT_TRUE(own && classes);
  EXPECT_TRUE(until([&] { return own->sheet().sheet() && classes->sheet().sheet(); }));
  EXPECT_NE(own->sheet().image(1), classes->sheet().image(1));
}

// Whoever watches a robot costs it nothing any more once he is gone.
TEST_F(WindowTest, RobotsDrawForViewersOnlyWhileTheyAreOpen) {
  const std::string key = "ImageProcessor/horizon";
  const auto draws = [&](bool wanted) {
    return until([&] {
      return execute("run 80 ms") &&
             wanted == on([&](Console& console) {
               return (*console.firstRobot())->observed().drawings().contains(key);
             });
    });
  };
  Dialog* dialog = window->open("image");
  ASSERT_TRUE(draws(true));
  dialog->parentWidget()->close();
  EXPECT_TRUE(draws(false));
  window->open("image");
  EXPECT_TRUE(draws(true));
  ASSERT_TRUE(execute("dk " + key + " off"));
  EXPECT_TRUE(draws(false)) << "as the person wants it";
}

}  // namespace
}  // namespace gt
