#include "modules/perception/scanning/IndicationScanner.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnImage.h"

namespace gt {
namespace {

/// A column of an image of stripes below the horizon, with color classes from top to bottom.
class Column {
 public:
  Column() {
    matrix_ = cameraAt({0, 0, 180}, 0, -0.3, 0);
    image_.info = matrix_.info;
    image_.allocate();
    for (std::size_t c = 0; c < enumCount<ColorClass>; ++c)
      colors_.classes[ColorTable64::index(static_cast<std::uint8_t>(8 * c), 128, 128)] =
          static_cast<ColorClass>(c);
    line_.start = {80.5, 0.5};
    line_.step = {0, 1};
    line_.length = image_.info.height;
    line_.whole = line_.fromBorder = line_.toBorder = true;
  }
  /// Of a line that begins and ends within the image.
  void endWithinTheImage() { line_.fromBorder = line_.toBorder = false; }

  /// Scans so many pixels of each class; the last one goes on to the end.
  const IndicationScanner& scan(const std::vector<std::pair<ColorClass, int>>& runs) {
    int y = 0;
    for (const auto& [color, length] : runs)
      for (int i = 0; (i < length || &color == &runs.back().first) && y < line_.length; ++i, ++y)
        for (int x = 0; x < image_.info.width; ++x)
          image_.at(x, y) = {static_cast<std::uint8_t>(8 * static_cast<int>(color)), 128, 128, 0};
    const Horizon horizon = horizonOf(matrix_);
    scanner_.clear();
    scanner_.scan({image_, colors_, matrix_, horizon}, line_, FieldDimensions{});
    return scanner_;
  }

 private:
  CameraMatrix matrix_;
  Image image_;
  ColorTable64 colors_;
  ScanLine line_;
  IndicationScanner scanner_;
};

using enum ColorClass;

TEST(IndicationScanner, FindsABallOfAtLeastAsMuchOrangeAsRed) {
  Column column;
  const auto& found = column.scan({{white, 50}, {orange, 8}, {red, 6}, {green, 1}});
  ASSERT_EQ(found.balls.size(), 1u);
  EXPECT_EQ(found.balls[0].orange, 8);
  EXPECT_NEAR(found.balls[0].upper.y(), 50, 1e-9);
  EXPECT_NEAR(found.balls[0].lower.y(), 64, 1e-9);
  EXPECT_EQ(found.balls[0].above, white);
  EXPECT_EQ(found.balls[0].below, green);
  EXPECT_TRUE(found.players.empty());
  EXPECT_TRUE(column.scan({{white, 50}, {orange, 4}, {red, 12}, {green, 1}}).balls.empty());
  EXPECT_EQ(column.scan({{white, 50}, {orange, 4}, {red, 12}, {green, 1}}).players.size(), 1u);
}

TEST(IndicationScanner, TellsFlagsByTheColorNextToPink) {
  Column column;
  for (const FlagColors& flag : flagColors) {
    const auto& found = column.scan({{noColor, 20}, {flag.upper, 8}, {flag.lower, 8}, {white, 1}});
    ASSERT_EQ(found.flags.size(), 1u);
    EXPECT_EQ(colorsOf(found.flags[0].type), flag);
    EXPECT_NEAR(found.flags[0].position.y(), 28, 0.6);
  }
  EXPECT_TRUE(
      column.scan({{noColor, 20}, {pink, 8}, {noColor, 9}, {yellow, 8}, {white, 1}}).flags.empty())
      << "too far from each other";
}

TEST(IndicationScanner, AGoalStandsOnTheField) {
  Column column;
  const auto& found = column.scan({{noColor, 20}, {skyblue, 40}, {green, 1}});
  ASSERT_EQ(found.goals.size(), 1u);
  EXPECT_EQ(found.goals[0].color, GoalColor::skyblue);
  EXPECT_TRUE(found.goals[0].meetsField);
  EXPECT_NEAR(found.goals[0].foot.y(), 60, 0.6);
  EXPECT_TRUE(column.scan({{noColor, 20}, {yellow, 2}, {green, 1}}).goals.empty()) << "too small";
}

TEST(IndicationScanner, AGoalWhoseFootIsHiddenNeedsARobotThere) {
  Column column;
  const auto goalsAbove = [&](const std::vector<std::pair<ColorClass, int>>& what) {
    std::vector<std::pair<ColorClass, int>> runs{{noColor, 20}, {skyblue, 20}};
    runs.insert(runs.end(), what.begin(), what.end());
    runs.push_back({green, 1});
    return column.scan(runs).goals.size();
  };
  EXPECT_EQ(goalsAbove({{red, 8}, {gray, 22}}), 1u);
  EXPECT_EQ(goalsAbove({{red, 3}, {black, 3}, {gray, 24}}), 1u);
  EXPECT_EQ(goalsAbove({{gray, 10}, {black, 6}, {gray, 14}}), 0u) << "black legs of people";
  EXPECT_EQ(goalsAbove({{gray, 30}}), 0u) << "a shirt above a wall in the shade";
  EXPECT_EQ(goalsAbove({{red, 5}, {gray, 25}}), 0u);
  EXPECT_EQ(goalsAbove({{gray, 14}, {red, 16}}), 0u) << "too far below";
}

TEST(IndicationScanner, AGoalIsNotHigherThanGoalsAreThere) {
  Column column;
  const GoalIndication& low = column.scan({{noColor, 18}, {skyblue, 12}, {green, 1}}).goals[0];
  EXPECT_TRUE(low.topKnown);
  EXPECT_NEAR(low.top.y(), 18.5, 1e-9);
  const GoalIndication& high = column.scan({{noColor, 1}, {skyblue, 29}, {green, 1}}).goals[0];
  EXPECT_FALSE(high.topKnown);
  EXPECT_NEAR(high.top.y(), 18, 3) << "as high as a goal whose foot is there";
}

TEST(IndicationScanner, GreenReachesUpToWhatIsNeitherGreenNorALine) {
  Column column;
  ASSERT_EQ(column.scan({{gray, 60}, {green, 1}}).greens.size(), 1u);
  EXPECT_NEAR(column.scan({{gray, 60}, {green, 1}}).greens[0].begin.y(), 60, 0.1);
  const auto begin = column.scan({{gray, 60}, {green, 30}, {white, 2}, {green, 1}}).greens[0].begin;
  EXPECT_NEAR(begin.y(), 60, 0.1) << "a line is a gap";
  const auto wide = column.scan({{gray, 40}, {green, 20}, {white, 30}, {green, 1}}).greens[0].begin;
  EXPECT_NEAR(wide.y(), 90, 0.1) << "nine times as wide as a line there";
}

// Single pixels of a ball have wrong classes. Many of them may have none.
TEST(IndicationScanner, BridgesSmallGapsInABall) {
  Column column;
  const auto balls = [&](ColorClass color, int gap) {
    return column.scan({{white, 50}, {orange, 4}, {color, gap}, {orange, 4}, {green, 1}}).balls;
  };
  ASSERT_EQ(balls(green, 2).size(), 1u);
  EXPECT_EQ(balls(green, 2)[0].orange, 8);
  EXPECT_NEAR(balls(green, 2)[0].lower.y(), 60, 1e-9);
  EXPECT_EQ(balls(green, 3).size(), 2u);
  ASSERT_EQ(balls(noColor, 10).size(), 1u) << "two more than twice as many as the orange ones";
  EXPECT_EQ(balls(noColor, 10)[0].orange, 8);
  EXPECT_EQ(balls(noColor, 11).size(), 2u);
  const auto& specks = column.scan(
      {{white, 50}, {orange, 4}, {noColor, 2}, {gray, 1}, {noColor, 2}, {gray, 2}, {orange, 4}});
  EXPECT_EQ(specks.balls.size(), 2u) << "three pixels of another color";
  const auto& mixed =
      column.scan({{white, 50}, {orange, 4}, {gray, 2}, {red, 2}, {gray, 2}, {orange, 4}});
  EXPECT_EQ(mixed.balls.size(), 1u) << "red between them is ball";
}

TEST(IndicationScanner, ABallIsTwoOrangePixelsAtLeastAndAsMuchOrangeAsRed) {
  Column column;
  EXPECT_EQ(column.scan({{white, 50}, {orange, 2}, {green, 1}}).balls.size(), 1u);
  EXPECT_EQ(column.scan({{white, 50}, {orange, 1}, {green, 1}}).balls.size(), 0u);
  EXPECT_EQ(column.scan({{white, 50}, {orange, 8}, {red, 8}, {green, 1}}).balls.size(), 1u);
  EXPECT_EQ(column.scan({{white, 50}, {orange, 8}, {red, 9}, {green, 1}}).balls.size(), 0u);
}

TEST(IndicationScanner, TheImageCutsABallOff) {
  Column column;
  const BallSegment high = column.scan({{orange, 30}, {green, 1}}).balls.at(0);
  EXPECT_FALSE(high.upperKnown);
  EXPECT_TRUE(high.lowerKnown);
  const BallSegment low = column.scan({{green, 100}, {orange, 1}}).balls.at(0);
  EXPECT_TRUE(low.upperKnown);
  EXPECT_FALSE(low.lowerKnown);
  EXPECT_NEAR(low.lower.y(), 144, 1e-9);
}

TEST(IndicationScanner, ATricotHasItsTeamsColorAndItsEnds) {
  Column column;
  for (const auto& [color, team] : {std::pair{red, TeamColor::red}, {blue, TeamColor::blue}})
    for (int begin = 40; begin < 60; ++begin)
      for (const int length : {1, 3, 8, 9}) {
        const auto& found = column.scan({{gray, begin}, {color, length}, {black, 9}, {green, 1}});
        ASSERT_EQ(found.players.size(), 1u) << begin;
        const PlayerIndication& player = found.players[0];
        EXPECT_EQ(player.team, team);
        EXPECT_EQ(player.pixels, length);
        EXPECT_NEAR(player.upper.y(), begin, 1e-9);
        EXPECT_NEAR(player.lower.y(), begin + length, 1e-9);
        EXPECT_TRUE(player.upperKnown && player.lowerKnown);
      }
  EXPECT_EQ(
      column.scan({{gray, 40}, {blue, 5}, {black, 2}, {blue, 6}, {gray, 1}}).players[0].pixels, 11);
  EXPECT_EQ(column.scan({{gray, 40}, {blue, 5}, {black, 3}, {blue, 6}, {gray, 1}}).players.size(),
            2u);
}

TEST(IndicationScanner, ATricotEndsWhereItsLineEndsWithinTheImage) {
  Column column;
  EXPECT_FALSE(column.scan({{blue, 9}, {gray, 1}}).players[0].upperKnown);
  EXPECT_FALSE(column.scan({{gray, 99}, {blue, 1}}).players[0].lowerKnown);
  column.endWithinTheImage();
  EXPECT_TRUE(column.scan({{blue, 9}, {gray, 1}}).players[0].upperKnown);
  EXPECT_TRUE(column.scan({{gray, 99}, {blue, 1}}).players[0].lowerKnown);
}

TEST(IndicationScanner, AFlagLiesBetweenItsColors) {
  Column column;
  const auto flags = [&](ColorClass upper, int gap, ColorClass lower, int length = 8) {
    return column.scan({{white, 20}, {upper, length}, {gray, gap}, {lower, length}, {white, 1}})
        .flags;
  };
  for (const FlagColors& flag : flagColors) {
    EXPECT_NEAR(flags(flag.upper, 0, flag.lower).at(0).position.y(), 28, 1e-9);
    EXPECT_NEAR(flags(flag.upper, 2, flag.lower).at(0).position.y(), 29, 1e-9);
    EXPECT_EQ(flags(flag.upper, 3, flag.lower).size(), 0u);
    EXPECT_EQ(flags(flag.upper, 0, flag.lower, 2).size(), 1u);
    EXPECT_EQ(flags(flag.upper, 0, flag.lower, 1).size(), 0u);
  }
  EXPECT_EQ(
      column.scan({{white, 20}, {yellow, 8}, {pink, 8}, {skyblue, 8}, {white, 1}}).flags.size(), 2u)
      << "only its pole decides";
  EXPECT_EQ(column.scan({{pink, 8}, {yellow, 8}, {white, 1}}).flags.size(), 1u);
  EXPECT_EQ(column.scan({{white, 20}, {pink, 8}, {yellow, 1}, {gray, 1}, {yellow, 8}}).flags.size(),
            1u);
}

// Below a goal's color green begins, or a line of some pixels.
TEST(IndicationScanner, AGoalsFootIsWhereTheGreenBegins) {
  Column column;
  const auto goals = [&](int goal, int gap, int green) {
    return column
        .scan({{gray, 40}, {yellow, goal}, {white, gap}, {ColorClass::green, green}, {gray, 1}})
        .goals;
  };
  EXPECT_EQ(goals(3, 0, 20).size(), 1u);
  EXPECT_EQ(goals(2, 0, 20).size(), 0u);
  for (const int gap : {0, 1, 2}) {
    const GoalIndication goal = goals(20, gap, 20).at(0);
    EXPECT_TRUE(goal.meetsField) << gap;
    EXPECT_NEAR(goal.top.y(), 40.5, 1e-9);
    EXPECT_NEAR(goal.bottom.y(), 59.5, 1e-9);
    EXPECT_NEAR(goal.foot.y(), 60 + gap / 2., 1e-9);
  }
  EXPECT_FALSE(goals(20, 3, 20).at(0).meetsField);
  EXPECT_EQ(goals(20, 6, 20).size(), 1u);
  EXPECT_EQ(goals(20, 7, 20).size(), 0u);
  EXPECT_EQ(goals(20, 0, 2).size(), 1u);
  EXPECT_EQ(goals(20, 0, 1).size(), 0u);
}

// The horizon is 50 pixels above the middle of the image: at 22.
TEST(IndicationScanner, AGoalReachesBelowTheHorizon) {
  Column column;
  EXPECT_EQ(column.scan({{gray, 5}, {skyblue, 13}, {green, 1}}).goals.size(), 0u);
  EXPECT_EQ(column.scan({{gray, 5}, {skyblue, 20}, {green, 1}}).goals.size(), 1u);
}

TEST(IndicationScanner, TheImageCutsAGoalOff) {
  Column column;
  EXPECT_EQ(column.scan({{gray, 40}, {skyblue, 1}}).goals.size(), 1u);
  column.endWithinTheImage();
  EXPECT_EQ(column.scan({{gray, 40}, {skyblue, 1}}).goals.size(), 0u);
}

TEST(IndicationScanner, ARobotThatHidesAGoalsFootIsNear) {
  Column column;
  const auto goals = [&](int goal, const std::vector<std::pair<ColorClass, int>>& below) {
    std::vector<std::pair<ColorClass, int>> runs{{noColor, 40}, {skyblue, goal}};
    runs.insert(runs.end(), below.begin(), below.end());
    return column.scan(runs).goals.size();
  };
  EXPECT_EQ(goals(8, {{red, 8}, {gray, 20}, {green, 1}}), 1u);
  EXPECT_EQ(goals(7, {{red, 8}, {gray, 20}, {green, 1}}), 0u) << "too little of it";
  EXPECT_EQ(goals(20, {{blue, 6}, {gray, 20}, {green, 1}}), 1u);
  EXPECT_EQ(goals(20, {{blue, 5}, {gray, 20}, {green, 1}}), 0u);
  EXPECT_EQ(goals(20, {{blue, 3}, {black, 3}, {gray, 20}, {green, 1}}), 1u);
  EXPECT_EQ(goals(20, {{blue, 3}, {black, 2}, {gray, 20}, {green, 1}}), 0u);
  EXPECT_EQ(goals(20, {{blue, 2}, {black, 9}, {gray, 20}, {green, 1}}), 0u);
  EXPECT_EQ(goals(20, {{gray, 11}, {blue, 9}, {gray, 20}, {green, 1}}), 1u);
  EXPECT_EQ(goals(20, {{gray, 12}, {blue, 9}, {gray, 20}, {green, 1}}), 0u);
}

TEST(IndicationScanner, WhatIsPartOfAFlagOrAboveAWallIsNoHiddenGoal) {
  Column column;
  const auto goals = [&](const std::vector<std::pair<ColorClass, int>>& above,
                         const std::vector<std::pair<ColorClass, int>>& below) {
    std::vector<std::pair<ColorClass, int>> runs{{noColor, 40}};
    runs.insert(runs.end(), above.begin(), above.end());
    runs.insert(runs.end(), {{skyblue, 20}, {red, 8}, {gray, 9}});
    runs.insert(runs.end(), below.begin(), below.end());
    return column.scan(runs).goals.size();
  };
  EXPECT_EQ(goals({}, {{white, 1}, {gray, 9}, {green, 1}}), 1u) << "a single pixel";
  EXPECT_EQ(goals({}, {{white, 2}, {gray, 9}, {green, 1}}), 0u) << "a wall";
  EXPECT_EQ(goals({}, {{green, 2}, {white, 9}, {green, 1}}), 1u) << "a line on the ground";
  EXPECT_EQ(goals({}, {{green, 1}, {white, 9}, {green, 1}}), 0u);
  EXPECT_EQ(goals({{pink, 5}}, {{green, 1}}), 0u) << "a flag";
  EXPECT_EQ(goals({{pink, 5}, {gray, 2}}, {{green, 1}}), 0u);
  EXPECT_EQ(goals({{pink, 5}, {gray, 3}}, {{green, 1}}), 1u);
}

TEST(IndicationScanner, GreenHasGapsOfTwoPixels) {
  Column column;
  const auto green = [&](const std::vector<std::pair<ColorClass, int>>& runs) {
    return column.scan(runs).greens.at(0);
  };
  EXPECT_TRUE(green({{ColorClass::green, 1}}).beginOnBorder);
  EXPECT_NEAR(green({{ColorClass::green, 1}}).begin.y(), 0.5, 1e-9);
  EXPECT_NEAR(green({{ColorClass::green, 1}}).end.y(), 143.5, 1e-9);
  const auto begin = [&](ColorClass color, int gap) {
    return green({{gray, 60}, {ColorClass::green, 20}, {color, gap}, {ColorClass::green, 1}})
        .begin.y();
  };
  EXPECT_NEAR(begin(gray, 2), 60, 0.2);
  EXPECT_NEAR(begin(gray, 3), 83, 0.2);
  EXPECT_NEAR(begin(orange, 3), 83, 0.2);
  EXPECT_NEAR(
      green({{gray, 60}, {ColorClass::green, 1}, {gray, 1}, {ColorClass::green, 1}}).begin.y(), 62,
      0.2)
      << "a single pixel is no green";
  EXPECT_FALSE(green({{gray, 60}, {ColorClass::green, 1}}).beginOnBorder);
}

// A line of 25 mm is 2.4 pixels high there, half a meter away.
TEST(IndicationScanner, GreenGoesOnBeyondWhatIsFourTimesAsHighAsALine) {
  Column column;
  const auto begin = [&](int gap) {
    return column.scan({{gray, 20}, {green, 59 - gap}, {white, gap}, {green, 1}})
        .greens.at(0)
        .begin.y();
  };
  EXPECT_NEAR(begin(9), 20, 0.2);
  EXPECT_NEAR(begin(11), 79, 0.2);
}

}  // namespace
}  // namespace gt
