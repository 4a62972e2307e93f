#include "streams/MessageQueue.h"

#include <gtest/gtest.h>

#include <map>

#include "base/Random.h"
#include "streams/MessageStreams.h"

namespace gt {
namespace {

struct Text {
  std::string text;
  static constexpr auto fields() { return Fields{field<&Text::text>()}; }
};
struct Count {
  double value = 0;
  static constexpr auto fields() { return Fields{field<&Count::value>()}; }
};

/// All texts and numbers of a queue in their order.
std::string contentOf(const MessageQueue& queue) {
  std::string all;
  queue.handleAllMessages([&](const Message& message) {
    Text text;
    Count number;
    if (message.is<Text>() && message.read(text)) all += text.text;
    if (message.is<Count>() && message.read(number)) all += std::to_string(int(number.value));
    all += '@' + std::to_string(message.time.ms) + ' ';
  });
  return all;
}

TEST(MessageQueue, KeepsOrderIdsAndTimes) {
  MessageQueue queue;
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.write({3}, Text{"one"}));
  EXPECT_TRUE(queue.write({-5}, Count{2}));
  EXPECT_TRUE(queue.write({4}, Text{""}));
  EXPECT_EQ(contentOf(queue), "one@3 2@-5 @4 ");
  EXPECT_EQ(contentOf(queue), "one@3 2@-5 @4 ") << "a queue is read as often as one likes";
  queue.clear();
  EXPECT_TRUE(queue.empty());
}

TEST(MessageQueue, CopiesAndMoves) {
  MessageQueue a, b, c{1000};
  a.write({1}, Text{"one"});
  a.write({2}, Count{2});
  a.write({3}, Text{"three"});
  a.copyAllMessages(b);
  EXPECT_EQ(contentOf(b), contentOf(a));
  a.moveMessages(messageId<Text>(), c);
  EXPECT_EQ(contentOf(a), "2@2 ");
  EXPECT_EQ(contentOf(c), "one@1 three@3 ");
  b.copyMessages(messageId<Count>(), c);
  EXPECT_EQ(contentOf(c), "one@1 three@3 2@2 ");
  a.moveAllMessages(b);
  EXPECT_TRUE(a.empty());
  EXPECT_EQ(contentOf(b), "one@1 2@2 three@3 2@2 ");
  b.moveAllMessages(a);
  EXPECT_TRUE(b.empty());
  EXPECT_EQ(contentOf(a), "one@1 2@2 three@3 2@2 ");
  a.moveAllMessages(a);
  EXPECT_EQ(contentOf(a), "one@1 2@2 three@3 2@2 ");
  MessageQueue d = a, e = std::move(a);
  EXPECT_EQ(contentOf(d), contentOf(e));
  EXPECT_EQ(d.capacity(), e.capacity());
  a.write({1}, Count{1});  // A queue that was moved from has no room, and is no danger.
  EXPECT_TRUE(a.empty());
}

TEST(MessageQueue, CrossesAWire) {
  MessageQueue a, b;
  for (int i = 0; i < 4; ++i) a.write({i}, Text{"text"});
  ASSERT_TRUE(b.assign(a.bytes()));
  EXPECT_EQ(contentOf(b), contentOf(a));
  for (std::size_t size = 1; size < a.size(); ++size)
    EXPECT_EQ(b.assign(a.bytes().first(size)), size % (a.size() / 4) == 0);
  MessageQueue small{a.size() - 1};
  EXPECT_FALSE(small.assign(a.bytes()));
}

std::map<std::string, std::uint64_t> droppedOf(const MessageQueue& queue) {
  std::map<std::string, std::uint64_t> counts;
  queue.handleAllMessages([&](const Message& message) {
    DroppedMessages dropped;
    if (message.is<DroppedMessages>() && message.read(dropped))
      for (const DroppedMessage& d : dropped.types) counts[d.type] += d.count;
  });
  return counts;
}

TEST(MessageQueue, DropsWhatDoesNotFitAndSaysSo) {
  MessageQueue queue{200};
  const std::byte* memory = queue.bytes().data();
  int written = 0;
  for (int i = 0; i < 20; ++i) written += queue.write({i}, Count{1.0 * i});
  queue.write({0}, Text{"this does not fit either"});
  EXPECT_EQ(written, 200 / (16 + 12));
  EXPECT_EQ(queue.dropped(), 21u - static_cast<unsigned>(written));
  EXPECT_EQ(contentOf(queue).substr(0, 12), "0@0 1@1 2@2 ") << "what was there stays";
  queue.reportDropped({99});
  EXPECT_TRUE(droppedOf(queue).empty()) << "there is no room for the report";
  queue.clear();
  queue.reportDropped({99});
  const std::map<std::string, std::uint64_t> all{{"Count", 20u - unsigned(written)}, {"Text", 1}};
  EXPECT_EQ(droppedOf(queue), all);
  EXPECT_EQ(queue.dropped(), 0u);
  queue.clear();
  queue.reportDropped({99});
  EXPECT_TRUE(queue.empty()) << "reported once";
  EXPECT_EQ(queue.bytes().data(), memory);
}

TEST(MessageQueue, CountsFewTypesByNameAndAllTogether) {
  MessageQueue queue{1000};
  const std::vector<std::byte> large(2000);
  for (std::uint32_t id = 1; id <= 100; ++id) EXPECT_FALSE(queue.append({id, {}, large}));
  EXPECT_EQ(queue.dropped(), 100u);
  queue.reportDropped({1});
  int types = 0;
  queue.handleAllMessages([&](const Message& message) {
    DroppedMessages dropped;
    ASSERT_TRUE(message.read(dropped));
    ASSERT_EQ(dropped.types.size(), 16u);
    EXPECT_EQ(dropped.types[0].id, 1u);
    EXPECT_EQ(dropped.types[15].id, 0u);
    EXPECT_EQ(dropped.types[15].count, 85u);
    ++types;
  });
  EXPECT_EQ(types, 1);
}

// Whatever is done to it, a queue is what a list of its messages would be, up to its capacity.
TEST(MessageQueue, IsAListOfMessages) {
  Random random{3};
  MessageQueue queue{600};
  std::vector<int> list;
  for (int i = 0; i < 3000; ++i) {
    if (random.chance(0.7)) {
      const bool fits = (list.size() + 1) * 28 <= 600;
      EXPECT_EQ(queue.write({i}, Count{1.0 * i}), fits);
      if (fits) list.push_back(i);
    } else {
      const int divisor = 2 + static_cast<int>(random.index(3));
      std::erase_if(list, [&](int n) { return n % divisor == 0; });
      queue.removeIf([&](const Message& m) { return m.time.ms % divisor == 0; });
    }
    std::string expected;
    for (const int n : list) expected += std::to_string(n) + '@' + std::to_string(n) + ' ';
    ASSERT_EQ(contentOf(queue), expected);
  }
}

// The examples of report E.1: text, four numbers, a handler that copies to another queue.
TEST(MessageStreams, WriteAndReadAsInTheReport) {
  constexpr auto idText = messageId("text"), id4FunnyNumbers = messageId("4FunnyNumbers");
  MessageQueue queue, other;
  OutTextMessage text{queue};
  OutBinaryMessage binary{queue};
  const int numberOfBalls = 3;
  text << "found " << numberOfBalls << " balls.";
  EXPECT_TRUE(text.finishMessage(idText, {1}));
  for (const int first : {1, 5}) {
    binary << first << first + 1;
    binary << first + 2 << 0.5;
    EXPECT_TRUE(binary.finishMessage(id4FunnyNumbers, {2}));
  }
  int sum = 0;
  queue.handleAllMessages([&](const Message& message) {
    if (message.id == idText) other.append(message);
    if (message.id != id4FunnyNumbers) return;
    for (int again = 0; again < 2; ++again) {
      InBinaryMessage in{message};
      int a = 0, b = 0, c = 0;
      double d = 0;
      in >> a >> b >> c >> d;
      EXPECT_TRUE(in && in.eof());
      EXPECT_EQ(d, 0.5);
      sum += a + b + c;
    }
  });
  EXPECT_EQ(sum, 2 * (1 + 2 + 3 + 5 + 6 + 7));
  other.handleAllMessages([&](const Message& message) {
    InTextMessage in{message};
    std::string before, after;
    int number = 0;
    in >> before >> number >> after;
    EXPECT_TRUE(in && in.eof());
    EXPECT_EQ(before + std::to_string(number) + after, "found 3 balls.");
  });
  EXPECT_FALSE(other.empty());
}

TEST(MessageStreams, ReadConfigurationsFromMessages) {
  MessageQueue queue;
  OutTextMessage text{queue};
  text << "[robot]" << endl
       << 0.5 << endl
       << "//"
       << "comment" << endl
       << 2 << endl
       << "[end]";
  EXPECT_TRUE(text.finishMessage(messageId("config"), {}));
  queue.handleAllMessages([](const Message& message) {
    InConfigMessage in{message, "robot"};
    double tilt = 0, roll = 0;
    in >> tilt >> roll;
    EXPECT_TRUE(in && in.eof());
    EXPECT_EQ(tilt, 0.5);
    EXPECT_EQ(roll, 2);
  });
}

TEST(MessageStreams, DropWhatDoesNotFit) {
  MessageQueue queue{40};
  OutTextMessage text{queue};
  text << std::string(100, 'x');
  EXPECT_FALSE(text.finishMessage(1, {}));
  text << 1;
  EXPECT_TRUE(text.finishMessage(1, {}));
  EXPECT_EQ(queue.size(), 17u);
  EXPECT_EQ(queue.dropped(), 1u);
}

}  // namespace
}  // namespace gt
