#pragma once
#include <mujoco/mujoco.h>

#include <cstdint>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraScene.h"
#include "simulation/camera/CameraView.h"
#include "simulation/camera/ImageEffects.h"
#include "simulation/camera/ImagePlanes.h"
#include "simulation/camera/MotionBlur.h"
#include "simulation/camera/Projection.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// The true content of each pixel of an image, row by row. Provided by the CameraRenderer.
struct ImageTruth {
  std::vector<ColorClass> classes;
  std::vector<int> geoms;     ///< MuJoCo's geom, -1 for the background.
  bool withDepths = false;    ///< Whether to provide depths; each costs a ray.
  std::vector<float> depths;  ///< mm along the optical axis; infinite for the background.
};

/// Takes the images of simulated cameras. Each thread needs its own renderer; the scene is shared.
/// From the second image of a size on, nothing is allocated.
class CameraRenderer {
 public:
  explicit CameraRenderer(const CameraScene& scene) : scene_{&scene} {}

  /// Takes an image of the world in `data`, which belongs to the scene's model. The same input and
  /// seed give the same bytes; a seed should be used for one image only. Writes each pixel of
  /// `image` once and sets all of it but its time.
  void render(const mjData& data, const CameraView& view, const CameraEffects& effects,
              std::uint64_t seed, Image& image, ImageTruth* truth = nullptr);

 private:
  void drawScene(const mjData& data, int hiddenBody);
  void readTruth(ImageTruth& truth) const;
  void measureDepths(const mjData& data, const CameraView& view, bool rollingShutter,
                     std::vector<float>& depths) const;

  const CameraScene* scene_;
  Projection projection_;
  Rasterizer rasterizer_;
  ImagePlanes planes_;
  MotionBlur motionBlur_;
  ImageEffects effects_;
};

}  // namespace gt
