#pragma once
#include <string>
#include <string_view>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

enum class MotionType { walk, stand, specialAction, getup };  // report 3.9
/// Types of gait, each with parameters of its own (report 3.9).
enum class WalkType {
  normal,
  fast,          ///< Greatest speed; all feet are in the air between two steps.
  backward,      ///< Walks backward faster than the other types.
  dribble,       ///< Pushes a ball ahead between stretched fore legs.
  turnWithBall,  ///< Turns with a ball that the fore legs hold.
  crawl,         ///< Lifts one foot at a time; the other three carry the body.
  pace           ///< Lifts both feet of one side together.
};

/// The special actions that the motion requests itself: the stand from which the robot sees where
/// it looks, and the actions with which the robot gets up. All other special actions are known by
/// name only, each from a `.mof` file in motions/ (report 3.9.2).
inline constexpr std::string_view standAction = "stand", getupFromBelly = "getupFromBelly",
                                  getupFromSide = "getupFromSide", getupFromBack = "getupFromBack",
                                  getupFromNose = "getupFromNose";

/// Motion of the tail during the motion of the body (report I.5.3: tr).
enum class TailRequest {
  noTailWag,
  wagHorizontal,
  wagVertical,
  wagLeftRightHorizontal,
  wagLeftRightVertical,
  wagHorizontalFast,
  wagVerticalFast,
  tailFollowsHead
};

/// The next motion of the body. Provided by BehaviorControl.
struct MotionRequest {
  MotionType type = MotionType::stand;
  WalkType walkType = WalkType::normal;
  Pose2D walk;
  std::string specialAction;
  TailRequest tail = TailRequest::noTailWag;
  Time time = never();

  /// Returns the request, or a request to stand if the request is older than half a second, because
  /// the behavior has stopped then. A request without a time is always valid.
  const MotionRequest& validAt(Time now) const {
    constexpr std::int64_t oldest = 500;
    static const MotionRequest stand;
    return time == never() || now - time <= oldest ? *this : stand;
  }

  static constexpr auto fields() {
    return Fields{
        field<&MotionRequest::type>(),
        field<&MotionRequest::walkType>(),
        field<&MotionRequest::walk>(Unit::mmRadPerS,
                                    "walking speed ahead, to the left and counterclockwise"),
        field<&MotionRequest::specialAction>("name of the motion description; empty: none"),
        field<&MotionRequest::tail>(),
        field<&MotionRequest::time>(
            Unit::ms,
            "time of the decision; the robot stands if it is too old; never: always valid")};
  }
};

}  // namespace gt
