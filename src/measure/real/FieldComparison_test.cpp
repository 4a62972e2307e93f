#include "measure/real/FieldComparison.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

TEST(FieldComparison, MeasuresDistancesFromLabels) {
  // A camera half a meter above the ground looks straight down.
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
  EXPECT_DOUBLE_EQ(value("vision.real.lines.found"), 40) << "two of five labeled points";
  EXPECT_NEAR(value("vision.real.lines.onLabel"), 200.0 / 3, 1e-9);
  EXPECT_NEAR(value("vision.real.lines.error"), 0.5, 0.01);
}

TEST(FieldComparison, SummarizesCameraMatricesWithoutTheirSigns) {
  FieldComparison comparison;
  comparison.add(MatrixCorrection{.tilt = fromDegrees(1), .roll = fromDegrees(-0.5)});
  comparison.add(std::nullopt);
  comparison.add(MatrixCorrection{.tilt = fromDegrees(-2), .roll = fromDegrees(-0.5)});
  comparison.add(std::nullopt);
  Figures figures;
  comparison.addTo(figures);
  EXPECT_DOUBLE_EQ(figures.find("vision.real.matrix.checked")->value, 50);
  EXPECT_NEAR(figures.find("vision.real.matrix.tilt")->value, 1.5, 1e-9);
  EXPECT_NEAR(figures.find("vision.real.matrix.roll")->value, 0.5, 1e-9);
  EXPECT_THAT(comparison.text(), testing::HasSubstr("mean -0.50; roll 0.50, 0.50, -0.50"));
}

}  // namespace
}  // namespace gt
