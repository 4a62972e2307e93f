#pragma once
#include <string>
#include <string_view>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

enum class MotionType { walk, stand, specialAction, getup };  // report 3.9
/// Ways of walking, each with parameters of its own (report 3.9).
enum class WalkType {
  normal,
  fast,          ///< As fast as the legs can, with all feet in the air between two steps.
  backward,      ///< Faster back than the others.
  dribble,       ///< Pushes a ball ahead between stretched fore legs.
  turnWithBall,  ///< Turns with a ball that the fore legs hold.
  crawl,         ///< Lifts one foot at a time: three always carry the body.
  pace           ///< Lifts both feet of a side together.
};

/// The special actions that the motion asks for itself: that in which the robot sees where it
/// looks, and those that get it up. All others are known by name only, each from a `.mof` file in
/// motions/ (report 3.9.2).
inline constexpr std::string_view standAction = "stand", getupFromBelly = "getupFromBelly",
                                  getupFromSide = "getupFromSide", getupFromBack = "getupFromBack",
                                  getupFromNose = "getupFromNose";

/// What the tail does meanwhile (report I.5.3: tr).
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

  /// The request, or that to stand if its time lies further back than half a second: the behavior
  /// has stopped. A request without a time is always valid.
  const MotionRequest& validAt(Time now) const {
    constexpr std::int64_t oldest = 500;
    static const MotionRequest stand;
    return time == never() || now - time <= oldest ? *this : stand;
  }

  static constexpr auto fields() {
    return Fields{
        field<&MotionRequest::type>(),
        field<&MotionRequest::walkType>(),
        field<&MotionRequest::walk>(Unit::mmRadPerS, "speed ahead, left and counterclockwise"),
        field<&MotionRequest::specialAction>("name of the motion description; empty: none"),
        field<&MotionRequest::tail>(),
        field<&MotionRequest::time>(
            Unit::ms, "of the decision; too old, the robot stands; never: of no age")};
  }
};

}  // namespace gt
