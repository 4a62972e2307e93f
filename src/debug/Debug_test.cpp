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

TEST(MessageQueue, DropsWhatDoesNotFitAndSaysSo) {
  MessageQueue queue{200};
  int written = 0;
  for (int i = 0; i < 20; ++i) written += queue.write({i}, Plot{"key", 1.0 * i});
  EXPECT_GT(written, 2);
  EXPECT_LT(written, 20);
  EXPECT_EQ(queue.dropped(), 20u - static_cast<unsigned>(written));
  int read = 0;
  queue.handleAllMessages([&](const Message& message) {
    Plot plot;
    EXPECT_TRUE(message.read(plot));
    EXPECT_EQ(plot.value, read++);
  });
  EXPECT_EQ(read, written);
}

TEST(MessageQueue, MovesCopiesAndCrossesAWire) {
  MessageQueue a, b, c;
  a.write({1}, Text{"one"});
  a.write({2}, Text{"two"});
  a.copyAllMessages(b);
  a.moveAllMessages(b);
  EXPECT_TRUE(a.empty());
  ASSERT_TRUE(c.assign(b.bytes()));
  std::string all;
  c.handleAllMessages([&](const Message& message) {
    Text text;
    if (message.read(text)) all += text.text;
  });
  EXPECT_EQ(all, "onetwoonetwo");
  for (std::size_t size = 1; size < b.size(); ++size)
    if (c.assign(b.bytes().first(size))) {
      EXPECT_EQ(size % (b.size() / 4), 0u);
    }
}

}  // namespace
}  // namespace gt
