#include "simulation/camera/Lighting.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr int pixelsPerDegree = 2;

class FacetteView : public View {
 public:
  FacetteView()
      : View{"facette",
             "all around the robot's camera, or around X Y Z in mm, each degree a pixel"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    if (!subject.simulation) return Error{.field = name(), .what = "there is no simulated scene"};
    if (!numbers.empty() && numbers.size() != 3)
      return Error{.field = name(), .what = "expected no numbers, or X Y Z from where"};
    const World& world = subject.simulation->world();
    Pose3D pose;
    int hidden = -1;
    if (numbers.size() == 3) {
      pose.translation = {numbers[0], numbers[1], numbers[2]};
    } else {
      const auto robot = subject.robot();
      if (!robot) return robot.error();
      const auto index = subject.sceneRobot((*robot)->name());
      if (!index) return index.error();
      pose = world.camera(*index);
      hidden = world.parts(*index).headBody;
    }
    Image image;
    Facette{360, 180}.take(Lighting{world.model()}, CameraScene{world.model()}, world.data(), pose,
                           hidden, false, image);
    return imageSheet(image, pixelsPerDegree);
  }
};

}  // namespace

std::unique_ptr<View> makeFacetteView() {
  return std::make_unique<FacetteView>();
}

}  // namespace gt
