#pragma once
#include <string>
#include <vector>

#include "observer/ObservedRobot.h"

namespace gt {

/// Why a drawing that a viewer shows does not come.
struct DrawingHint {
  std::string key, why;
  bool off = false;  ///< Its key is off, and can be switched on.
  bool operator==(const DrawingHint&) const = default;
};

/// Those of these drawings that cannot come: the robot does not know their keys, their keys are
/// off, or nobody solves the task that draws them. Asks the robot for the tasks of drawings that it
/// has not drawn recently.
std::vector<DrawingHint> drawingHints(ObservedRobot& robot, const std::vector<std::string>& keys,
                                      const std::vector<std::string>& known);

}  // namespace gt
