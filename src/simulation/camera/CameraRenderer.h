#pragma once
#include <mujoco/mujoco.h>

#include <cstdint>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraScene.h"
#include "simulation/camera/CameraView.h"
#include "simulation/camera/MotionBlur.h"
#include "simulation/camera/PictureEffects.h"
#include "simulation/camera/Projection.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// What each pixel of a picture really shows, row by row. Provided by the CameraRenderer.
struct PictureTruth {
  std::vector<ColorClass> classes;
  std::vector<int> geoms;  ///< MuJoCo's geom, -1 for the background.
};

/// Takes the pictures of simulated cameras. Each thread needs one of its own, the scene is shared.
/// From the second picture of a size on, nothing is allocated.
class CameraRenderer {
 public:
  explicit CameraRenderer(const CameraScene& scene) : scene_{&scene} {}

  /// Takes a picture of the world in `data`, which belongs to the scene's model. The same input and
  /// seed give the same bytes; a seed should be used for one picture only. Sets all of `image` but
  /// its time.
  void render(const mjData& data, const CameraView& view, const CameraEffects& effects,
              std::uint64_t seed, Image& image, PictureTruth* truth = nullptr);

 private:
  void drawScene(const mjData& data, int hiddenBody);
  void tell(PictureTruth& truth) const;

  const CameraScene* scene_;
  Projection projection_;
  Rasterizer rasterizer_;
  MotionBlur motionBlur_;
  PictureEffects effects_;
};

}  // namespace gt
