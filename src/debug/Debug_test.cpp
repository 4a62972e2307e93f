#include "debug/Debug.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

const DebugKey samples{"Test/samples"};
const DebugKey other{"Test/other"};

int sentIn100Frames(DebugKeyRequest request) {
  Debug debug;
  debug.keys().set(samples, request);
  int sent = 0;
  for (int i = 0; i < 100; ++i) {
    debug.begin({8 * i});
    sent += debug.isActive(samples);
    EXPECT_FALSE(debug.isActive(other));
  }
  return sent;
}

TEST(DebugKey, HasTheStatesOfTheReport) {
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::disabled}), 0);
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::always}), 100);
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::times, 3}), 3);
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::everyTimes, 10}), 10);
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::everyMs, 80}), 10);
  EXPECT_EQ(sentIn100Frames({DebugKeyMode::everyTimes, 0}), 100);
}

// Several modules use one key: what one of them sends in a frame belongs to what the others send.
TEST(DebugKey, IsDueForAllWhoUseItInAFrame) {
  const DebugKey second{"Test/samples"};
  const DebugKeyRequest requests[] = {{DebugKeyMode::always},
                                      {DebugKeyMode::times, 3},
                                      {DebugKeyMode::everyTimes, 2},
                                      {DebugKeyMode::everyMs, 80}};
  for (const DebugKeyRequest& request : requests) {
    Debug debug;
    debug.keys().set(samples, request);
    int frames = 0;
    for (int i = 0; i < 100; ++i) {
      debug.begin({8 * i});
      const bool active = debug.isActive(samples);
      EXPECT_EQ(debug.isActive(second), active) << i;
      EXPECT_EQ(debug.isActive(samples), active) << i;
      frames += active;
    }
    EXPECT_EQ(frames, sentIn100Frames(request));
  }
}

// Frames in which nobody uses a key do not count.
TEST(DebugKey, CountsFramesInWhichItIsUsed) {
  Debug debug;
  debug.keys().set(samples, {DebugKeyMode::times, 2});
  for (int i = 0; i < 10; ++i) debug.begin({8 * i});
  EXPECT_TRUE(debug.isActive(samples));
  debug.begin({80});
  EXPECT_TRUE(debug.isActive(samples));
  debug.begin({88});
  EXPECT_FALSE(debug.isActive(samples));
}

TEST(DebugKeyDeathTest, IsNotMadeWhileTheProgramRuns) {
  const Debug debug;
  EXPECT_DEATH(DebugKey{"Test/late"}, "The debug key 'Test/late' is made while the program runs");
}

TEST(Debug, HasShapesForAllThatViewersShow) {
  Debug debug;
  debug.keys().set(samples, {DebugKeyMode::always});
  if (auto canvas = debug.onRobot(samples)) {
    canvas.point({1, 2});
    canvas.line({0, 0}, {1, 1});
    canvas.arrow({0, 0}, {1, 1});
    canvas.circle({0, 0}, 5);
    canvas.disk({0, 0}, 5);
    canvas.ellipse({10, 20}, 4, 2, pi / 2);
    canvas.sector({10, 20}, 5, 0, pi / 2);
    canvas.path({{0, 0}, {1, 0}, {1, 1}});
    canvas.polygon({{0, 0}, {1, 0}, {1, 1}});
    canvas.area({{0, 0}, {1, 0}, {1, 1}});
    canvas.text({0, 0}, "text");
  }
  Drawing drawing;
  debug.out().handleAllMessages([&](const Message& m) { ASSERT_TRUE(m.read(drawing)); });
  EXPECT_EQ(drawing.space, DrawingSpace::robot);
  ASSERT_EQ(drawing.elements.size(), enumCount<ElementType>);
  for (std::size_t i = 0; i < enumCount<ElementType>; ++i)
    EXPECT_EQ(drawing.elements[i].type, static_cast<ElementType>(i));
  const auto& ellipse = drawing.elements[static_cast<std::size_t>(ElementType::ellipse)].points;
  EXPECT_LT((ellipse[1] - Vector2d{10, 24}).norm(), 1e-9);
  EXPECT_LT((ellipse[2] - Vector2d{8, 20}).norm(), 1e-9);
  const auto& sector = drawing.elements[static_cast<std::size_t>(ElementType::sector)].points;
  EXPECT_LT((sector[1] - Vector2d{15, 20}).norm(), 1e-9);
  EXPECT_LT((sector[2] - Vector2d{10, 25}).norm(), 1e-9);
}

/// "CIRCLE(sketch, x, y, radius, 3, 0, Drawings::orange)" (report E.5): pens have width and style.
TEST(Debug, DrawsWithPens) {
  Debug debug;
  debug.keys().set(samples, {DebugKeyMode::always});
  if (auto canvas = debug.onField(samples)) {
    canvas.circle({1, 2}, 5, colors::orange, 3);
    canvas.line({0, 0}, {1, 1}, colors::gray, 2, PenStyle::dash);
    canvas.polygon({{0, 0}, {1, 0}, {1, 1}}, colors::gray, 1, PenStyle::dot);
  }
  Drawing drawing;
  debug.out().handleAllMessages([&](const Message& m) { ASSERT_TRUE(m.read(drawing)); });
  ASSERT_EQ(drawing.elements.size(), 3u);
  EXPECT_EQ(drawing.elements[0].penWidth, 3);
  EXPECT_EQ(drawing.elements[0].color.g, colors::orange.g);
  EXPECT_EQ(drawing.elements[0].penStyle, PenStyle::solid);
  EXPECT_EQ(drawing.elements[1].penStyle, PenStyle::dash);
  EXPECT_EQ(drawing.elements[2].penStyle, PenStyle::dot);
}

/// The examples of report E.4: OUTPUT sends in any case, INFO if the key is active.
TEST(Debug, SendsInAnyCaseOrOnRequest) {
  Debug debug;
  const auto sent = [&] {
    std::string all;
    debug.out().handleAllMessages([&](const Message& message) {
      Text text;
      Plot plot;
      if (message.is<Text>() && message.read(text))
        all += (text.severity == Severity::warning ? "warning: " : "") + text.text + ' ';
      if (message.is<Plot>() && message.read(plot)) all += plot.key + ' ';
    });
    debug.out().clear();
    return all;
  };
  debug.text("Found 3 balls.");
  debug.send(Plot{"sensors", 1});
  debug.send(samples, Text{"nobody asked"});
  debug.plot(samples, 2);
  debug.warn("no ball at all");
  EXPECT_EQ(sent(), "Found 3 balls. sensors warning: no ball at all ");
  debug.keys().set(samples, {DebugKeyMode::times, 1});
  debug.send(samples, Text{"asked"});
  debug.begin({8});
  debug.send(samples, Text{"once only"});
  EXPECT_EQ(sent(), "asked ");
}

TEST(DebugKey, IsSentAgainWhenTimeGoesBack) {
  Debug debug;
  debug.keys().set(samples, {DebugKeyMode::everyMs, 100});
  for (const int ms : {5000, 5050, 5100, 0, 50, 100}) {
    debug.begin({ms});
    EXPECT_EQ(debug.isActive(samples), ms % 100 == 0) << ms;
  }
}

TEST(Debug, StopsTheTimeOnRequest) {
  Debug debug;
  int done = 0;
  debug.stopTime(samples, [&] { ++done; });
  EXPECT_TRUE(debug.out().empty());
  debug.keys().set(samples, {DebugKeyMode::always});
  debug.stopTime(samples, [&] { ++done; });
  EXPECT_EQ(done, 2);
  StopwatchTime time;
  debug.out().handleAllMessages([&](const Message& m) { ASSERT_TRUE(m.read(time)); });
  EXPECT_EQ(time.event, "Test/samples");
  EXPECT_GE(time.microseconds, 0);
  // In any case, as STOP_TIME does (report E.7).
  debug.stopTime("roots", [&] { ++done; });
  debug.out().handleAllMessages([&](const Message& m) { ASSERT_TRUE(m.read(time)); });
  EXPECT_EQ(time.event, "roots");
  EXPECT_EQ(done, 3);
}

TEST(DebugKey, IsOneWhereverItsNameStands) {
  const std::size_t keys = DebugKey::all().size();
  const DebugKey again{"Test/samples"};
  EXPECT_EQ(DebugKey::all().size(), keys);
  Debug debug;
  debug.keys().set(again, {DebugKeyMode::always});
  EXPECT_TRUE(debug.isActive(samples));
  EXPECT_FALSE(debug.isActive(other));
}

TEST(DebugKey, IsFoundByName) {
  ASSERT_TRUE(DebugKey::find("Test/samples"));
  EXPECT_EQ(DebugKey::find("Test/samples")->index(), samples.index());
  EXPECT_EQ(DebugKey::find("Test/nothing"), nullptr);
}

TEST(Debug, DrawsOnlyWhatWasAskedFor) {
  Debug debug;
  debug.begin({40});
  EXPECT_FALSE(debug.onField(samples));
  EXPECT_TRUE(debug.out().empty());
  debug.keys().set(samples, {DebugKeyMode::always});
  if (auto canvas = debug.onField(samples)) {
    canvas.circle({100, 200}, 43, colors::orange);
    canvas.text({0, 0}, "ball");
  }
  int count = 0;
  debug.out().handleAllMessages([&](const Message& message) {
    Drawing drawing;
    ASSERT_TRUE(message.is<Drawing>());
    ASSERT_TRUE(message.read(drawing));
    EXPECT_EQ(message.time, Time{40});
    EXPECT_EQ(drawing.key, "Test/samples");
    ASSERT_EQ(drawing.elements.size(), 2u);
    EXPECT_EQ(drawing.elements[0].points[0], Vector2d(100, 200));
    EXPECT_EQ(drawing.elements[1].text, "ball");
    ++count;
  });
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace gt
