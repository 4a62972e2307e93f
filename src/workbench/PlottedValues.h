#pragma once
#include <map>
#include <string>
#include <vector>

#include "console/Console.h"

namespace gt {

/// New points of plotted values: those that the session records (console command plot), and plots
/// of modules. A plot of a module is named by the robot and the debug key: red1 BallLocator/speed.
struct PlottedValues {
  struct Points {
    std::string name;
    std::vector<ObservedRobot::Point> points;
  };
  Time now;
  std::vector<Points> points;

  /// The points of each value that are newer than the last known one.
  static PlottedValues since(Console& console, const std::map<std::string, Time>& known);
};

/// The names of all values that can be plotted.
std::vector<std::string> plottableNames(Console& console);

/// The name of a value independent of the selection: values of the connected robot begin with its
/// name. An error if the value is no number.
Result<std::string> plottableName(Console& console, const std::string& name);

}  // namespace gt
