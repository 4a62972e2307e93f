#include "match/GameControllerChoice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gt {
namespace {

using ::testing::ElementsAre;

/// A game controller's message of a version with that number.
std::vector<std::byte> numbered(int packet, int version = 12) {
  std::vector<std::byte> bytes(54);
  const std::string head{"RGme"};
  for (std::size_t i = 0; i < head.size(); ++i) bytes[i] = static_cast<std::byte>(head[i]);
  bytes[4] = static_cast<std::byte>(version);
  bytes[5] = static_cast<std::byte>(packet);
  return bytes;
}

class GameControllerChoiceTest : public ::testing::Test {
 protected:
  /// Whether a message is followed that comes so many ms after the one before it.
  bool follows(const std::string& sender, int packet, std::int64_t after = 500) {
    time_ += after;
    return choice.take({numbered(packet), sender, time_}).has_value();
  }
  void refuse(const std::string& sender, const std::vector<std::byte>& bytes) {
    EXPECT_FALSE(choice.take({bytes, sender, time_}));
  }

  GameControllerChoice choice;
  std::int64_t time_ = 1000;
};

TEST_F(GameControllerChoiceTest, FollowsTheFirstUntilItIsSilent) {
  EXPECT_TRUE(follows("a:1", 0));
  EXPECT_THAT(choice.takeNews(), ElementsAre("game controller a:1 leads the game"));
  for (int i = 1; i < 10; ++i) {
    EXPECT_FALSE(follows("b:2", 100 + i));
    EXPECT_TRUE(follows("a:1", i));
  }
  EXPECT_THAT(choice.takeNews(), ElementsAre("game controller b:2 is not followed: a:1 leads"));
  EXPECT_FALSE(follows("b:2", 120, 1999));
  EXPECT_TRUE(follows("b:2", 121, 1));
  EXPECT_THAT(choice.takeNews(),
              ElementsAre("game controller b:2 leads the game, since a:1 is silent"));
  EXPECT_FALSE(follows("a:1", 11));
  EXPECT_THAT(choice.takeNews(), ElementsAre("game controller a:1 is not followed: b:2 leads"));
}

TEST_F(GameControllerChoiceTest, PassesOverWhatWasOvertaken) {
  EXPECT_TRUE(follows("a:1", 50));
  EXPECT_FALSE(follows("a:1", 49));
  EXPECT_TRUE(follows("a:1", 50)) << "the same again, or one that does not count";
  EXPECT_TRUE(follows("a:1", 51));
  EXPECT_TRUE(follows("a:1", 178));
  EXPECT_TRUE(follows("a:1", 255));
  EXPECT_TRUE(follows("a:1", 1)) << "255 is followed by 0";
  EXPECT_FALSE(follows("a:1", 254));
  EXPECT_TRUE(follows("a:1", 200, 2000)) << "it was started again";
}

TEST_F(GameControllerChoiceTest, FollowsVersionsThatDoNotCount) {
  std::vector<std::byte> bytes(120);
  std::ranges::copy(numbered(0, 4), bytes.begin());
  bytes[5] = std::byte{};
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(choice.take({bytes, "a:1", 1000}));
}

TEST_F(GameControllerChoiceTest, ReportsOnceWhatItDoesNotUnderstand) {
  auto cut = numbered(0);
  cut.pop_back();
  auto garbage = numbered(0);
  garbage[0] = std::byte{'X'};
  for (int i = 0; i < 3; ++i) {
    refuse("a:1", numbered(i, 13));
    refuse("a:1", cut);
    refuse("b:2", cut);
    refuse("b:2", garbage);
  }
  EXPECT_THAT(
      choice.takeNews(),
      ElementsAre("game controller a:1 is not followed: version 13 is none of 4, 7 to 9, 11, 12, "
                  "14 to 20",
                  "game controller a:1 is not followed: size 53 bytes instead of 54 of version 12",
                  "game controller b:2 is not followed: size 53 bytes instead of 54 of version 12",
                  "game controller b:2 is not followed: header is not RGme"));
  EXPECT_TRUE(follows("a:1", 0));
}

TEST_F(GameControllerChoiceTest, ReportsOnlySoMany) {
  for (int i = 0; i < 1000; ++i) refuse("a:" + std::to_string(i), numbered(0, 13));
  const auto news = choice.takeNews();
  ASSERT_EQ(news.size(), 33u);
  EXPECT_EQ(news.back(), "further game controllers that are not followed are not reported");
  EXPECT_TRUE(follows("b:2", 0));
  EXPECT_FALSE(follows("c:3", 0));
  EXPECT_THAT(choice.takeNews(), ElementsAre("game controller b:2 leads the game"));
}

}  // namespace
}  // namespace gt
