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

/// A model file as a scene takes it: what MuJoCo makes of it alone, and what of it comes into the
/// scene. What does not has been removed from the document.
struct ModelSource {
  ModelFile file;
  Model alone;
  ModelPrefixes prefixes;   ///< The one of things is another for each robot and ball.
  xmlNode* body = nullptr;  ///< A robot's or ball's; null for a field.
  ModelRows rows;           ///< What the scene takes of `alone`.
};

/// Reads a scene's field and adds the people around it. What is wrong or left out is added to a
/// list; empty if something is wrong.
std::optional<ModelSource> readFieldSource(const SceneDescription& scene, const Random& audience,
                                           std::vector<Error>& findings);

/// Reads the model of robots or balls: its first body, and the contacts, equalities, tendons and
/// sensors that concern nothing else.
std::optional<ModelSource> readBodySource(const std::string& path, const std::string& assetPrefix,
                                          std::vector<Error>& findings);

}  // namespace gt
