#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// The bounding rectangle of a landmark in angles seen from the camera, horizontal ones in the
/// robot's system, vertical ones to the horizon; and which of its edges lie on the border of the
/// image or are hidden: the angle is not the edge's then (report 3.2).
struct ConditionalBoundary {
  double left = 0, right = 0, top = 0, bottom = 0;
  bool leftOnBorder = false, rightOnBorder = false, topOnBorder = false, bottomOnBorder = false;

  static constexpr auto fields() {
    return Fields{field("left", &ConditionalBoundary::left, "rad", "+ to the left"),
                  field("right", &ConditionalBoundary::right, "rad"),
                  field("top", &ConditionalBoundary::top, "rad", "+ above the horizon"),
                  field("bottom", &ConditionalBoundary::bottom, "rad"),
                  field("leftOnBorder", &ConditionalBoundary::leftOnBorder),
                  field("rightOnBorder", &ConditionalBoundary::rightOnBorder),
                  field("topOnBorder", &ConditionalBoundary::topOnBorder),
                  field("bottomOnBorder", &ConditionalBoundary::bottomOnBorder)};
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

/// Where a flag stands in the coordinates of a team. Seen from the yellow goal pink is below on the
/// left and above on the right.
inline Vector2d positionOf(FlagType type, TeamColor team, const FieldDimensions& field) {
  // In the coordinates of the red team, which defends the yellow goal.
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
        field("type", &FlagPercept::type), field("boundary", &FlagPercept::boundary),
        field("distance", &FlagPercept::distance, "mm",
              "robot's origin to the flag's axis; 0 if not known"),
        field("angle", &FlagPercept::angle, "rad", "from the robot's origin to the flag's axis")};
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
    return Fields{field("color", &GoalPercept::color), field("boundary", &GoalPercept::boundary),
                  field("distance", &GoalPercept::distance, "mm",
                        "robot's origin to the middle between the goal's posts; 0 if not known"),
                  field("angle", &GoalPercept::angle, "rad",
                        "from the robot's origin to the middle of what is seen")};
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
    return Fields{field("time", &LandmarksPercept::time, "ms", "of the image"),
                  field("cameraOffset", &LandmarksPercept::cameraOffset, "mm",
                        "where the angles were measured, in the robot's system"),
                  field("numberOfFlags", &LandmarksPercept::numberOfFlags, "", "", {0, 6}),
                  field("flags", &LandmarksPercept::flags),
                  field("numberOfGoals", &LandmarksPercept::numberOfGoals, "", "", {0, 2}),
                  field("goals", &LandmarksPercept::goals)};
  }
};

}  // namespace gt
