#pragma once
#include <map>
#include <string>
#include <vector>

#include "console/Console.h"

namespace gt {

/// New points of values that are plotted: of those that the session records (console command plot),
/// and of what modules plot. A plot of a robot is named by the robot and its debug key:
/// red1 BallLocator/speed.
struct PlottedValues {
  struct Points {
    std::string name;
    std::vector<ObservedRobot::Point> points;
  };
  Time now;
  std::vector<Points> points;

  /// The points behind the last known one of each value.
  static PlottedValues since(Console& console, const std::map<std::string, Time>& known);
};

/// The names of all that can be plotted.
std::vector<std::string> plottableNames(Console& console);

/// The name of a value for good: what the connected robot has begins with that robot's name. An
/// error if it is no number.
Result<std::string> plottableName(Console& console, const std::string& name);

}  // namespace gt
