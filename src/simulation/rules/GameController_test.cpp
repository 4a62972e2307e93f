#include "simulation/rules/GameController.h"

#include <gtest/gtest.h>

#include <string>

namespace gt {
namespace {

/// Bytes written as numbers of some width, little endian.
class Bytes {
 public:
  Bytes& text(const std::string& letters) {
    for (const char c : letters) bytes_.push_back(static_cast<std::byte>(c));
    return *this;
  }
  Bytes& n(int width, std::initializer_list<int> values) {
    for (const int value : values)
      for (int i = 0; i < width; ++i) bytes_.push_back(static_cast<std::byte>(value >> 8 * i));
    return *this;
  }
  Bytes& zeros(int count) {
    bytes_.resize(bytes_.size() + static_cast<std::size_t>(count));
    return *this;
  }
  std::vector<std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// Second half, playing, the red team 7 kicks off, 3:1 against the blue team 5; red 2 holds the
/// ball, blue 4 pushes; 90 s are left.
std::vector<std::byte> message(int version) {
  Bytes b;
  b.text("RGme");
  switch (version) {
    case 4:
      b.n(4, {4, 3, 0, 1, 90, 0, 0}).n(4, {5, 0, 1}).zeros(24).n(4, {3, 30});
      return b.n(4, {7, 1, 3}).zeros(8).n(4, {1, 30}).zeros(16).bytes();
    case 7:
      b.n(4, {7}).n(1, {4, 3, 0, 1, 0, 0}).n(2, {0}).n(4, {90});
      b.n(1, {5, 0, 0, 1}).zeros(12).n(2, {2, 30}).zeros(28);
      return b.n(1, {7, 1, 1, 3}).zeros(4).n(2, {1, 30}).zeros(36).bytes();
    case 8:
      b.n(1, {8, 9, 5, 3, 0, 1, 0, 0}).n(2, {0, 90, 0});
      b.n(1, {5, 0, 1, 0}).n(2, {0}).zeros(42 + 6).n(1, {2, 30}).zeros(14);
      return b.n(1, {7, 1, 3, 0}).n(2, {0}).zeros(42 + 2).n(1, {1, 30}).zeros(18).bytes();
    case 9:
      b.n(2, {9}).n(1, {9, 5, 0, 3, 0, 7, 0, 0}).n(2, {0, 90, 0});
      b.n(1, {5, 2, 1, 0}).n(2, {0}).zeros(84 + 6).n(1, {2, 30}).zeros(14);
      return b.n(1, {7, 3, 3, 0}).n(2, {0}).zeros(84 + 2).n(1, {1, 30}).zeros(18).bytes();
    case 11:
      b.n(2, {11}).n(1, {9, 5, 0, 0, 0, 3, 0, 0, 7, 0}).n(2, {0, 90, 0});
      b.n(1, {5, 0, 1, 0}).n(2, {0}).zeros(6).n(1, {2, 30}).zeros(4);
      return b.n(1, {7, 1, 3, 0}).n(2, {0}).zeros(2).n(1, {1, 30}).zeros(8).bytes();
    case 12:
      b.n(1, {12, 9, 5, 0, 0, 0, 3, 0, 0, 7}).n(2, {90, 0});
      b.n(1, {5, 0, 1, 0}).n(2, {0}).zeros(6).n(1, {2, 30}).zeros(4);
      return b.n(1, {7, 1, 3, 0}).n(2, {0}).zeros(2).n(1, {1, 30}).zeros(8).bytes();
    case 14:
      b.n(1, {14, 9, 7, 0, 0, 0, 3, 0, 0, 7}).n(2, {90, 0});
      b.n(1, {5, 0, 1, 0}).n(2, {0, 9}).zeros(6).n(1, {2, 30}).zeros(6);
      return b.n(1, {7, 1, 3, 0}).n(2, {0, 9}).zeros(2).n(1, {1, 30}).zeros(10).bytes();
    case 19:
      b.n(1, {19, 9, 7, 0, 0, 0, 3, 0, 0, 7}).n(2, {90, 0});
      b.n(1, {5, 0, 3, 1, 1, 0}).n(2, {0, 9}).zeros(12).n(1, {9, 30, 0, 1}).zeros(64);
      return b.n(1, {7, 1, 3, 1, 3, 0}).n(2, {0, 9}).zeros(4).n(1, {6, 30, 1, 0}).zeros(72).bytes();
    case 20:
      b.n(1, {20, 9, 7, 0, 0, 0, 3, 0, 0, 7}).n(2, {90, 0});
      b.n(1, {5, 0, 3, 1, 1, 0}).n(2, {0, 9}).zeros(9).n(1, {10, 30, 0}).zeros(48);
      return b.n(1, {7, 1, 3, 1, 3, 0}).n(2, {0, 9}).zeros(3).n(1, {7, 30, 0}).zeros(54).bytes();
    default:
      b.n(1, {version, 9, 7, 0, 0, 0, 3, 0, 0, 7}).n(2, {90, 0});
      b.n(1, {5, 0, 3, 1, 1, 0}).n(2, {0, 9}).zeros(6).n(1, {2, 30}).zeros(32);
      return b.n(1, {7, 1, 3, 1, 3, 0}).n(2, {0, 9}).zeros(2).n(1, {1, 30}).zeros(36).bytes();
  }
}

TEST(GameController, AllVersionsSayTheSame) {
  for (const int version : {4, 7, 8, 9, 11, 12, 14, 15, 16, 17, 18, 19, 20}) {
    const auto read = parseGameController(message(version));
    ASSERT_TRUE(read) << version << ": " << read.error().text();
    EXPECT_EQ(read->version, version);
    EXPECT_EQ(read->packet, version < 8 ? std::nullopt : std::optional{9}) << version;
    EXPECT_EQ(read->state, GameState::playing) << version;
    EXPECT_FALSE(read->firstHalf) << version;
    EXPECT_EQ(read->kickOff, TeamColor::red) << version;
    EXPECT_EQ(read->secondsLeft, 90) << version;
    using enum Penalty;
    const GameControllerMessage::Team red{7, 3, {none, ballHolding, none, none}},
        blue{5, 1, {none, none, none, fieldPlayerCharge}};
    EXPECT_EQ(read->teams[TeamColor::red], red) << version;
    EXPECT_EQ(read->teams[TeamColor::blue], blue) << version;
  }
}

TEST(GameController, TeamsAreToldApartByColor) {
  auto bytes = message(15);
  bytes[19] = std::byte{8};  // brown, first
  bytes[69] = std::byte{9};  // gray, second
  auto read = parseGameController(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->teams[TeamColor::blue].number, 5);
  bytes[69] = std::byte{0};  // the second is blue
  read = parseGameController(bytes);
  EXPECT_EQ(read->teams[TeamColor::red].number, 5);
  bytes[13] = std::byte{255};  // nobody kicks off
  EXPECT_FALSE(parseGameController(bytes)->kickOff);
}

TEST(GameController, AStoppedGameStands) {
  for (const int version : {19, 20}) {
    auto bytes = message(version);
    bytes[8] = std::byte{1};
    EXPECT_EQ(parseGameController(bytes)->state, GameState::set) << version;
  }
}

TEST(GameController, WhatIsNoMessageIsRefused) {
  const auto good = message(12);
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(parseGameController(std::span{good}.first(size)));
  for (const std::size_t at : {0, 3, 4, 10}) {
    auto bad = good;
    bad[at] = std::byte{77};
    EXPECT_FALSE(parseGameController(bad)) << at;
  }
  const auto error = parseGameController(std::span{good}.first(53));
  EXPECT_NE(error.error().text().find("53 bytes instead of 54 of version 12"), std::string::npos);
  for (const int unknown : {5, 10, 13, 21}) {
    auto bad = good;
    bad[4] = static_cast<std::byte>(unknown);
    EXPECT_EQ(parseGameController(bad).error().field, "version") << unknown;
  }
}

TEST(GameController, AnswersAreWhatEachVersionHears) {
  const GameControllerAnswer answer{7, 3, true, {0.5, 100, -200}, 2.5, {10, 20}};
  EXPECT_TRUE(answerBytes(answer, 4).empty());
  EXPECT_EQ(answerBytes(answer, 7), Bytes{}.text("RGrt").n(4, {1}).n(2, {7, 3}).n(4, {2}).bytes());
  for (const int version : {8, 9})
    EXPECT_EQ(answerBytes(answer, version), Bytes{}.text("RGrt").n(1, {2, 7, 3, 2}).bytes());
  EXPECT_EQ(answerBytes(answer, 11), answerBytes(answer, 12));
  EXPECT_EQ(answerBytes(answer, 12), Bytes{}.text("RGrt").n(1, {3, 7, 3, 0}).bytes());
  const auto bytes = answerBytes(answer, 18);
  ASSERT_EQ(bytes.size(), 32u);
  EXPECT_EQ(bytes[4], std::byte{4});
  EXPECT_EQ(bytes[5], std::byte{3});
  EXPECT_EQ(bytes[6], std::byte{7});
  EXPECT_EQ(bytes[7], std::byte{1});
  const std::vector<std::byte> x{bytes.begin() + 8, bytes.begin() + 12};
  EXPECT_EQ(x, Bytes{}.n(4, {0x42c80000}).bytes());  // 100.0f
}

}  // namespace
}  // namespace gt
