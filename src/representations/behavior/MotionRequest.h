#pragma once
#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

enum class MotionType { walk, stand, specialAction, getup };  // report 3.9
enum class WalkType { normal };

/// The special actions: one `.mof` file in motions/ for each (report 3.9.2).
enum class SpecialAction {
  none,
  stand,
  chestKick,
  armKickLeft,
  armKickRight,
  headLeft,
  headRight,
  getup,
  unswBashOptimized,
  sit,
  scratchHead
};

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
  SpecialAction specialAction = SpecialAction::none;
  TailRequest tail = TailRequest::noTailWag;
  Time time = never();

  /// The request, or that to stand if its time lies further back than half a second: the behaviour
  /// has stopped. A request without a time is always valid.
  MotionRequest validAt(Time now) const {
    constexpr std::int64_t oldest = 500;
    return time == never() || now - time <= oldest ? *this : MotionRequest{};
  }

  static constexpr auto fields() {
    return Fields{field("type", &MotionRequest::type),
                  field("walkType", &MotionRequest::walkType),
                  field("walk", &MotionRequest::walk, "mm/s, rad/s",
                        "speed ahead, left and counterclockwise"),
                  field("specialAction", &MotionRequest::specialAction),
                  field("tail", &MotionRequest::tail),
                  field("time", &MotionRequest::time, "ms",
                        "of the decision; too old, the robot stands; never: of no age")};
  }
};

}  // namespace gt
