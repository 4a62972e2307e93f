#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/Random.h"
#include "simulation/scene/ModelFile.h"
#include "simulation/scene/ModelNames.h"
#include "simulation/scene/ModelRows.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// A model file as a part of a scene: the model compiled from it alone, and the rows of that model
/// that come into the scene. All other elements have been removed from the document.
struct ModelSource {
  ModelFile file;
  Model alone;
  ModelPrefixes prefixes;   ///< The prefix of things differs for each robot and ball.
  xmlNode* body = nullptr;  ///< A robot's or ball's; null for a field.
  ModelRows rows;           ///< The rows of `alone` that come into the scene.
};

/// Reads a scene's field and adds the people around it. Adds errors and warnings about parts that
/// are left out to `findings`; empty if there is an error.
std::optional<ModelSource> readFieldSource(const SceneDescription& scene, const Random& audience,
                                           std::vector<Error>& findings);

/// Reads the model of robots or balls: its first body, and the contacts, equalities, tendons and
/// sensors that refer to nothing outside of that body.
std::optional<ModelSource> readBodySource(const std::string& path, const std::string& assetPrefix,
                                          std::vector<Error>& findings);

}  // namespace gt
