#include "foxglove/WebSocketOutbox.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

using Outcome = WebSocketOutbox::Outcome;

WebSocketMessage letter(char name, std::size_t size = 1000) {
  return {.body = std::make_shared<const std::string>(size, name)};
}

class WebSocketOutboxTest : public ::testing::Test {
 protected:
  Outcome put(WebSocketMessage message) { return outbox.put(std::move(message), 5000); }
  /// The names of all that is sent, in that order.
  std::string sent() {
    std::string names;
    while (const auto message = outbox.take()) names += message->body->front();
    return names;
  }

  WebSocketOutbox outbox;
};

TEST_F(WebSocketOutboxTest, SendsWhatIsUrgentFirst) {
  EXPECT_EQ(put(letter('a')), Outcome::first);
  EXPECT_EQ(put(letter('b')), Outcome::waits);
  for (const char name : {'c', 'd'}) {
    auto message = letter(name);
    message.urgent = true;
    EXPECT_EQ(put(std::move(message)), Outcome::waits);
  }
  EXPECT_EQ(put(letter('e', 100)), Outcome::waits);
  EXPECT_EQ(sent(), "cdabe");
}

TEST_F(WebSocketOutboxTest, TakesNothingUntilThereIsRoomAgain) {
  EXPECT_TRUE(outbox.takes(0));
  for (const char name : {'a', 'b', 'c', 'd'}) put(letter(name));
  EXPECT_TRUE(outbox.takes(0));
  EXPECT_EQ(put(letter('e')), Outcome::dropped);
  EXPECT_FALSE(outbox.takes(0));
  EXPECT_FALSE(outbox.takes(7)) << "it would be dropped, too";
  EXPECT_TRUE(outbox.take());
  EXPECT_TRUE(outbox.takes(0));
}

TEST_F(WebSocketOutboxTest, TakesOneOfANumberAtATime) {
  const auto numbered = [](char name) {
    auto message = letter(name);
    message.newestOf = 7;
    return message;
  };
  put(letter('a'));
  EXPECT_TRUE(outbox.takes(7));
  put(numbered('b'));
  EXPECT_FALSE(outbox.takes(7));
  EXPECT_TRUE(outbox.takes(8));
  EXPECT_EQ(put(numbered('c')), Outcome::dropped);
  EXPECT_EQ(sent(), "ac");
  EXPECT_TRUE(outbox.takes(7));
}

TEST_F(WebSocketOutboxTest, IsFullOfWhatMustNotBeDropped) {
  auto message = letter('a', 50'000);
  message.droppable = false;
  EXPECT_EQ(put(message), Outcome::first);
  EXPECT_EQ(put(message), Outcome::waits);
  EXPECT_EQ(put(message), Outcome::full);
}

}  // namespace
}  // namespace gt
