#include "simulation/camera/CameraRenderer.h"

#include <cmath>
#include <limits>

#include "simulation/camera/Lighting.h"
#include "simulation/camera/ShapeDrawer.h"

namespace gt {
namespace {

bool isFinite(const Pose3D& pose) {
  return pose.rotation.allFinite() && pose.translation.allFinite();
}

}  // namespace

void CameraRenderer::render(const mjData& data, const CameraView& view,
                            const CameraEffects& effects, std::uint64_t seed, Image& image,
                            ImageTruth* truth) {
  image.info = view.info;
  image.allocate();
  rasterizer_.begin(view.info.width, view.info.height, scene_->background(),
                    truth != nullptr || effects.pixelShading);
  if (isFinite(view.first) && isFinite(view.last)) {
    projection_.set(view, effects.rollingShutter);
    drawScene(data, view.hiddenBody);
    if (effects.pixelShading)
      Lighting{scene_->model()}.shade(data, view, effects.rollingShutter, effects.shadows, *scene_,
                                      rasterizer_);
  }
  if (truth) {
    readTruth(*truth);
    if (truth->withDepths) measureDepths(data, view, effects.rollingShutter, truth->depths);
  }
  takePlanes(rasterizer_, planes_);
  if (effects.exposure > 0 && isFinite(view.first) && isFinite(view.last))
    motionBlur_.apply(view, effects.exposure, planes_);
  if (effects.colors())
    effects_.apply(planes_, view, effects, seed, image);
  else
    joinPlanes(planes_, image);
}

void CameraRenderer::drawScene(const mjData& data, int hiddenBody) {
  ShapeDrawer drawer{*scene_, projection_, rasterizer_};
  for (const CameraCluster& cluster : scene_->clusters()) {
    if (std::isfinite(cluster.reach)) {
      const Eigen::Vector3d root{data.xpos + 3 * cluster.body};
      if (projection_.visibility(projection_.toCamera(root.cast<float>()), cluster.reach) ==
          Projection::Visibility::hidden)
        continue;
    }
    for (int i = cluster.first; i < cluster.first + cluster.count; ++i) {
      const CameraShape& shape = scene_->shapes()[static_cast<std::size_t>(i)];
      if (shape.body != hiddenBody)
        drawer.draw(shape, data.geom_xpos + 3 * shape.geom, data.geom_xmat + 9 * shape.geom);
    }
  }
}

void CameraRenderer::readTruth(ImageTruth& truth) const {
  truth.classes.clear();
  truth.geoms.clear();
  for (int y = 0; y < rasterizer_.height(); ++y) {
    const PackedColor* colors = rasterizer_.row(y);
    for (int x = 0; x < rasterizer_.width(); ++x)
      truth.classes.push_back(static_cast<ColorClass>(colors[x] >> 24));
    const std::int32_t* geoms = rasterizer_.geomRow(y);
    truth.geoms.insert(truth.geoms.end(), geoms, geoms + rasterizer_.width());
  }
}

void CameraRenderer::measureDepths(const mjData& data, const CameraView& view, bool rollingShutter,
                                   std::vector<float>& depths) const {
  const Lighting rays{scene_->model()};
  depths.clear();
  for (int y = 0; y < rasterizer_.height(); ++y) {
    const double share = rollingShutter ? static_cast<double>(y) / (rasterizer_.height() - 1) : 0.5;
    const Pose3D pose = interpolated(view.first, view.last, share);
    const std::int32_t* geoms = rasterizer_.geomRow(y);
    for (int x = 0; x < rasterizer_.width(); ++x) {
      const Vector3d ray = view.info.ray(x + 0.5, y + 0.5);  // 1 along the optical axis
      const RayHit hit = geoms[x] < 0 ? RayHit{}
                                      : rays.castAt(data, geoms[x], pose.translation / 1000,
                                                    (pose.rotation * ray).normalized());
      depths.push_back(hit.geom < 0 ? std::numeric_limits<float>::infinity()
                                    : static_cast<float>(1000 * hit.distance / ray.norm()));
    }
  }
}

}  // namespace gt
