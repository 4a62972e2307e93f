#pragma once
#include <mujoco/mujoco.h>

namespace gt {

constexpr int hiddenGroup = 5;  ///< Geoms of this MuJoCo group appear in no image.

/// The color of a geom, that of its material if it has one: red, green, blue and opacity, 0 to 1.
inline const float* rgbaOf(const mjModel& model, int geom) {
  const int material = model.geom_matid[geom];
  return material >= 0 ? model.mat_rgba + 4 * material : model.geom_rgba + 4 * geom;
}

}  // namespace gt
