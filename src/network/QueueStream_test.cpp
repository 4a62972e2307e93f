#include "network/QueueStream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <thread>

#include "support/TestWire.h"

namespace gt {
namespace {

using testing::NumberPackage;
using testing::patience;
namespace newer = testing::newer;

constexpr std::size_t capacity = 1 << 20;
constexpr std::chrono::milliseconds impatience{50};  // for answers that never come

class QueueStreamTest : public ::testing::Test {
 protected:
  QueueStreamTest() {
    int ends[2];
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    here = FileDescriptor{ends[0]};
    there = FileDescriptor{ends[1]};
  }
  QueueStream stream(std::chrono::milliseconds waiting = patience) {
    return {std::move(here), known, capacity, waiting};
  }
  void sendRaw(const std::string& bytes) const {
    EXPECT_EQ(::send(there.number(), bytes.data(), bytes.size(), 0),
              static_cast<ssize_t>(bytes.size()));
  }
  static MessageQueue numbers(std::initializer_list<int> all) {
    MessageQueue queue{capacity};
    for (const int number : all) queue.write(Time{number}, NumberPackage{number});
    return queue;
  }
  static std::vector<int> numbersIn(const MessageQueue& queue) {
    std::vector<int> all;
    queue.handleAllMessages([&](const Message& message) {
      NumberPackage package;
      EXPECT_TRUE(message.is<NumberPackage>() && message.read(package));
      all.push_back(static_cast<int>(package.number));
    });
    return all;
  }
  std::string errorOf(const std::string& bytes) {
    QueueStream own = stream();
    sendRaw(bytes);
    const auto done = own.receive(messages);
    return done ? "" : done.error().text();
  }

  const Vocabulary known{{&representation<NumberPackage>()}};
  FileDescriptor here, there;
  MessageQueue messages{capacity};
};

TEST_F(QueueStreamTest, HandsOverQueuesInTheirOrder) {
  QueueStream one = stream(), other{std::move(there), known, capacity, patience};
  ASSERT_TRUE(one.introduce(numbers({1, 2})));
  ASSERT_TRUE(one.send(numbers({})));
  ASSERT_TRUE(one.send(numbers({3})));
  for (const std::vector<int>& expected : {std::vector{1, 2}, {}, {3}}) {
    const auto came = other.receive(messages);
    ASSERT_TRUE(came && *came);
    EXPECT_EQ(numbersIn(messages), expected);
  }
}

TEST_F(QueueStreamTest, HandsOverMoreThanTheSocketHolds) {
  struct Bytes {
    std::vector<std::uint8_t> bytes;
    static constexpr auto fields() { return Fields{field<&Bytes::bytes>()}; }
  };
  QueueStream one = stream(), other{std::move(there), known, 4 * capacity, patience};
  MessageQueue large{capacity};
  ASSERT_TRUE(large.write(Time{}, Bytes{std::vector<std::uint8_t>(capacity - 100, 7)}));
  std::thread sender{[&] { EXPECT_TRUE(one.send(large)); }};
  const auto came = other.receive(messages);
  sender.join();
  ASSERT_TRUE(came && *came);
  EXPECT_TRUE(std::ranges::equal(messages.bytes(), large.bytes()));
}

TEST_F(QueueStreamTest, ReadsWhatAnotherVersionSends) {
  const Vocabulary theirs{{&representation<newer::NumberPackage>()}};
  QueueStream one = stream(), other{std::move(there), theirs, capacity, patience};
  newer::NumberPackage package;
  package.number = 4711;
  MessageQueue queue{capacity};
  queue.write(Time{5}, package);
  ASSERT_TRUE(other.introduce(queue));
  const auto came = one.receive(messages);
  ASSERT_TRUE(came && *came);
  EXPECT_EQ(numbersIn(messages), std::vector{4711});
}

TEST_F(QueueStreamTest, NoticesTheEndOfTheOtherProgram) {
  QueueStream own = stream();
  there = {};
  const auto came = own.receive(messages);
  ASSERT_TRUE(came);
  EXPECT_FALSE(*came);
  EXPECT_FALSE(own.send(numbers({1})));
}

TEST_F(QueueStreamTest, DoesNotWaitForeverForAnAnswer) {
  QueueStream own = stream(impatience);
  const auto came = own.receive(messages);
  ASSERT_FALSE(came);
  EXPECT_EQ(came.error().what, "has not answered for 50 ms");
  Result<void> sent;
  for (int i = 0; i < 1000 && sent; ++i) {
    MessageQueue queue{capacity};
    while (queue.write(Time{}, NumberPackage{i})) continue;
    sent = own.send(queue);
  }
  EXPECT_FALSE(sent) << "nobody reads";
}

TEST_F(QueueStreamTest, RefusesWhatIsNoQueue) {
  EXPECT_THAT(errorOf(std::string("\xff\xff\xff\x7f", 4)), ::testing::HasSubstr("more than"));
}

TEST_F(QueueStreamTest, RefusesWhatIsNoMessage) {
  EXPECT_THAT(errorOf(std::string("\x03\0\0\0abc", 7)), ::testing::HasSubstr("no queue"));
}

TEST_F(QueueStreamTest, RefusesHalfAQueue) {
  QueueStream own = stream();
  sendRaw(std::string("\x20\0\0\0abc", 7));
  there = {};
  const auto came = own.receive(messages);
  ASSERT_FALSE(came);
  EXPECT_EQ(came.error().what, "has ended within a queue");
}

}  // namespace
}  // namespace gt
