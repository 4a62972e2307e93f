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

}  // namespace
}  // namespace gt
