#include "workbench/ViewDialog.h"

namespace gt {
namespace {

/// Report J.3.4: how the camera's image uses the color space.
struct ColorSpaceViewer : ViewDialog {
  explicit ColorSpaceViewer(SessionThread& session)
      : ViewDialog{session, builtInView("colorSpace")} {}
};
const RegisterDialog<ColorSpaceViewer> colorSpace{
    {.id = "colorSpace",
     .title = "Color space",
     .group = "Viewers",
     .help = "How the camera's image uses the color space",
     .report = "J.3.4"}};

/// What the body's sensors measure.
struct SensorViewer : ViewDialog {
  explicit SensorViewer(SessionThread& session) : ViewDialog{session, builtInView("sensors")} {
    sheet().showPages();
  }
};
const RegisterDialog<SensorViewer> sensors{
    {.id = "sensors",
     .title = "Sensors",
     .group = "Viewers",
     .help = "Joints, acceleration, distance and switches of the robot"}};

/// Report I.3.3.3: what the behavior does.
struct BehaviorViewer : ViewDialog {
  explicit BehaviorViewer(SessionThread& session) : ViewDialog{session, builtInView("xabsl")} {
    setKeys({"BehaviorControl/activations"});
    sheet().showPages();
  }
};
const RegisterDialog<BehaviorViewer> behavior{
    {.id = "xabsl",
     .title = "Behavior",
     .group = "Viewers",
     .help = "Options with their states and times, basic behavior, symbols",
     .report = "I.3.3.3",
     .place = DialogPlace::right,
     .several = true,
     .atFirst = true}};

/// Report 5.1.2: how far away is what the camera sees.
struct DepthViewer : ViewDialog {
  explicit DepthViewer(SessionThread& session) : ViewDialog{session, builtInView("depth")} {}
};
const RegisterDialog<DepthViewer> depth{
    {.id = "depth",
     .title = "Depth image",
     .group = "Simulator",
     .help = "How far away is what the robot's camera sees: near is bright",
     .report = "5.1.2"}};

/// Report 5.1.1: all around the camera.
struct FacetteViewer : ViewDialog {
  explicit FacetteViewer(SessionThread& session) : ViewDialog{session, builtInView("facette")} {}
};
const RegisterDialog<FacetteViewer> facette{
    {.id = "facette",
     .title = "Facette image",
     .group = "Simulator",
     .help = "What a camera sees all around the robot's own",
     .report = "5.1.1"}};

}  // namespace
}  // namespace gt
