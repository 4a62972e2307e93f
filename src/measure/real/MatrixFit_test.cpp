#include "measure/real/MatrixFit.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

FieldDimensions nao2009() {
  FieldDimensions field;
  field.xGroundline = field.xSideCorner = 3000;
  field.ySideline = field.ySideCorner = 2000;
  field.xPenaltyArea = 2400;
  field.yPenaltyArea = 1100;
  field.yGoal = 700;
  field.centerCircleRadius = 600;
  field.wallHeight = 0;
  return field;
}

CameraMatrix matrixOf(double height, double tilt, double pan, double roll) {
  CameraMatrix matrix;
  matrix.info.width = 320;
  matrix.info.height = 240;
  matrix.info.focalX = matrix.info.focalY = 385;
  matrix.info.centerX = 160;
  matrix.info.centerY = 120;
  matrix.pose = {rotationZ(pan) * rotationY(-tilt) * rotationX(roll), {20, 0, height}};
  matrix.valid = true;
  return matrix;
}

/// What a camera sees of the lines from a pose, each point off by chance.
std::vector<std::vector<Vector2d>> seen(const MatrixFit& fit, const CameraMatrix& camera,
                                        const Pose2D& robot, double error, Random& random) {
  auto lines = linesInImage(fit.linePoints(), camera, robot, 15);
  for (auto& line : lines)
    for (Vector2d& p : line) p += error * Vector2d{random.gaussian(), random.gaussian()};
  return lines;
}

TEST(MatrixFit, GivesTheErrorOfAMatrixBack) {
  const MatrixFit fit{nao2009()};
  Random random{1};
  int found = 0;
  for (const Pose2D& robot : {Pose2D{0, -1300, 100}, Pose2D{0.4, -1500, -300},
                              Pose2D{0.1, 1200, 200}, Pose2D{2.8, 900, -500}})
    for (const double tilt : {-0.03, 0.04})
      for (const double roll : {-0.025, 0.01}) {
        const CameraMatrix truth = matrixOf(480, -0.3, 0.1, 0);
        const CameraMatrix measured = matrixOf(480, -0.3 - tilt, 0.1, -roll);
        const auto lines = seen(fit, truth, robot, 0.3, random);
        const auto correction = fit.fit(measured, lines);
        if (!correction) continue;
        ++found;
        EXPECT_NEAR(correction->tilt, tilt, 4 * correction->tiltError);
        EXPECT_NEAR(correction->roll, roll, 4 * correction->rollError);
        EXPECT_NEAR(correction->tilt, tilt, fromDegrees(0.4));
        EXPECT_NEAR(correction->roll, roll, fromDegrees(0.4));
        EXPECT_LT(correction->distance, 1);
      }
  EXPECT_GE(found, 6);
}

TEST(MatrixFit, KnowsNothingFromASingleLine) {
  const MatrixFit fit{nao2009()};
  const CameraMatrix matrix = matrixOf(480, -0.3, 0, 0);
  const std::vector<Vector2d> line{{20, 100}, {90, 101}, {160, 102}, {230, 103}, {300, 104}};
  EXPECT_FALSE(fit.fit(matrix, std::vector<std::vector<Vector2d>>{line}));
  EXPECT_FALSE(fit.fit(matrix, std::vector<std::vector<Vector2d>>{}));
}

// A corner's right angle is one condition for two unknowns.
TEST(MatrixFit, KnowsNotEnoughFromACorner) {
  const MatrixFit fit{nao2009()};
  const CameraMatrix matrix = matrixOf(480, -0.4, 0, 0);
  std::vector<std::vector<Vector2d>> lines{{}, {}};
  for (int i = 0; i < 12; ++i) {
    lines[0].push_back({20.0 + 10 * i, 60.0 + 8 * i});
    lines[1].push_back({130.0 + 10 * i, 148.0 - 4 * i});
  }
  EXPECT_FALSE(fit.fit(matrix, lines));
}

TEST(MatrixFit, FindsNoFieldInWhatIsNone) {
  const MatrixFit fit{nao2009()};
  const CameraMatrix matrix = matrixOf(480, -0.4, 0, 0);
  Random random{4};
  std::vector<std::vector<Vector2d>> lines(5);
  for (auto& line : lines)
    for (int i = 0; i < 10; ++i) line.push_back({random.uniform(0, 320), random.uniform(60, 240)});
  EXPECT_FALSE(fit.fit(matrix, lines));
}

TEST(MatrixFit, SeesLinesWhereTheyAre) {
  const MatrixFit fit{nao2009()};
  const CameraMatrix matrix = matrixOf(480, -0.3, 0, 0);
  const Pose2D robot{0, -1000, 0};
  const auto lines =
      linesInImage({{{0, 0}, {0, 200}, {0, 201}}, {{-3000, 0}, {-3000, 100}}}, matrix, robot, 5);
  ASSERT_EQ(lines.size(), 1u) << "the other one lies behind the camera";
  ASSERT_EQ(lines[0].size(), 2u) << "too near to each other";
  const Vector3d ray = matrix.ray(lines[0][1].x(), lines[0][1].y());
  const Vector3d onGround = matrix.pose.translation - matrix.pose.translation.z() / ray.z() * ray;
  EXPECT_NEAR(onGround.x(), 1000, 1e-6);
  EXPECT_NEAR(onGround.y(), 200, 1e-6);
}

}  // namespace
}  // namespace gt
