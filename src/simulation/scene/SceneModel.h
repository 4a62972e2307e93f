#pragma once
#include <vector>

#include "base/Random.h"
#include "base/Result.h"
#include "simulation/scene/MuJoCo.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// The compiled model of a scene: the field, then the robots and extras in their order, then the
/// balls. MuJoCo 2.2.2 cannot attach one model to another, so the texts are joined: the names
/// inside a robot begin with the robot's name and a slash ("red1/headPan"), those inside a ball
/// with "ball0/" and so on. Materials and classes of a model file begin with the file's stem
/// ("ers210/gray"); the color class of a material is what stands behind the last slash, up to a
/// dot. Robots of the blue team wear "blue" where the model names "red".
///
/// The joined text only determines which things the model has. Each file is also compiled alone,
/// under its own compiler and defaults, and all its numbers are copied from there: so a file has
/// the same effect in a scene as alone. Of a robot's or ball's file, the first body comes into the
/// scene, with its contacts, equalities, tendons and sensors. `warnings` gets a line for each part
/// that is left out. `audience` places the people behind the outer wall.
Result<Model> composeModel(const SceneDescription& scene, const Random& audience = Random{},
                           std::vector<Error>* warnings = nullptr);
/// Adds to `findings` all errors that keep a scene's model from being composed, and warnings about
/// parts that are left out of it.
void checkModel(const SceneDescription& scene, std::vector<Error>& findings);

}  // namespace gt
