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
    sent += debug.keys().isActive(samples, debug.now());
    EXPECT_FALSE(debug.keys().isActive(other, debug.now()));
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

TEST(DebugKey, IsFoundByName) {
  EXPECT_EQ(DebugKey::find("Test/samples"), &samples);
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
