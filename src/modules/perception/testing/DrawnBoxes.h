#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/testing/DrawnImage.h"

namespace gt {

/// An axis-parallel box on or above the ground, relative to the robot (mm).
struct Box {
  Vector3d low, high;
  ColorClass color;

  /// The distance along a ray at which it meets the box; negative if it does not.
  double meets(const Vector3d& from, const Vector3d& ray) const {
    double enter = 0, leave = 1e9;
    for (int k = 0; k < 3; ++k) {
      double a = (low[k] - from[k]) / ray[k], b = (high[k] - from[k]) / ray[k];
      if (a > b) std::swap(a, b);
      enter = std::max(enter, a);
      leave = std::min(leave, b);
    }
    return enter < leave ? enter : -1;
  }
};

/// Test fixture: carpet with white lines and boxes on it, and the percepts of GT2003 from its
/// images.
class DrawnBoxes : public testing::Test {
 protected:
  static const Palette& palette() {
    static const Palette colors{{{ColorClass::green, {90, 110, 100}},
                                 {ColorClass::white, {220, 128, 128}},
                                 {ColorClass::orange, {130, 80, 185}},
                                 {ColorClass::yellow, {190, 40, 145}},
                                 {ColorClass::pink, {140, 135, 195}},
                                 {ColorClass::red, {80, 110, 190}},
                                 {ColorClass::blue, {50, 170, 110}},
                                 {ColorClass::skyblue, {150, 175, 80}},
                                 {ColorClass::gray, {130, 128, 128}},
                                 {ColorClass::black, {12, 128, 128}}},
                                {40, 128, 130}};
    return colors;
  }

  std::function<bool(double x, double y)> isLine_ = [](double, double) { return false; };
  std::vector<Box> boxes_;
  double cameraHeight_ = 190;

  FieldDimensions field_;
  ColorTable64 colors_ = palette().table(30);
  CameraMatrix matrix_;
  Image image_;
  GT2003ImageProcessor processor_;
  DrawnPercepts percepts_;
  const LinesPercept& lines_ = percepts_.lines;
  const PlayersPercept& players_ = percepts_.players;
  const ObstaclesPercept& obstacles_ = percepts_.obstacles;
  Random random_{1};

  void look(double pan, double tilt, double roll = 0) {
    matrix_ = cameraAt({90, 10, cameraHeight_}, pan, tilt, roll);
    drawImage(image_, matrix_, 2, 2, random_,
              [&](const Vector3d& ray) { return palette()[classAlong(ray)]; });
    percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
  }

 private:
  ColorClass classAlong(const Vector3d& ray) const {
    const Vector3d from = matrix_.pose.translation;
    double nearest = ray.z() < 0 ? -from.z() / ray.z() : 1e6;
    const Vector3d ground = from + nearest * ray;
    ColorClass color = nearest > 9000                    ? ColorClass::noColor
                       : isLine_(ground.x(), ground.y()) ? ColorClass::white
                                                         : ColorClass::green;
    for (const Box& box : boxes_)
      if (const double met = box.meets(from, ray); met > 0 && met < nearest) {
        nearest = met;
        color = box.color;
      }
    return color;
  }
};

}  // namespace gt
