#include "views/Views.h"

namespace gt {

Result<ObservedRobot*> ViewSubject::robot() const {
  if (robots.empty()) return Error{.field = "robot", .what = "there is none"};
  return robots.front();
}

Result<std::size_t> ViewSubject::sceneRobot(const std::string& name) const {
  if (simulation) {
    const auto& all = simulation->scene().robots;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].name == name) return i;
  }
  return Error{.field = name, .what = "is no robot of the scene"};
}

const std::vector<std::shared_ptr<const View>>& builtInViews() {
  static const auto list = [] {
    std::vector<std::shared_ptr<const View>> views;
    views.push_back(makeSceneView());
    views.push_back(makeRobotView());
    views.push_back(makeFacetteView());
    views.push_back(makeDepthView());
    views.push_back(makeImageView("image", "the camera's image with the image drawings",
                                  {"image", "drawings"}));
    views.push_back(makeImageView("colorClassImage", "the same in the robot's color classes",
                                  {"colorClassImage", "drawings"}));
    views.push_back(makeColorSpaceView());
    views.push_back(makeFieldView(
        "field", "the field from above with the field drawings, and where all truly are",
        {"fieldPolygons", "fieldLines", "flags", "truth", "drawings"}));
    views.push_back(makeRadarView());
    views.push_back(makeXabslView());
    views.push_back(makeSensorView());
    views.push_back(makeTimeView());
    views.push_back(makePlotView());
    return views;
  }();
  return list;
}

}  // namespace gt
