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
    return Fields{
        field<&FieldDimensions::xGroundline>(
            Unit::mm, "x of the opponent's ground line; the own one is at -x", {1, 1e5}),
        field<&FieldDimensions::xGoalBack>(Unit::mm, {1, 1e5}),
        field<&FieldDimensions::xPenaltyArea>(Unit::mm, {1, 1e5}),
        field<&FieldDimensions::xSideCorner>(
            Unit::mm, "x at which the corner's slope leaves the side wall", {1, 1e5}),
        field<&FieldDimensions::ySideline>(
            Unit::mm, "y of the left sideline; the right one is at -y", {1, 1e5}),
        field<&FieldDimensions::yPenaltyArea>(Unit::mm, {1, 1e5}),
        field<&FieldDimensions::yGoal>(Unit::mm, "y of the left goal post", {1, 1e5}),
        field<&FieldDimensions::ySideCorner>(
            Unit::mm, "y at which the corner's slope meets the ground line", {1, 1e5}),
        field<&FieldDimensions::centerCircleRadius>(Unit::mm, "to the line's middle", {1, 1e5}),
        field<&FieldDimensions::lineWidth>(Unit::mm, {1, 1000}),
        field<&FieldDimensions::wallHeight>(Unit::mm, {0, 1e4}),
        field<&FieldDimensions::goalHeight>(Unit::mm, {1, 1e4}),
        field<&FieldDimensions::flagX>(Unit::mm, "x of the corner flags; the middle flags are at 0",
                                       {1, 1e5}),
        field<&FieldDimensions::flagY>(Unit::mm, "distance of all flags from the field's x-axis",
                                       {1, 1e5}),
        field<&FieldDimensions::flagRadius>(Unit::mm, {1, 1000}),
        field<&FieldDimensions::flagBottom>(Unit::mm, "height of the lower edge of the lower color",
                                            {0, 1e4}),
        field<&FieldDimensions::flagTop>(Unit::mm, "height of the upper edge of the upper color",
                                         {1, 1e4}),
        field<&FieldDimensions::ballRadius>(Unit::mm, {1, 1000})};
  }
};

}  // namespace gt
