#include "views/Views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "base/TemporaryFolder.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A robot of a team that knows nothing else; it hands over messages that a test has written.
class WrittenLink : public RobotLink {
 public:
  MessageQueue& toRobot() override { return in_; }
  void exchange(const Taker& take) override {
    in_.handleAllMessages([&](const Message& message) {
      if (message.is<DescriptionRequest>()) {
        ProcessDescription description;
        description.process = "Robby";
        description.representations.push_back(
            {"Player", RepresentationOrigin::configuration, true, 0});
        queue.write({}, description);
      }
      if (message.is<WatchRequest>()) queue.write({}, Player{team, PlayerRole::goalie});
      queue.write({}, answerTo(message, "Robby", {}));
    });
    in_.clear();
    take(queue);
    queue.clear();
  }

  TeamColor team = TeamColor::red;
  MessageQueue queue{1 << 20};

 private:
  MessageQueue in_;
};

/// A robot of which only messages are known, as one elsewhere.
class ViewsTest : public ::testing::Test {
 protected:
  ViewsTest() {
    auto made = std::make_unique<WrittenLink>();
    link = made.get();
    robot = std::make_unique<ObservedRobot>("robby", std::move(made));
    subject.robots = {robot.get()};
  }
  template <typename T>
  void come(const T& message) {
    link->queue.write({8}, message);
    robot->update();
  }
  static const View& view(std::string_view name) {
    for (const auto& known : builtInViews())
      if (known->name() == name) return *known;
    throw std::logic_error{"there is no such view"};
  }
  std::string svg(const View& shown) {
    const auto sheet = shown.show(subject, {});
    EXPECT_TRUE(sheet) << sheet.error().text();
    return sheet ? sheet->svg() : "";
  }

  WrittenLink* link = nullptr;
  std::unique_ptr<ObservedRobot> robot;
  ViewSubject subject;
};

TEST_F(ViewsTest, HaveNamesAndHelp) {
  std::set<std::string> names;
  for (const auto& known : builtInViews()) {
    EXPECT_TRUE(names.insert(known->name()).second) << known->name();
    EXPECT_FALSE(known->help().empty());
  }
}

TEST_F(ViewsTest, WithoutRobotsOrSceneTheyAreErrors) {
  subject.robots.clear();
  for (const auto& known : builtInViews()) {
    if (known->name() == "field") continue;  // there is always a field
    EXPECT_FALSE(known->show(subject, {})) << known->name();
  }
  subject.robots = {robot.get()};
  for (const char* name : {"scene", "robot", "facette", "depth"})
    EXPECT_FALSE(view(name).show(subject, {})) << name;
}

TEST_F(ViewsTest, XabslShowsSymbolsInTwoListsWithUnits) {
  BehaviorState state;
  state.agent = "striker";
  state.activations.push_back({"play", "attack", 0, 1500, 300, {}});
  state.activations.push_back(
      {"go_to_point", "", 1, 0, 0, {{"angle", "-1.9773997357099518", "deg"}}});
  state.inputs = {{"ball.distance", "812.3456789", "mm"}, {"ball.seen", "true"}};
  state.outputs = {{"head_control_mode", "search_for_ball"}};
  come(state);
  const std::string text = svg(view("xabsl"));
  for (const char* part : {"Agent: striker", ">1.5 s<", "angle = -1.98\u00B0", ">Input Symbols<",
                           ">812.3 mm<", ">Output Symbols<", ">search_for_ball<"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_LT(text.find("Input Symbols"), text.find("Output Symbols"));
  EXPECT_LT(text.size(), 4000u);
}

TEST_F(ViewsTest, PlotsWhatWasRecorded) {
  ViewSubject::Series series{{"ball.x", {{Time{0}, 1}, {Time{1000}, 3}}}};
  subject.recorded = &series;
  subject.now = Time{1000};
  EXPECT_THAT(svg(view("plot")), HasSubstr(">ball.x   now 3.00<"));
  EXPECT_FALSE(view("plot").show(subject, std::vector<double>{-1}));
}

TEST_F(ViewsTest, FieldViewsConsistOfTheirElements) {
  come(Drawing{"a", DrawingSpace::field, {{ElementType::disk, {{0, 0}}, 10, {1, 2, 3}, 1, ""}}});
  come(Drawing{"b", DrawingSpace::field, {{ElementType::disk, {{0, 0}}, 10, {4, 5, 6}, 1, ""}}});
  come(Drawing{"c", DrawingSpace::image, {{ElementType::disk, {{0, 0}}, 10, {7, 8, 9}, 1, ""}}});
  const std::string both = svg(*makeFieldView("x", "", {"drawings"}));
  EXPECT_THAT(both, HasSubstr("#010203"));
  EXPECT_THAT(both, HasSubstr("#040506"));
  EXPECT_THAT(both, Not(HasSubstr("#070809"))) << "an image drawing";
  const std::string one = svg(*makeFieldView("x", "", {"b"}));
  EXPECT_THAT(one, Not(HasSubstr("#010203")));
  EXPECT_THAT(one, HasSubstr("#040506"));
}

TEST_F(ViewsTest, BlueRobotsSeeTheFieldTurned) {
  // The own goal is on the left: yellow for red robots, sky-blue for blue ones.
  const auto leftGoal = [&] {
    const std::string text = svg(*makeFieldView("x", "", {"fieldPolygons"}));
    return std::pair{text.find("#fadc14"), text.find("#46b4f0")};
  };
  auto [yellow, skyblue] = leftGoal();
  EXPECT_LT(yellow, skyblue);
  link->team = TeamColor::blue;
  std::tie(yellow, skyblue) = leftGoal();
  EXPECT_GT(yellow, skyblue);
}

}  // namespace
}  // namespace gt
