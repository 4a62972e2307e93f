#include "views/ScenePicture.h"
#include "views/Views.h"

namespace gt {
namespace {

class SceneView : public View {
 public:
  SceneView()
      : View{"scene",
             "the scene from a side; X Y Z and X Y Z in mm may say from where and at what"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    if (!subject.simulation) return Error{.field = name(), .what = "there is no simulated scene"};
    if (!numbers.empty() && numbers.size() != 3 && numbers.size() != 6)
      return Error{.field = name(),
                   .what = "expected no numbers, X Y Z from where, or also X Y Z of what"};
    SceneCamera camera;
    camera.width = 960;
    camera.height = 540;
    if (numbers.size() >= 3) camera.from = {numbers[0], numbers[1], numbers[2]};
    if (numbers.size() == 6) camera.at = {numbers[3], numbers[4], numbers[5]};
    if ((camera.at - camera.from).norm() < 1)
      return Error{.field = name(), .what = "both points are the same"};
    return pictureSheet(scenePicture(subject.simulation->world(), camera), 1);
  }
};

}  // namespace

std::unique_ptr<View> makeSceneView() {
  return std::make_unique<SceneView>();
}

}  // namespace gt
