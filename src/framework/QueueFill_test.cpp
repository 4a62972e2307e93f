#include "framework/QueueFill.h"

#include <gtest/gtest.h>

#include "debug/Drawing.h"
#include "framework/DebugProcess.h"
#include "framework/RepresentationDefinition.h"
#include "framework/Requests.h"

namespace gt {
namespace {

/// A Debug process and the process that sends to it.
class QueueFillTest : public ::testing::Test {
 protected:
  QueueFillTest() { sender.connect(debug.addReceiver()); }

  /// Sends what was written to `out`, and lets the Debug process run.
  void cycle() {
    sender.send();
    out.clear();
    now = now + 8;
    debug.step(now);
  }
  void ask(QueueFillMode mode, double seconds = 0) {
    debug.fromTools().write(now, QueueFillRequest{mode, seconds});
    cycle();
  }
  /// What a queue holds, one word a message.
  static std::string content(const MessageQueue& queue) {
    std::string all;
    queue.handleAllMessages([&](const Message& message) {
      Text text;
      Plot plot;
      Drawing drawing;
      DroppedMessages dropped;
      RequestAnswer answer;
      if (message.is<RequestAnswer>() && message.read(answer)) {
        all += answer.what.empty() ? "" : answer.process + ": " + answer.what + ' ';
        return;
      }
      if (message.is<Text>() && message.read(text)) all += text.text;
      if (message.is<Plot>() && message.read(plot))
        all += plot.key + std::to_string(static_cast<int>(plot.value));
      if (message.is<Drawing>() && message.read(drawing))
        all += drawing.key + std::to_string(message.time.ms);
      if (message.is<DroppedMessages>() && message.read(dropped))
        all += "dropped:" + std::to_string(dropped.types[0].count);
      all += ' ';
    });
    return all;
  }
  std::string taken() {
    std::string all = content(debug.toTools());
    debug.toTools().clear();
    return all;
  }

  DebugProcess debug{"Debug"};
  MessageQueue out;
  PackageSender sender{representation<MessageQueue>(), &out};
  Time now;
};

TEST_F(QueueFillTest, QueuesAllByDefault) {
  for (const char* text : {"a", "b"}) {
    out.write(now, Text{text});
    cycle();
  }
  EXPECT_EQ(taken(), "a b ");
  EXPECT_TRUE(debug.fromTools().empty());
}

TEST_F(QueueFillTest, ReplacesOlderMessagesOfAKind) {
  ask(QueueFillMode::replace);
  out.write({1}, Text{"a"});
  out.write({1}, Plot{"x", 1});
  out.write({1}, Plot{"y", 1});
  out.write({1}, Text{"b"});
  cycle();
  EXPECT_EQ(content(debug.toTools()), "x1 y1 b ");
  out.write({2}, Plot{"x", 2});
  cycle();
  EXPECT_EQ(taken(), "y1 b x2 ");
  cycle();
  EXPECT_EQ(taken(), "") << "what was taken does not come again";
}

// Report I, footnote 3: newer drawing commands replaced older ones of the same drawing.
TEST_F(QueueFillTest, KeepsDrawingsWhole) {
  ask(QueueFillMode::replace);
  for (const int time : {1, 2}) {
    for (const char* key : {"ball", "ball", "lines"})
      out.write({time}, Drawing{key, DrawingSpace::field, {}});
    cycle();
    const std::string t = std::to_string(time);
    EXPECT_EQ(content(debug.toTools()), "ball" + t + " ball" + t + " lines" + t + ' ');
  }
  out.write({3}, Drawing{"ball", DrawingSpace::field, {}});
  cycle();
  EXPECT_EQ(taken(), "lines2 ball3 ");
}

TEST_F(QueueFillTest, NeverOverflowsWhenItReplaces) {
  ask(QueueFillMode::replace);
  const std::string large(900'000, 'x');
  for (int i = 0; i < 50; ++i) {
    out.write({i}, Text{large});
    cycle();
  }
  EXPECT_EQ(debug.toTools().dropped(), 0u);
  EXPECT_EQ(content(debug.toTools()).size(), large.size() + 1);
}

TEST_F(QueueFillTest, TellsWhatItDropped) {
  const std::string large(1'000'000, 'x');
  for (int i = 0; i < 20; ++i) {
    out.write({i}, Text{large});
    cycle();
  }
  EXPECT_GT(debug.toTools().dropped(), 0u);
  const auto dropped = debug.toTools().dropped();
  debug.toTools().clear();
  cycle();
  EXPECT_EQ(taken(), "dropped:" + std::to_string(dropped) + " ");
}

TEST_F(QueueFillTest, Rejects) {
  ask(QueueFillMode::reject);
  out.write(now, Text{"a"});
  cycle();
  EXPECT_EQ(taken(), "");
  ask(QueueFillMode::queue);
  out.write(now, Text{"b"});
  cycle();
  EXPECT_EQ(taken(), "b ");
}

TEST_F(QueueFillTest, AnswersComeInAnyCase) {
  for (const QueueFillMode mode : {QueueFillMode::replace, QueueFillMode::reject}) {
    ask(mode);
    taken();
    out.write(now, RequestAnswer{1, now, "Eyes", RequestOutcome::refused, "blind"});
    out.write(now, RequestAnswer{1, now, "Legs", RequestOutcome::refused, "tired"});
    cycle();
    EXPECT_EQ(taken(), "Eyes: blind Legs: tired ");
  }
}

TEST_F(QueueFillTest, CollectsForSomeSeconds) {
  ask(QueueFillMode::collect, 0.08);
  int sent = 0;
  for (int i = 0; i < 30; ++i) {
    out.write(now, Text{"a"});
    cycle();
    sent += taken().empty() ? 0 : 1;
  }
  EXPECT_EQ(sent, 9) << "within 80 ms of 8 ms each";
}

TEST_F(QueueFillTest, SavesSomeSecondsAndSendsNothing) {
  std::vector<std::string> saved;
  debug.onSave([&](const MessageQueue& messages) { saved.push_back(content(messages)); });
  ask(QueueFillMode::save, 0.03);
  for (const char* text : {"a", "b", "c", "d", "e", "f"}) {
    out.write(now, Text{text});
    cycle();
    EXPECT_EQ(taken(), "");
  }
  EXPECT_EQ(saved, std::vector<std::string>{"a b c "});
}

/// "debugIn for incoming and debugOut for outgoing debug messages" (report E.1): a process that
/// holds both talks with the tools, whatever else it does.
TEST(DebugProcess, ConnectsEveryProcessThatHoldsQueues) {
  class Echo : public Process {
   public:
    Echo() : Process{"Echo"} {}
    Receiver<MessageQueue> debugIn{*this};
    Sender<MessageQueue> debugOut{*this};

   protected:
    int main() override {
      debugOut.clear();
      if (debugIn.receivedNew()) debugIn.moveAllMessages(debugOut);
      if (!debugOut.empty()) debugOut.send();
      return -8;
    }
  } echo;
  DebugProcess debug{"Debug"};
  debug.connect(echo.debugOut, echo.debugIn);
  debug.fromTools().write({3}, Text{"hello"});
  for (Time now{0}; now < Time{40}; now = now + 8) {
    debug.step(now);
    echo.step(now);
  }
  std::string reported;
  debug.toTools().handleAllMessages([&](const Message& message) {
    Text text;
    ASSERT_TRUE(message.read(text));
    reported += text.text + std::to_string(message.time.ms);
  });
  EXPECT_EQ(reported, "hello3");
}

TEST_F(QueueFillTest, RefusesWrongTimes) {
  for (const double seconds : {0.0, -1.0, std::nan(""), 1e300}) {
    ask(QueueFillMode::collect, seconds);
    EXPECT_NE(taken().find("seconds"), std::string::npos);
  }
  out.write(now, Text{"a"});
  cycle();
  EXPECT_EQ(taken(), "a ") << "the last good request stands";
}

}  // namespace
}  // namespace gt
