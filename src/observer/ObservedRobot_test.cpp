#include "observer/ObservedRobot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "representations/infrastructure/Image.h"

namespace gt {
namespace {

using ::testing::ElementsAre;

/// A robot with one process that has an Image and a debug key.
class OneProcess : public RobotLink {
 public:
  MessageQueue& toRobot() override { return in_; }
  void exchange(const Taker& take) override {
    MessageQueue out;
    in_.handleAllMessages([&](const Message& message) { answer(message, out); });
    in_.clear();
    take(out);
  }

  int images = 0;
  bool answers = true;
  std::vector<DebugKeyMode> modes;  ///< That were asked for of Eyes/seen.

 private:
  void answer(const Message& message, MessageQueue& out) {
    if (!answers) return;
    RequestAnswer answer = answerTo(message, "Eyes", {});
    WatchRequest watch;
    DebugRequest key;
    if (message.is<DescriptionRequest>()) {
      ProcessDescription description;
      description.process = "Eyes";
      description.representations.push_back({"Image", RepresentationOrigin::platform, true, 0});
      if (otherLayout_)
        description.representations.push_back({"Sound", RepresentationOrigin::received, true, 0});
      description.debugKeys = {"Eyes/seen"};
      out.write({}, description);
    } else if (message.is<WatchRequest>() && message.read(watch)) {
      Image image;
      image.info.width = ++images;
      image.info.height = 1;
      image.allocate();
      if (watch.mode == DebugKeyMode::times) out.write({}, image);
    } else if (message.is<DebugRequest>() && message.read(key)) {
      if (key.key == "Eyes/seen")
        modes.push_back(key.mode);
      else
        answer.outcome = RequestOutcome::notConcerned;
    } else if (message.is<LayoutRequest>()) {
      otherLayout_ = true;
    } else if (message.is<SolutionRequest>()) {
      answer = answerTo(message, "Eyes", Error{.what = "not now"});
    }
    out.write({}, answer);
  }

  MessageQueue in_;
  bool otherLayout_ = false;
};

class ObservedRobotTest : public ::testing::Test {
 protected:
  void draw(int ms, std::initializer_list<const char*> keys) {
    MessageQueue queue{1 << 16};
    for (const char* key : keys)
      queue.write(
          {ms}, Drawing{key, DrawingSpace::field, {{ElementType::point, {{0, 0}}, 1, {}, 1, ""}}});
    queue.write({ms}, StopwatchTime{"thinking", 1.0 * ms});
    robot.take(queue);
  }
  std::size_t elements(const char* key) { return robot.drawings().at(key).elements.size(); }

  OneProcess* link = new OneProcess;
  ObservedRobot robot{"red1", std::unique_ptr<RobotLink>{link}};
};

// Report E.5: several modules write to one drawing. E.7: stopwatches become plots.
TEST_F(ObservedRobotTest, JoinsWhatIsDrawnAtOneTime) {
  draw(8, {"Eyes/seen", "other", "Eyes/seen"});
  draw(8, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 3u);
  EXPECT_EQ(elements("other"), 1u);
  draw(16, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 1u);
  EXPECT_EQ(elements("other"), 1u);
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", DebugKeyMode::disabled}));
  draw(24, {"Eyes/seen", "other"});
  EXPECT_EQ(robot.drawings().size(), 1u);
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", DebugKeyMode::always}));
  draw(32, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 1u);
  ASSERT_EQ(robot.plots().at("thinking").size(), 5u);
  EXPECT_EQ(robot.plots().at("thinking").back().value, 32);
}

TEST_F(ObservedRobotTest, AsksForAValueUnlessItIsSubscribed) {
  EXPECT_EQ(robot.newest<Image>(), nullptr);
  const auto image = robot.value<Image>();
  ASSERT_TRUE(image) << image.error().text();
  EXPECT_EQ((*image)->info.width, 1);
  EXPECT_EQ((*robot.value<Image>())->info.width, 2);
  EXPECT_EQ(*robot.get("Image.info.width"), "3");
  {
    const auto subscription = robot.subscribe("Image");
    EXPECT_EQ(link->images, 4);
    EXPECT_EQ((*robot.value<Image>())->info.width, 3) << "nothing newer has come";
    EXPECT_EQ(link->images, 4);
  }
  EXPECT_EQ(link->images, 5) << "it was notified that nobody wants it any more";
  EXPECT_EQ(robot.value("Poem").error().what, "no process of the robot has it");
  EXPECT_THAT(robot.inputs(), ElementsAre("Image"));
}

TEST_F(ObservedRobotTest, SubscribesKeysBesideWhatIsAskedForByHand) {
  using enum DebugKeyMode;
  {
    const auto first = robot.subscribeKey("Eyes/seen"), second = robot.subscribeKey("Eyes/seen");
    EXPECT_THAT(link->modes, ElementsAre(always));
    draw(8, {"Eyes/seen"});
    EXPECT_TRUE(robot.drawings().empty()) << "views show what was asked for by hand";
    EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", everyMs, 100}));
    draw(16, {"Eyes/seen"});
    EXPECT_EQ(elements("Eyes/seen"), 1u);
    EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", disabled}));
    EXPECT_THAT(link->modes, ElementsAre(always, everyMs, always));
  }
  EXPECT_EQ(link->modes.back(), disabled);
  EXPECT_EQ(link->modes.size(), 4u);
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", always}));
  { const auto subscription = robot.subscribeKey("Eyes/seen"); }
  EXPECT_EQ(link->modes.size(), 5u) << "it stays on, as it was asked for by hand";
}

TEST_F(ObservedRobotTest, ShowsKeysForAsLongAsTheyAreViewed) {
  using enum DebugKeyMode;
  auto first = robot.showKey("Eyes/seen"), second = robot.showKey("Eyes/seen");
  EXPECT_THAT(link->modes, ElementsAre(always));
  draw(8, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 1u);
  first.reset();
  robot.update();
  EXPECT_EQ(link->modes.size(), 1u) << "somebody still views it";
  second.reset();
  robot.update();
  robot.update();
  EXPECT_THAT(link->modes, ElementsAre(always, disabled));
  EXPECT_TRUE(robot.drawings().empty());
}

TEST_F(ObservedRobotTest, ViewersLeaveKeysAsTheyWereAskedForByHand) {
  using enum DebugKeyMode;
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", everyMs, 100}));
  auto viewer = robot.showKey("Eyes/seen");
  viewer.reset();
  robot.update();
  robot.update();
  EXPECT_THAT(link->modes, ElementsAre(everyMs));
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", disabled}));
  viewer = robot.showKey("Eyes/seen");
  EXPECT_THAT(link->modes, ElementsAre(everyMs, disabled));
  EXPECT_TRUE(robot.isHidden("Eyes/seen"));
  draw(16, {"Eyes/seen"});
  EXPECT_TRUE(robot.drawings().empty()) << "it was switched off";
  EXPECT_TRUE(robot.request(DebugRequest{"Eyes/seen", times, 1}));
  draw(24, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 1u);
}

TEST_F(ObservedRobotTest, ViewersSeeWhatIsSubscribedByOthers) {
  const auto subscription = robot.subscribeKey("Eyes/seen");
  draw(8, {"Eyes/seen"});
  EXPECT_TRUE(robot.drawings().empty());
  EXPECT_FALSE(robot.isHidden("Eyes/seen"));
  auto viewer = robot.showKey("Eyes/seen");
  draw(16, {"Eyes/seen"});
  EXPECT_EQ(elements("Eyes/seen"), 1u);
  viewer.reset();
  robot.update();
  robot.update();
  EXPECT_THAT(link->modes, ElementsAre(DebugKeyMode::always)) << "for the subscription";
}

TEST_F(ObservedRobotTest, HandsMessagesToAllWhoFollow) {
  int first = 0, second = 0;
  const auto counted = robot.passTo([&](const MessageQueue&) { ++first; });
  {
    const auto alsoCounted = robot.passTo([&](const MessageQueue&) { ++second; });
    draw(8, {"Eyes/seen"});
  }
  draw(16, {"Eyes/seen"});
  EXPECT_EQ(first, 2);
  EXPECT_EQ(second, 1);
}

TEST_F(ObservedRobotTest, TakesNoImageThatIsNotWhole) {
  ASSERT_TRUE(robot.value<Image>());
  MessageQueue queue;
  Image image;
  image.info.width = image.info.height = 2000;
  queue.write({16}, image);
  robot.take(queue);
  EXPECT_EQ(robot.newest<Image>(), nullptr);
}

TEST_F(ObservedRobotTest, CollectsWhatTheRobotReportsAsWrong) {
  MessageQueue queue;
  queue.write({8}, Text{"hello"});
  queue.write({16}, Text{"no ball at all", Severity::warning});
  robot.take(queue);
  EXPECT_EQ(robot.warnings().warnings(), 1u);
  EXPECT_TRUE(robot.warnings().fail(true));
  EXPECT_NE(robot.warnings().text().find("at 16 ms: warning: no ball at all"), std::string::npos);
}

TEST_F(ObservedRobotTest, KnowsWhatAnotherLayoutBrings) {
  EXPECT_THAT(robot.representations(), ElementsAre("Image"));
  EXPECT_TRUE(robot.request(LayoutRequest{"other.layout", ""}));
  EXPECT_THAT(robot.representations(), ElementsAre("Image", "Sound"));
}

TEST_F(ObservedRobotTest, ForgetsTheValuesOfARobotThatBeginsAnew) {
  ASSERT_TRUE(robot.value<Image>());
  EXPECT_NE(robot.newest<Image>(), nullptr);
  robot.forget();
  EXPECT_EQ(robot.newest<Image>(), nullptr);
  EXPECT_TRUE(robot.value<Image>());
}

TEST_F(ObservedRobotTest, TellsWhatTheRobotRefuses) {
  EXPECT_EQ(robot.request(SolutionRequest{"ImageProcessor", "Poet"}).error().what, "not now");
  EXPECT_EQ(robot.request(DebugRequest{"Ears/heard", DebugKeyMode::always}).error().what,
            "there is no such debug key");
  EXPECT_EQ(robot.get("Poem.rhyme").error().what, "there is no such value; try get ?");
  link->answers = false;
  EXPECT_EQ(robot.request(SolutionRequest{"ImageProcessor", "Poet"}).error().what,
            "the robot does not answer");
  MessageQueue late;
  late.write({}, RequestAnswer{1, Time{1}, "Eyes", RequestOutcome::refused, "too late"});
  robot.take(late);
  EXPECT_THAT(robot.takeTexts(), ElementsAre("Eyes: too late"));
}

}  // namespace
}  // namespace gt
