#include "replay/Replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "replay/FieldComparison.h"

namespace gt {
namespace {

const std::string labelFile = "tests/real/nao2009-labels.csv";

TEST(Labels, CoverTheWholeLog) {
  const auto labels = readLabels(labelFile);
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_EQ(labels->size(), 96u);
}

TEST(Labels, NameTheLineThatIsWrong) {
  const std::string file = testing::TempDir() + "labels.csv";
  const auto errorOf = [&](const std::string& row) {
    std::ofstream{file} << "picture,time,class,x,y,r\n0,1,none,0,0,0\n" << row << "\n";
    const auto labels = readLabels(file);
    EXPECT_FALSE(labels);
    return labels ? std::string{} : labels.error().text();
  };
  EXPECT_THAT(errorOf("1,2,hidden,0,0,0"), testing::HasSubstr("labels.csv:3: class"));
  EXPECT_THAT(errorOf("1,two,none,0,0,0"), testing::HasSubstr("labels.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,none"), testing::HasSubstr("labels.csv:3: x"));
  EXPECT_FALSE(readLabels("no/such.csv"));
}

TEST(Comparison, BlamesByThePersonsCircle) {
  BallPercept ball;
  ball.seen = true;
  ball.distanceByProjection = 1000;
  ball.distanceBySize = 1040;
  ball.radiusInImage = 16;
  BallLabel label{0, 0, BallView::whole, {100, 100}, 16.3};
  EXPECT_EQ(compareDistances(ball, &label), Verdict::agree);
  ball.distanceBySize = 1200;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::cameraMatrixIsOff);
  EXPECT_EQ(compareDistances(ball, nullptr), Verdict::notKnown);
  label.radius = 19;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::visionIsOff);
  ball.distanceBySize = ball.distanceByProjection = 1600;
  EXPECT_EQ(compareDistances(ball, &label), Verdict::notCompared);
}

TEST(Comparison, CountsWhatWasFound) {
  BallPercept seen;
  seen.seen = true;
  seen.distanceByProjection = 1008;
  seen.distanceBySize = 960;
  seen.centerInImage = {103, 104};
  seen.radiusInImage = 18;
  const BallLabel whole{0, 0, BallView::whole, {100, 100}, 18.5}, none{};
  Comparison comparison;
  comparison.add(seen, &whole);
  comparison.add(BallPercept{}, &whole);
  comparison.add(seen, &none);
  comparison.add(BallPercept{}, &none);
  comparison.add(BallPercept{}, nullptr);
  EXPECT_EQ(comparison.pictures(BallView::whole), 2);
  EXPECT_EQ(comparison.found(BallView::whole), 1);
  EXPECT_EQ(comparison.found(BallView::none), 1);
  EXPECT_EQ(comparison.pictures(BallView::partial), 0);
  EXPECT_THAT(comparison.text(), testing::HasSubstr("5.00 pixels in the centre and 0.50"));
  EXPECT_THAT(comparison.text(), testing::HasSubstr("agree 2 "));
  EXPECT_THAT(comparison.text(), testing::HasSubstr("size 1.050 on average"));
}

TEST(FieldLabels, CoverMostPictures) {
  const auto labels = readFieldLabels("tests/real/nao2009-field.csv");
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_GE(labels->size(), 60u);
  const auto balls = readLabels(labelFile);
  for (const auto& [picture, label] : *labels)
    EXPECT_EQ(label.time, (*balls)[static_cast<std::size_t>(picture)].time) << picture;
}

TEST(FieldLabels, NameTheLineThatIsWrong) {
  const std::string file = testing::TempDir() + "field.csv";
  const auto errorOf = [&](const std::string& row) {
    std::ofstream{file} << "picture,time,what,x,y\n0,1,none,0,0\n" << row << "\n";
    const auto labels = readFieldLabels(file);
    EXPECT_FALSE(labels) << row;
    return labels ? std::string{} : labels.error().text();
  };
  EXPECT_THAT(errorOf("1,2,wall,0,0"), testing::HasSubstr("field.csv:3: what"));
  EXPECT_THAT(errorOf("1,two,none,0,0"), testing::HasSubstr("field.csv:3: time"));
  EXPECT_THAT(errorOf("1,2,line1,0,nan"), testing::HasSubstr("field.csv:3: x"));
  EXPECT_THAT(errorOf("1,2,line1"), testing::HasSubstr("field.csv:3: x"));
  EXPECT_THAT(errorOf("0,2,line1,1,1"), testing::HasSubstr("field.csv:3: time"));
}

TEST(FieldComparison, MeasuresDistancesFromLabels) {
  // A camera half a metre above the ground looks straight down.
  CameraMatrix matrix;
  matrix.time = Time{7};
  matrix.pose.translation = {0, 0, 500};
  matrix.pose.rotation << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  const auto onGround = [&](double x, double y) {
    const Vector3d ray = matrix.ray(x, y);
    return Vector2d{(matrix.pose.translation + 500 / -ray.z() * ray).head<2>()};
  };
  FieldLabel label;
  label.time = 7;
  label.lines = {{{40, 50}, {60, 50}, {80, 50}}, {{100, 100}, {100, 120}}};
  EXPECT_DOUBLE_EQ(label.distance({50, 53}), 3);
  EXPECT_DOUBLE_EQ(label.distance({100, 90}), 10);
  LinesPercept lines;
  lines.points[EdgeType::line] = {onGround(45, 51), onGround(62, 50), onGround(150, 20)};
  FieldComparison comparison;
  comparison.add(lines, LandmarksPercept{}, matrix, label);
  matrix.time = Time{8};
  comparison.add(lines, LandmarksPercept{}, matrix, label);  // of another log
  Figures figures;
  comparison.addTo(figures);
  const auto value = [&](const char* name) {
    return std::ranges::find(figures.all(), name, &Figure::name)->value;
  };
  EXPECT_DOUBLE_EQ(value("vision.real.lines.found"), 40) << "two of five labelled points";
  EXPECT_NEAR(value("vision.real.lines.onLabel"), 200.0 / 3, 1e-9);
  EXPECT_NEAR(value("vision.real.lines.error"), 0.5, 0.01);
}

std::string realFolder() {
  const char* real = std::getenv("GT_REAL");
  return real ? real : "../shared/real";
}

TEST(Replay, FindsTheBallInARealRobotsPictures) {
  const std::string folder = realFolder();
  if (!std::filesystem::exists(folder + "/nao2009.log"))
    GTEST_SKIP() << "no real robot's log in " << folder;
  Comparison comparison;
  int pictures = 0, drawn = 0;
  const auto done = replay({folder + "/nao2009.log", folder + "/coltable-field.c64"},
                           [&](const LogPlatform& platform, const BallPercept& ball,
                               const BallLabel* label) -> Result<void> {
                             const int number = platform.picture().number;
                             EXPECT_EQ(number, pictures++);
                             EXPECT_TRUE(label) << number;
                             comparison.add(ball, label);
                             drawn += !platform.drawings().empty();
                             if (!label || label->view != BallView::whole || !ball.seen) return {};
                             EXPECT_NEAR((ball.centerInImage - label->center).norm(), 0, 4)
                                 << number;
                             EXPECT_NEAR(ball.radiusInImage / label->radius, 1, 0.1) << number;
                             EXPECT_NE(compareDistances(ball, label), Verdict::visionIsOff);
                             return {};
                           });
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(pictures, 96);
  EXPECT_EQ(drawn, 96);
  EXPECT_GE(comparison.pictures(BallView::whole), 40);
  EXPECT_GE(comparison.found(BallView::whole), 0.9 * comparison.pictures(BallView::whole));
  EXPECT_EQ(comparison.found(BallView::none), 0);
}

}  // namespace
}  // namespace gt
