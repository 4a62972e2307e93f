#include "views/ScenePicture.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "simulation/camera/CameraRenderer.h"

namespace gt {
namespace {

/// Number of the camera's pixels in each direction whose mean is a pixel of the image, so that
/// edges are smooth.
constexpr int fineness = 3;
/// Geoms of this group are not drawn (CameraScene).
constexpr int unseenGroup = 5;

CameraView viewOf(const SceneCamera& camera) {
  const Vector3d ahead = camera.at - camera.from;
  Pose3D pose;
  pose.translation = camera.from;
  pose.rotation = rotationZ(std::atan2(ahead.y(), ahead.x())) *
                  rotationY(-std::atan2(ahead.z(), ahead.head<2>().norm()));
  CameraView view;
  view.first = view.last = pose;
  view.info.width = camera.width * fineness;
  view.info.height = camera.height * fineness;
  view.info.focalX = view.info.focalY =
      view.info.width / (2 * std::tan(fromDegrees(camera.openingAngle) / 2));
  view.info.centerX = view.info.width / 2.0;
  view.info.centerY = view.info.height / 2.0;
  return view;
}

/// Reduces an image: each pixel is the mean of a square of pixels.
RgbImage reduced(const RgbImage& fine) {
  RgbImage picture{fine.width / fineness, fine.height / fineness, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (int row = y * fineness; row < (y + 1) * fineness; ++row)
          for (int column = x * fineness; column < (x + 1) * fineness; ++column)
            sum += fine.pixels[static_cast<std::size_t>(3 * (row * fine.width + column) + channel)];
        picture.pixels.push_back(static_cast<std::uint8_t>(sum / (fineness * fineness)));
      }
  return picture;
}

}  // namespace

RgbImage scenePicture(const World& world, const SceneCamera& camera, std::string_view hidden) {
  using OwnModel = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
  OwnModel changed{nullptr, mj_deleteModel};
  if (!hidden.empty()) {
    changed.reset(mj_copyModel(nullptr, &world.model()));
    for (int geom = 0; geom < changed->ngeom; ++geom) {
      const char* const name = mj_id2name(changed.get(), mjOBJ_GEOM, geom);
      if (name && std::string_view{name}.starts_with(hidden))
        changed->geom_group[geom] = unseenGroup;
    }
  }
  const CameraScene scene{changed ? *changed : world.model()};
  Image image;
  CameraRenderer{scene}.render(world.data(), viewOf(camera), CameraEffects::none(), 0, image);
  return reduced(rgbOf(image));
}

}  // namespace gt
