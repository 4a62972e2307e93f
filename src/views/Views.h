#pragma once
#include <memory>

#include "views/View.h"

namespace gt {

/// All views of report I.3 and J.3.
const std::vector<std::shared_ptr<const View>>& builtInViews();

// A file each.
std::unique_ptr<View> makeSceneView();    ///< Report I.3.1: the scene from a side.
std::unique_ptr<View> makeRobotView();    ///< Report I.3.2: a robot from near, with its LEDs.
std::unique_ptr<View> makeFacetteView();  ///< Report 5.1.1: what a spherical camera sees.
std::unique_ptr<View> makeDepthView();    ///< Report 5.1.2: how far away all is that a camera sees.
std::unique_ptr<View> makeColorSpaceView();  ///< Report J.3.4: how the image uses the space YUV.
std::unique_ptr<View> makeRadarView();       ///< Report J.3.2: what lies around the robot.
std::unique_ptr<View> makeXabslView();       ///< Report I.3.3.3: what the behavior does.
std::unique_ptr<View> makeSensorView();      ///< What the body's sensors measure.
std::unique_ptr<View> makeTimeView();        ///< Report J.3.6: how long each module takes.
std::unique_ptr<View> makePlotView();        ///< Report J.3.5: values over time.

/// Pixels of an image view's sheet for one of the camera.
inline constexpr int imageViewScale = 4;
/// Report I.3.3.1: an image view, defined by its name and what is painted on one another: `image`,
/// `colorClassImage`, image drawings by their debug keys, and `drawings` for all that come.
std::unique_ptr<View> makeImageView(std::string name, std::string help,
                                    std::vector<std::string> elements);
/// Pixels of a field view's sheet for a mm; the field's center is in its middle.
inline constexpr double fieldViewScale = 0.18;
/// Report I.3.3.2: a field view, defined likewise: `fieldPolygons`, `fieldLines`, `flags`, `truth`
/// (where robots and balls truly are), drawings on the field or around the robot by their debug
/// keys, and `drawings`.
std::unique_ptr<View> makeFieldView(std::string name, std::string help,
                                    std::vector<std::string> elements);

/// What an image view or a field view may consist of beside drawings.
extern const std::vector<std::string> imageViewElements, fieldViewElements;

}  // namespace gt
