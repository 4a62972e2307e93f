#pragma once
#include <mujoco/mujoco.h>

#include "base/Geometry.h"
#include "simulation/camera/CameraScene.h"
#include "simulation/camera/CameraView.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// The first surface that a ray meets. Meters.
struct RayHit {
  int geom = -1;  ///< -1: nothing.
  Vector3d point = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();
  double distance = 0;
};

/// The lighting of surfaces by the emitters of a scene (report 5.1.1): the ambient intensity of the
/// model's headlight, which reaches all surfaces, and the model's lights: directional ones, spot
/// emitters (a cutoff below 90 degrees) and radial emitters. The radiation classes are red, green
/// and blue, which the camera converts to its own three channels. The model must outlive this; its
/// lights may change.
class Lighting {
 public:
  explicit Lighting(const mjModel& model) : model_(&model) {}

  /// The nearest surface along a ray from a point (m). The ray passes through `hiddenBody` and
  /// through geoms that no image shows.
  RayHit cast(const mjData& data, const Vector3d& from, const Vector3d& direction,
              int hiddenBody) const;
  /// The point where a ray from a point (m) meets one geom.
  RayHit castAt(const mjData& data, int geom, const Vector3d& from,
                const Vector3d& direction) const;
  /// The color of a lit surface; with shadows, only emitters that nothing hides light it.
  PackedColor color(const mjData& data, const RayHit& hit, ColorClass colorClass,
                    bool shadows) const;

  /// Lights each pixel of an image separately. The image must have been drawn with its geoms.
  void shade(const mjData& data, const CameraView& view, bool rollingShutter, bool shadows,
             const CameraScene& scene, Rasterizer& picture) const;

 private:
  bool hidden(const mjData& data, const Vector3d& from, const Vector3d& direction, double distance,
              int lit) const;
  Eigen::Vector3f lightFrom(const mjData& data, int light, const RayHit& hit, bool shadows) const;

  const mjModel* model_;
};

/// A camera with a spherical geometry (report 5.1.1): the angles between all neighboring pixels
/// are the same. Its image is lit like those of other cameras with per-pixel shading.
struct Facette {
  int columns = 64, rows = 32;
  double width = 2 * pi, height = pi;  ///< Opening angles in rad.

  /// Takes an image from a pose on the field (mm; x is the middle of the image, z up).
  void take(const Lighting& lighting, const CameraScene& scene, const mjData& data,
            const Pose3D& pose, int hiddenBody, bool shadows, Image& image) const;
};

}  // namespace gt
