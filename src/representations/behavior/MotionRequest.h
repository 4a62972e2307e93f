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
  getup
};

/// The next motion of the body. Provided by BehaviorControl.
struct MotionRequest {
  MotionType type = MotionType::stand;
  WalkType walkType = WalkType::normal;
  Pose2D walk;
  SpecialAction specialAction = SpecialAction::none;
  Time time = never();

  static constexpr auto fields() {
    return std::tuple{field("type", &MotionRequest::type),
                      field("walkType", &MotionRequest::walkType),
                      field("walk", &MotionRequest::walk, "mm/s, rad/s",
                            "speed ahead, left and counterclockwise"),
                      field("specialAction", &MotionRequest::specialAction),
                      field("time", &MotionRequest::time, "ms",
                            "of the decision; too old, the robot stands; never: of no age")};
  }
};
static_assert(complete<MotionRequest>);

}  // namespace gt
