#pragma once
#include <memory>

#include "views/View.h"

namespace gt {

/// All views of report I.3 and J.3.
const std::vector<std::shared_ptr<const View>>& builtInViews();

// Each is in a file of its own.
std::unique_ptr<View> makeSceneView();       ///< Report I.3.1: the scene from a side.
std::unique_ptr<View> makeRobotView();       ///< Report I.3.2: a robot from near, with its LEDs.
std::unique_ptr<View> makeFacetteView();     ///< Report 5.1.1: the image of a spherical camera.
std::unique_ptr<View> makeDepthView();       ///< Report 5.1.2: the depths in a camera's image.
std::unique_ptr<View> makeColorSpaceView();  ///< Report J.3.4: the image's colors in YUV space.
std::unique_ptr<View> makeRadarView();       ///< Report J.3.2: objects around the robot.
std::unique_ptr<View> makeXabslView();       ///< Report I.3.3.3: the state of the behavior.
std::unique_ptr<View> makeSensorView();      ///< Measurements of the body's sensors.
std::unique_ptr<View> makeTimeView();        ///< Report J.3.6: computing time of each module.
std::unique_ptr<View> makePlotView();        ///< Report J.3.5: values over time.

/// Pixels of an image view's sheet for a pixel of the camera.
inline constexpr int imageViewScale = 4;
/// Report I.3.3.1: an image view, defined by its name and its elements, which are painted on top of
/// each other: `image`, `colorClassImage`, image drawings by their debug keys, and `drawings` for
/// all received drawings.
std::unique_ptr<View> makeImageView(std::string name, std::string help,
                                    std::vector<std::string> elements);
/// Pixels of a field view's sheet for a mm; the field's center is in its middle.
inline constexpr double fieldViewScale = 0.18;
/// Report I.3.3.2: a field view, defined by its name and its elements: `fieldPolygons`,
/// `fieldLines`, `flags`, `truth` (the true places of robots and balls), drawings on the field or
/// around the robot by their debug keys, and `drawings` for all received drawings.
std::unique_ptr<View> makeFieldView(std::string name, std::string help,
                                    std::vector<std::string> elements);

/// The possible elements of an image view or a field view beside drawings.
extern const std::vector<std::string> imageViewElements, fieldViewElements;

}  // namespace gt
