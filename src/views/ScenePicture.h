#pragma once
#include "simulation/world/World.h"
#include "views/painting/Sheet.h"

namespace gt {

/// The camera from which a scene is drawn.
struct SceneCamera {
  Vector3d from{0, -3600, 2300};   ///< mm on the field
  Vector3d at{0, -150, 0};         ///< mm on the field
  double openingAngle = 64;        ///< Horizontal opening angle in degrees.
  int width = 1280, height = 720;  ///< pixels
};

/// Renders an image of the world with smooth edges and without the errors of a robot's camera.
/// Geoms whose names begin with `hidden` are left out, if it is not empty.
RgbImage scenePicture(const World& world, const SceneCamera& camera, std::string_view hidden = {});

}  // namespace gt
