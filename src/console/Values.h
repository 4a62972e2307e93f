#pragma once
#include <optional>
#include <string>
#include <vector>

#include "console/Console.h"

namespace gt {

/// A value of a running simulation, as text, and as a number if it is one (true is 1).
struct ConsoleValue {
  std::string text;
  std::optional<double> number;
};

/// A value by its path (commands get, until, expect, plot):
///
///     time, half, state, kickOff, timeLeft, score.red, score.blue
///     ball.x, ball.y, ball.speed, ball.toucher; ball1 is the second ball
///     red1.x, red1.y, red1.rotation, red1.height, red1.tilt, red1.roll, red1.walked, red1.posture
///     red1.RobotPose.pose.rotation      what a robot provides or reads
///     red1.ImageProcessor.denseSpacing  a parameter, as TASK.PATH or TASK.SOLUTION.PATH
///     robots/red1/joints/headPan        an object of the scene tree (SceneTree), in conditions
///                                       with dots; field.flag.2 is the third of its numbers
///
/// The truth is in the field's coordinates: mm, degrees, seconds. Without a robot's name,
/// representations and parameters are those of the first selected robot.
Result<ConsoleValue> valueAt(Console& console, const std::string& path);

/// The path of an object of the scene tree with slashes, if `path` denotes one; a person may also
/// write it with dots. A path with slashes always denotes one. Empty if it denotes none.
std::optional<std::string> objectPath(Session& session, std::string path);

/// Whether a path denotes the body of a robot that has none: one on a log, or a remote one.
bool isOfMissingBody(Session& session, const std::string& path);

/// The position (mm, on the field) of a robot or a ball by its name; empty if there is none.
std::optional<Vector2d> placeOf(Console& console, std::string_view name);

/// The paths that begin a value, for completion and `get ?`.
std::vector<std::string> valueNames(Console& console);

}  // namespace gt
