#include "modules/perception/specialists/PlayerSpecialist.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"

namespace gt {
namespace {

using PlayerSpecialistTest = DrawnBoxes;

TEST_F(PlayerSpecialistTest, RobotsAreFoundByTheirTricots) {
  const auto robot = [](double x, double y, ColorClass tricot) {
    // Legs below, tricot above.
    return std::array{Box{{x - 60, y - 120, 0}, {x + 60, y + 120, 110}, ColorClass::gray},
                      Box{{x - 40, y - 60, 110}, {x + 40, y + 60, 185}, tricot}};
  };
  for (const double distance : {500., 800., 1200., 1800.}) {
    boxes_.clear();
    for (const Box& box : robot(distance, 250, ColorClass::red)) boxes_.push_back(box);
    for (const Box& box : robot(distance, -250, ColorClass::blue)) boxes_.push_back(box);
    look(0, -0.2);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << distance;
    ASSERT_EQ(players_.players[TeamColor::blue].size(), 1u) << distance;
    const Vector2d red = players_.players[TeamColor::red].front();
    const Vector2d blue = players_.players[TeamColor::blue].front();
    EXPECT_LT((red - Vector2d{distance, 250}).norm(), 0.2 * distance) << distance;
    EXPECT_LT((blue - Vector2d{distance, -250}).norm(), 0.2 * distance) << distance;
  }
}

// A shirt reaches higher than the camera, a tricot does not.
TEST_F(PlayerSpecialistTest, WhatReachesAboveTheHorizonIsNoTricot) {
  for (const double top : {185., 320.}) {
    boxes_ = {{{840, -120, 0}, {960, 120, 110}, ColorClass::gray},
              {{860, -60, 110}, {940, 60, top}, ColorClass::red}};
    look(0, -0.1);
    EXPECT_EQ(players_.players[TeamColor::red].size(), top < 200 ? 1u : 0u) << top;
  }
}

// Green is seen between the legs, and the nearest foot stands beside the tricot.
TEST_F(PlayerSpecialistTest, ARobotIsAsFarAsItsNearestFoot) {
  for (const bool left : {true, false}) {
    const double nearer = left ? 60 : -90, farther = left ? -60 : 30;
    boxes_ = {{{900, -60, 110}, {1000, 60, 185}, ColorClass::red},
              {{820, nearer, 0}, {850, nearer + 30, 110}, ColorClass::gray},
              {{1040, farther, 0}, {1070, farther + 30, 110}, ColorClass::gray}};
    look(0, -0.25);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u);
    EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 890, 60);
    EXPECT_TRUE(players_.players[TeamColor::blue].empty());
  }
}

TEST_F(PlayerSpecialistTest, ARobotSoCloseThatItsFeetAreNotSeenIsJudgedBySize) {
  boxes_ = {{{330, -150, 60}, {400, 150, 110}, ColorClass::gray},
            {{330, -62, 110}, {400, 62, 162}, ColorClass::blue},
            {{330, -150, 0}, {400, 150, 60}, ColorClass::gray}};
  look(0, 0.1);
  ASSERT_EQ(players_.players[TeamColor::blue].size(), 1u);
  EXPECT_NEAR(players_.players[TeamColor::blue].front().x(), 390, 120);
}

// The middle of an ERS-210 that comes towards the camera is 105 mm behind its forefeet.
TEST_F(PlayerSpecialistTest, ARobotIsWhereItsMiddleIs) {
  for (const double middle : {600., 900., 1200.}) {
    boxes_ = {{{middle - 105, -75, 0}, {middle - 65, -35, 110}, ColorClass::gray},
              {{middle - 105, 35, 0}, {middle - 65, 75, 110}, ColorClass::gray},
              {{middle + 40, -75, 0}, {middle + 80, -35, 110}, ColorClass::gray},
              {{middle + 40, 35, 0}, {middle + 80, 75, 110}, ColorClass::gray},
              {{middle - 85, -45, 110}, {middle + 85, 45, 185}, ColorClass::red}};
    look(0, -0.25);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << middle;
    EXPECT_NEAR(players_.players[TeamColor::red].front().x(), middle, 30);
  }
}

// An ERS-210 seen from the side: sides and back in tricot, feet at both ends.
std::vector<Box> robotAcross(double x, double y) {
  return {{{x - 40, y - 100, 0}, {x + 40, y - 70, 85}, ColorClass::gray},
          {{x - 40, y + 70, 0}, {x + 40, y + 100, 85}, ColorClass::gray},
          {{x - 40, y - 100, 85}, {x + 40, y - 70, 140}, ColorClass::red},
          {{x - 40, y + 70, 85}, {x + 40, y + 100, 140}, ColorClass::red},
          {{x - 40, y - 70, 140}, {x + 40, y + 70, 212}, ColorClass::red}};
}

// The height between foot and tricot is right even if the matrix is not.
TEST_F(PlayerSpecialistTest, TheHeightOfARobotCorrectsATiltedMatrix) {
  for (const double error : {-1.5, 1.5}) {
    boxes_ = robotAcross(1900, 0);
    look(0, -0.1);
    matrix_ = cameraAt({90, 10, cameraHeight_}, 0, -0.1 + fromDegrees(error), 0);
    percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << error;
    EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 1900, 230) << error;
  }
}

// A tricot's lower end is at a leg, whose height is known.
TEST_F(PlayerSpecialistTest, ARobotWithoutFeetInTheImageIsAsFarAsTheLowerEndOfItsTricot) {
  for (const double distance : {600., 700., 800.}) {
    boxes_ = robotAcross(distance, 0);
    look(0, 0.2 - 60 / distance);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << distance;
    EXPECT_NEAR(players_.players[TeamColor::red].front().x(), distance, 105) << distance;
  }
}

// Report 3.2.6. All that is seen of such a robot may be a part of its back.
TEST_F(PlayerSpecialistTest, ATouchedRobotIsAsFarAsTheUpperEndOfItsTricot) {
  cameraHeight_ = 250;
  boxes_ = {{{220, -40, 195}, {240, 40, 212}, ColorClass::red},
            {{220, -40, 0}, {240, 40, 195}, ColorClass::gray}};
  look(0, 0.05);
  ASSERT_EQ(players_.players[TeamColor::red].size(), 1u);
  EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 270, 40);
}

// Several lines meet each foot. What is as thin as half a pixel is met by one of them or by none.
TEST_F(PlayerSpecialistTest, WhatStandsAloneBeforeARobotIsNoFootOfIt) {
  for (int y = 40; y < 60; y += 3) {
    boxes_ = robotAcross(1500, 0);
    boxes_.push_back({{1000, y - 1.5, 0}, {1010, y + 1.5, 60}, ColorClass::gray});
    look(0, -0.2);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << y;
    EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 1500, 150) << y;
  }
}

// Its shaded side looks like a leg, and is seen below the orange.
TEST_F(PlayerSpecialistTest, ABallBeforeARobotIsNoFootOfIt) {
  boxes_ = robotAcross(1500, 0);
  boxes_.push_back({{1000, -20, 35}, {1080, 60, 84}, ColorClass::orange});
  boxes_.push_back({{1000, -20, 0}, {1080, 60, 35}, ColorClass::black});
  look(0, -0.2);
  ASSERT_EQ(players_.players[TeamColor::red].size(), 1u);
  EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 1500, 200);
}

// The report ignores heads: far below one, a foot need not be the robot's.
TEST_F(PlayerSpecialistTest, AHeadAloneIsNoTricot) {
  boxes_ = {{{900, -15, 210}, {930, 15, 240}, ColorClass::red},
            {{840, -60, 0}, {960, 60, 210}, ColorClass::gray}};
  look(0, -0.1);
  EXPECT_TRUE(players_.players[TeamColor::red].empty());
}

}  // namespace
}  // namespace gt
