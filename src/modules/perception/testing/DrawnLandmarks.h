#pragma once
#include <gtest/gtest.h>

#include <optional>

#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/scanning/FlagColors.h"
#include "modules/perception/testing/DrawnImage.h"

namespace gt {

/// Test fixture: one ball, one flag and one goal wall in the robot's system (mm), the latter within
/// the white border, and the percepts of GT2003 from their images.
class DrawnLandmarks : public testing::Test {
 protected:
  static const Palette& palette() {
    static const Palette colors{{{ColorClass::orange, {130, 80, 185}},
                                 {ColorClass::yellow, {190, 40, 145}},
                                 {ColorClass::skyblue, {150, 175, 80}},
                                 {ColorClass::pink, {140, 135, 195}},
                                 {ColorClass::green, {90, 110, 100}},
                                 {ColorClass::white, {220, 128, 128}},
                                 {ColorClass::red, {80, 110, 190}},
                                 {ColorClass::blue, {50, 170, 110}}},
                                {110, 128, 130}};
    return colors;
  }

  std::optional<Vector3d> ball_;
  std::optional<Vector2d> flag_;
  FlagType flagType_ = FlagType::pinkAboveYellow;
  std::optional<double> goal_;  ///< Distance of the goal ahead, mm.

  FieldDimensions field_;
  ColorTable64 colors_ = palette().table(28);
  CameraMatrix matrix_;
  Image image_;
  GT2003ImageProcessor processor_;
  DrawnPercepts percepts_;
  const LandmarksPercept& landmarks_ = percepts_.landmarks;
  Random random_{1};

  void look(double pan, double tilt, double roll) {
    matrix_ = cameraAt(camera(), pan, tilt, roll);
    drawImage(image_, matrix_, 3, 2, random_,
              [&](const Vector3d& ray) { return palette()[classAlong(ray)]; });
    percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
  }
  static Vector3d camera() { return {90, 10, 175}; }

 private:
  ColorClass classAlong(const Vector3d& ray) const {
    const Vector3d from = camera();
    if (ball_) {
      const Vector3d to = *ball_ - from;
      const double along = to.dot(ray);
      if (along > 0 && (to - ray * along).norm() < field_.ballRadius) return ColorClass::orange;
    }
    if (flag_) {
      // Where the ray meets the cylinder.
      const Vector2d to = *flag_ - from.head<2>();
      const Vector2d flat = ray.head<2>();
      const double a = flat.squaredNorm(), b = to.dot(flat);
      const double c = to.squaredNorm() - field_.flagRadius * field_.flagRadius;
      if (b > 0 && b * b > a * c) {
        const double z = from.z() + ray.z() * (b - std::sqrt(b * b - a * c)) / a;
        const double middle = (field_.flagBottom + field_.flagTop) / 2;
        if (z > middle && z < field_.flagTop) return colorsOf(flagType_).upper;
        if (z > field_.flagBottom && z <= middle) return colorsOf(flagType_).lower;
        if (z > 0 && z <= field_.flagBottom) return ColorClass::white;
      }
    }
    if (goal_ && ray.x() > 0) {
      const Vector3d hit = from + ray * ((*goal_ - from.x()) / ray.x());
      if (hit.z() > 0 && hit.z() < field_.goalHeight)
        return std::abs(hit.y()) < field_.yGoal ? ColorClass::yellow : ColorClass::white;
    }
    return ray.z() < 0 && from.z() / -ray.z() < 3500 ? ColorClass::green : ColorClass::noColor;
  }
};

}  // namespace gt
