#include "logs/LogComparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/TemporaryFolder.h"
#include "debug/Drawing.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/LinesPercept.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

using ::testing::ElementsAre;

const std::function<bool(double)> goOn = [](double) { return true; };

/// Two logs of a hundred moments each, 10 ms apart. The second is changed by `change`.
class LogComparisonTest : public ::testing::Test {
 protected:
  using Change = std::function<void(int moment, BallModel&, LinesPercept&)>;

  std::string log(const std::string& name, const Change& change) const {
    const std::string path = (folder.path() / name).string();
    auto writer = McapWriter::open(path);
    for (int i = 0; i < 100; ++i) {
      const Time time{1000 + 10 * i};
      BallModel ball;
      ball.position = {1.0 * i, 2};
      LinesPercept lines;
      lines.points[EdgeType::line].assign(3, Vector2d{5, 6});
      change(i, ball, lines);
      writer->write("/BallModel", time, ball);
      writer->write("/LinesPercept", time, lines);
      writer->write("/Text", time, Text{name});
      writer->write("/input/RobotPose", time, RobotPose{});
    }
    EXPECT_TRUE(writer->close());
    return path;
  }
  LogComparison compare(const Change& change, const std::function<bool(double)>& progress = goOn) {
    const auto a = recordedSide(log("a.mcap", [](int, BallModel&, LinesPercept&) {}));
    const auto b = recordedSide(log("b.mcap", change));
    EXPECT_TRUE(a && b);
    const auto comparison = compareSides(**a, **b, progress);
    EXPECT_TRUE(comparison) << comparison.error().text();
    return *comparison;
  }
  static const ComparedTopic& topic(const LogComparison& comparison, const std::string& name) {
    for (const ComparedTopic& known : comparison.topics)
      if (known.name == name) return known;
    throw std::out_of_range{name};
  }

  TemporaryFolder folder;
};

TEST_F(LogComparisonTest, TheSameIsTheSameAndTextsDoNotCount) {
  const LogComparison comparison = compare([](int, BallModel&, LinesPercept&) {});
  ASSERT_EQ(comparison.topics.size(), 3u);
  for (const ComparedTopic& known : comparison.topics) {
    EXPECT_TRUE(known.same()) << known.name;
    EXPECT_EQ(known.compared, 100u) << known.name;
  }
  EXPECT_TRUE(topic(comparison, "RobotPose").input);
  EXPECT_FALSE(comparison.stopped);
}

TEST_F(LogComparisonTest, DifferencesAreFoundByPathAndTime) {
  const LogComparison comparison = compare([](int moment, BallModel& ball, LinesPercept& lines) {
    if (moment == 40 || moment == 41) ball.position.x() += moment == 40 ? 1 : -3;
    if (moment == 70) lines.points[EdgeType::line].resize(2);
    if (moment == 80) lines.points[EdgeType::line][1].y() = 7;
  });
  const ComparedTopic& ball = topic(comparison, "BallModel");
  EXPECT_EQ(ball.different, 2u);
  EXPECT_THAT(ball.times, ElementsAre(Time{1400}, Time{1410}));
  ASSERT_EQ(ball.values.size(), 1u);
  const DifferentValue& x = ball.values.front();
  EXPECT_EQ(x.path, "BallModel.position.x");
  EXPECT_EQ(x.different, 2u);
  EXPECT_EQ(x.first, Time{1400});
  EXPECT_EQ(x.firstA + " " + x.firstB, "40 41");
  EXPECT_EQ(x.largest, 3);
  EXPECT_EQ(x.largestAt, Time{1410});
  ASSERT_EQ(x.points.size(), 2u);
  EXPECT_EQ(x.points[1].a, 41);
  EXPECT_EQ(x.points[1].b, 38);
  const ComparedTopic& lines = topic(comparison, "LinesPercept");
  ASSERT_EQ(lines.values.size(), 2u);
  EXPECT_EQ(lines.values[0].path, "LinesPercept.points.line.1.y");
  EXPECT_EQ(lines.values[1].path, "LinesPercept.points.line.size");
  EXPECT_EQ(lines.values[1].firstB, "2");
}

TEST_F(LogComparisonTest, LongListsAreCounted) {
  const LogComparison comparison = compare([](int moment, BallModel&, LinesPercept& lines) {
    lines.points[EdgeType::line].assign(1000, {5, 6});
    if (moment > 0) lines.points[EdgeType::line].assign(3, {5, 6});
  });
  EXPECT_EQ(topic(comparison, "LinesPercept").different, 1u);
  // Of what both have nothing differs.
  ASSERT_EQ(topic(comparison, "LinesPercept").values.size(), 1u);
  EXPECT_EQ(topic(comparison, "LinesPercept").values.front().firstB, "1000");
}

TEST_F(LogComparisonTest, WhatOnlyOneSideHasIsCounted) {
  const auto a = recordedSide(log("a.mcap", [](int, BallModel&, LinesPercept&) {}));
  const std::string path = (folder.path() / "c.mcap").string();
  auto writer = McapWriter::open(path);
  for (int i = 90; i < 110; ++i) writer->write("/RobotPose", Time{1000 + 10 * i}, RobotPose{});
  for (int i = 90; i < 110; ++i) {
    BallModel ball;
    ball.position = {1.0 * i, 2};
    writer->write("/BallModel", Time{1000 + 10 * i}, ball);
  }
  ASSERT_TRUE(writer->close());
  const auto b = recordedSide(path);
  const auto comparison = compareSides(**a, **b, goOn);
  ASSERT_TRUE(comparison);
  const ComparedTopic& ball = topic(*comparison, "BallModel");
  EXPECT_EQ(ball.onlyA, 90u);
  EXPECT_EQ(ball.onlyB, 10u);
  EXPECT_EQ(ball.compared, 10u);
  EXPECT_EQ(ball.different, 0u);
  EXPECT_EQ(topic(*comparison, "RobotPose").onlyB, 20u);
}

TEST_F(LogComparisonTest, ItIsStopped) {
  const LogComparison comparison =
      compare([](int, BallModel&, LinesPercept&) {}, [](double share) { return share < 0.6; });
  EXPECT_TRUE(comparison.stopped);
  EXPECT_LT(topic(comparison, "BallModel").compared, 60u);
  EXPECT_GT(topic(comparison, "BallModel").compared, 30u);
}

TEST_F(LogComparisonTest, WhatHoldsNoRepresentationsIsRefused) {
  const std::string path = (folder.path() / "texts.mcap").string();
  auto writer = McapWriter::open(path);
  writer->write("/Text", Time{1000}, Text{"a"});
  ASSERT_TRUE(writer->close());
  EXPECT_FALSE(recordedSide(path));
  EXPECT_FALSE(recordedSide("no/such.mcap"));
}

}  // namespace
}  // namespace gt
