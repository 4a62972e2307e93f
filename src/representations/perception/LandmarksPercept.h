#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// The bounding rectangle of a landmark in angles seen from the camera: horizontal angles in the
/// robot's system, vertical ones relative to the horizon (report 3.2). The flags mark the sides
/// that lie on the image border or are hidden; the angle of such a side is not that of the
/// landmark's edge.
struct ConditionalBoundary {
  double left = 0, right = 0, top = 0, bottom = 0;
  bool leftOnBorder = false, rightOnBorder = false, topOnBorder = false, bottomOnBorder = false;

  static constexpr auto fields() {
    return Fields{field<&ConditionalBoundary::left>(Unit::rad, "+ to the left"),
                  field<&ConditionalBoundary::right>(Unit::rad),
                  field<&ConditionalBoundary::top>(Unit::rad, "+ above the horizon"),
                  field<&ConditionalBoundary::bottom>(Unit::rad),
                  field<&ConditionalBoundary::leftOnBorder>(),
                  field<&ConditionalBoundary::rightOnBorder>(),
                  field<&ConditionalBoundary::topOnBorder>(),
                  field<&ConditionalBoundary::bottomOnBorder>()};
  }
};

/// The six flags by their colors, upper color first (facts, 2.1).
enum class FlagType {
  pinkAboveYellow,
  pinkAboveGreen,
  pinkAboveSkyblue,
  yellowAbovePink,
  greenAbovePink,
  skyblueAbovePink
};

/// The position of a flag (mm) on the field, in the coordinates of a team. Seen from the yellow
/// goal, pink is below on the left and above on the right.
inline Vector2d positionOf(FlagType type, TeamColor team, const FieldDimensions& field) {
  // Coordinates of the red team, which defends the yellow goal.
  Vector2d p = Vector2d::Zero();
  switch (type) {
    case FlagType::pinkAboveYellow:
      p = {-field.flagX, -field.flagY};
      break;
    case FlagType::pinkAboveGreen:
      p = {0, -field.flagY};
      break;
    case FlagType::pinkAboveSkyblue:
      p = {field.flagX, -field.flagY};
      break;
    case FlagType::yellowAbovePink:
      p = {-field.flagX, field.flagY};
      break;
    case FlagType::greenAbovePink:
      p = {0, field.flagY};
      break;
    case FlagType::skyblueAbovePink:
      p = {field.flagX, field.flagY};
      break;
  }
  return team == TeamColor::red ? p : Vector2d{-p};
}

/// A flag as seen in one image (report 3.2.4).
struct FlagPercept {
  FlagType type = FlagType::pinkAboveYellow;
  ConditionalBoundary boundary;
  double distance = 0;
  double angle = 0;

  static constexpr auto fields() {
    return Fields{
        field<&FlagPercept::type>(), field<&FlagPercept::boundary>(),
        field<&FlagPercept::distance>(
            Unit::mm, "distance from the robot's origin to the flag's axis; 0 if unknown"),
        field<&FlagPercept::angle>(Unit::rad,
                                   "direction from the robot's origin to the flag's axis")};
  }
};

enum class GoalColor { yellow, skyblue };

/// A goal as seen in one image (report 3.2.5).
struct GoalPercept {
  GoalColor color = GoalColor::yellow;
  ConditionalBoundary boundary;
  double distance = 0;
  double angle = 0;

  static constexpr auto fields() {
    return Fields{
        field<&GoalPercept::color>(), field<&GoalPercept::boundary>(),
        field<&GoalPercept::distance>(
            Unit::mm,
            "distance from the robot's origin to the middle between the goal's posts; 0 if "
            "unknown"),
        field<&GoalPercept::angle>(
            Unit::rad,
            "direction from the robot's origin to the middle of the visible part of the goal")};
  }
};

/// The goal that a team defends.
constexpr GoalColor ownGoal(TeamColor team) {
  return team == TeamColor::red ? GoalColor::yellow : GoalColor::skyblue;
}

/// The flags and goals seen in one image. Provided by the ImageProcessor.
struct LandmarksPercept {
  Time time;
  Vector3d cameraOffset = Vector3d::Zero();
  int numberOfFlags = 0;
  std::array<FlagPercept, 6> flags;
  int numberOfGoals = 0;
  std::array<GoalPercept, 2> goals;

  static constexpr auto fields() {
    return Fields{
        field<&LandmarksPercept::time>(Unit::ms, "time of the image"),
        field<&LandmarksPercept::cameraOffset>(
            Unit::mm,
            "position of the camera, relative to the robot, from which the angles were measured"),
        field<&LandmarksPercept::numberOfFlags>({0, 6}),
        field<&LandmarksPercept::flags>(),
        field<&LandmarksPercept::numberOfGoals>({0, 2}),
        field<&LandmarksPercept::goals>()};
  }
};

}  // namespace gt
