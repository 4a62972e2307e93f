#pragma once
#include "console/Console.h"
#include "views/painting/Sheet.h"

namespace gt {

// The views of report I.3 and J.3 without a window, of the first selected robot as it is now. What
// debug drawings show must have been asked for (`dk`).

/// Report I.3.1: the scene from a side.
Result<Sheet> sceneView(Console& console, const std::vector<double>& numbers);
/// Report I.3.2: the robot, centred, from the front left.
Result<Sheet> robotView(Console& console, const std::vector<double>& numbers);
/// Report 5.1.1: what a spherical camera sees, in the place of the robot's or at a point in mm.
Result<Sheet> facetteView(Console& console, const std::vector<double>& numbers);
/// Report I.3.3.1: the camera's picture with image drawings upon it.
Result<Sheet> imageView(Console& console, const std::vector<double>&);
/// Report I.3.3.1: the same, segmented into colour classes.
Result<Sheet> colorClassImageView(Console& console, const std::vector<double>&);
/// Report J.3.4: how the picture uses the colour space YUV.
Result<Sheet> colorSpaceView(Console& console, const std::vector<double>&);
/// Report I.3.3.2: the field with drawings, from above, and where all robots and balls truly are.
Result<Sheet> fieldView(Console& console, const std::vector<double>&);
/// Report J.3.2: the radar viewer, what lies around the robot.
Result<Sheet> radarView(Console& console, const std::vector<double>& numbers);
/// Report I.3.3.3: what the behavior does.
Result<Sheet> xabslView(Console& console, const std::vector<double>&);
/// What the body's sensors tell.
Result<Sheet> sensorView(Console& console, const std::vector<double>&);
/// Report J.3.6: how long each module takes.
Result<Sheet> timeView(Console& console, const std::vector<double>&);
/// Report J.3.5: values over time, those that `plot` records and those that the robot plots.
Result<Sheet> plotView(Console& console, const std::vector<double>& numbers);

/// A view by the name that the command `picture` knows it by.
struct View {
  std::string_view name;
  Result<Sheet> (*show)(Console& console, const std::vector<double>& numbers);
  std::string_view help;
};
const std::vector<View>& views();

}  // namespace gt
