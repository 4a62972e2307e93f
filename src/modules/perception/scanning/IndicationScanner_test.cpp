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

}  // namespace
}  // namespace gt
