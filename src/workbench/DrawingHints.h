#pragma once
#include <string>
#include <vector>

#include "observer/ObservedRobot.h"

namespace gt {

/// The reason why the robot does not send a drawing that a viewer shows.
struct DrawingHint {
  std::string key, why;
  bool off = false;  ///< Whether its key is off and can be switched on.
  bool operator==(const DrawingHint&) const = default;
};

/// Hints about those of the drawings `keys` that the robot cannot send: it does not know their
/// keys, their keys are off, or the task that draws them has no solution. Requests from the robot
/// the tasks of drawings that it has not drawn recently.
std::vector<DrawingHint> drawingHints(ObservedRobot& robot, const std::vector<std::string>& keys,
                                      const std::vector<std::string>& known);

}  // namespace gt
