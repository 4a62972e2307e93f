#pragma once
#include <array>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The field and the ball (facts, 2.1), from field.cfg. Configuration. The own goal lies at
/// negative x.
struct FieldDimensions {
  double xGroundline = 2100;
  double xGoalBack = 2400;
  double xPenaltyArea = 1600;
  double xSideCorner = 1800;
  double ySideline = 1350;
  double yPenaltyArea = 500;
  double yGoal = 300;
  double ySideCorner = 1050;
  double centerCircleRadius = 150;
  double lineWidth = 25;
  double wallHeight = 100;
  double goalHeight = 300;
  double flagX = 2100;
  double flagY = 1400;
  double flagRadius = 50;
  double flagBottom = 210;
  double flagTop = 410;
  double ballRadius = 43;

  bool operator==(const FieldDimensions&) const = default;

  static constexpr auto fields() {
    return Fields{field("xGroundline", &FieldDimensions::xGroundline, "mm",
                        "opponent's; the own one at -x", {1, 1e5}),
                  field("xGoalBack", &FieldDimensions::xGoalBack, "mm", "", {1, 1e5}),
                  field("xPenaltyArea", &FieldDimensions::xPenaltyArea, "mm", "", {1, 1e5}),
                  field("xSideCorner", &FieldDimensions::xSideCorner, "mm",
                        "where the corner's slope leaves the side wall", {1, 1e5}),
                  field("ySideline", &FieldDimensions::ySideline, "mm", "left; the right one at -y",
                        {1, 1e5}),
                  field("yPenaltyArea", &FieldDimensions::yPenaltyArea, "mm", "", {1, 1e5}),
                  field("yGoal", &FieldDimensions::yGoal, "mm", "left post", {1, 1e5}),
                  field("ySideCorner", &FieldDimensions::ySideCorner, "mm",
                        "where the corner's slope meets the ground line", {1, 1e5}),
                  field("centerCircleRadius", &FieldDimensions::centerCircleRadius, "mm",
                        "to the line's middle", {1, 1e5}),
                  field("lineWidth", &FieldDimensions::lineWidth, "mm", "", {1, 1000}),
                  field("wallHeight", &FieldDimensions::wallHeight, "mm", "", {0, 1e4}),
                  field("goalHeight", &FieldDimensions::goalHeight, "mm", "", {1, 1e4}),
                  field("flagX", &FieldDimensions::flagX, "mm",
                        "of the corner flags; the middle ones at 0", {1, 1e5}),
                  field("flagY", &FieldDimensions::flagY, "mm", "of all flags", {1, 1e5}),
                  field("flagRadius", &FieldDimensions::flagRadius, "mm", "", {1, 1000}),
                  field("flagBottom", &FieldDimensions::flagBottom, "mm",
                        "height of the lower edge of the lower color", {0, 1e4}),
                  field("flagTop", &FieldDimensions::flagTop, "mm",
                        "height of the upper edge of the upper color", {1, 1e4}),
                  field("ballRadius", &FieldDimensions::ballRadius, "mm", "", {1, 1000})};
  }
};

}  // namespace gt
