#include <QJsonArray>
#include <QLabel>
#include <QTableWidget>

#include "base/File.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

TEST_F(DialogTest, NetworksAreKeptAndConnectedTo) {
  window->open("connections");
  Dialog* const dialog = window->dialog("connections");
  dialog->restore(
      {{"networks",
        QJsonObject{{"lab", QJsonArray{QJsonArray{true, "dog", "tcp://127.0.0.1:39471"},
                                       QJsonArray{false, "cat", "tcp://127.0.0.1:39472"}}}}},
       {"current", "lab"}});
  const QJsonObject settings = dialog->settings();
  widget<QTableWidget>("connections", "robots")->item(1, 1)->setText("hound");
  EXPECT_NE(dialog->settings(), settings);
  click("connections", "connect");
  finish();
  EXPECT_TRUE(printed("dog does not answer"));
  const auto names = on([](Console& console) {
    std::vector<std::string> list;
    for (const auto& robot : console.session().robots()) list.push_back(robot->name());
    return list;
  });
  EXPECT_EQ(names, (std::vector<std::string>{"red3", "dog"}));
  EXPECT_TRUE(until([&] {
    return widget<QLabel>("connections", "state")->text().startsWith("dog: does not answer");
  }));
  // A robot that does not answer does not hold up the window.
  choose("simulation", "robot", "dog");
  finish();
  EXPECT_EQ(on([](Console& console) { return console.selection(); }),
            std::vector<std::string>{"dog"});
}

TEST_F(DialogTest, TheConfigurationIsCopiedForARobot) {
  window->open("connections");
  Dialog* const dialog = window->dialog("connections");
  dialog->restore({{"networks", QJsonObject{{"lab", QJsonArray{}}}}, {"current", "lab"}});
  click("connections", "addRobot");
  auto* table = widget<QTableWidget>("connections", "robots");
  const QString target = settings() + "/a stick";
  table->item(0, 1)->setText("dog");
  table->item(0, 2)->setText("tcp://10.0.1.7:15007");
  table->item(0, 5)->setText(target);
  qobject_cast<QComboBox*>(table->cellWidget(0, 3))->setCurrentText("blue");
  qobject_cast<QComboBox*>(table->cellWidget(0, 4))->setCurrentText("defender");
  const QJsonObject settings = dialog->settings();
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings(), settings);
  QTest::mouseClick(table->cellWidget(0, 6), Qt::LeftButton);
  finish();
  const std::string stick = target.toStdString();
  const auto player = readFile(stick + "/player.cfg");
  ASSERT_TRUE(player) << player.error().text();
  EXPECT_THAT(*player, ::testing::HasSubstr("teamColor blue"));
  EXPECT_THAT(*player, ::testing::HasSubstr("playerRole defender"));
  const auto network = readFile(stick + "/network.cfg");
  ASSERT_TRUE(network) << network.error().text();
  EXPECT_THAT(*network, ::testing::HasSubstr("robot dog"));
  EXPECT_THAT(*network, ::testing::HasSubstr("tcp://0.0.0.0:15007"));
  EXPECT_EQ(*readFile(stick + "/coltable.c64"), *readFile("config/coltable.c64"));
  EXPECT_TRUE(printed("playerRole defender"));
}

}  // namespace
}  // namespace gt
