#pragma once
#include <libxml/tree.h>
#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

namespace gt {

/// What the names of a model file begin with in a scene.
struct ModelPrefixes {
  std::string things;  ///< Bodies, joints, geoms, sensors and so on.
  std::string assets;  ///< Materials, meshes, textures, height fields and default classes.
  /// The class that the file's own main class becomes: a scene's is empty.
  std::string mainClass() const { return assets.empty() ? "/main" : assets + "main"; }
};

/// A name that an element refers to.
struct ModelReference {
  std::string attribute;
  std::string name;
  mjtObj type = mjOBJ_UNKNOWN;
};

/// The class of an element of a file: its own, or the childclass of a body around it.
std::string classOf(const xmlNode* node);

/// The things that an element refers to, without those below it. Assets are none.
std::vector<ModelReference> referencesOf(const xmlNode* node);

/// Gives the names in an element and below it their prefixes, and references likewise.
void prefixNames(xmlNode* node, const ModelPrefixes& prefixes, bool asset);

/// Gives the elements of a section the file's main class where they have none and may have one.
void setMainClass(xmlNode* section, const ModelPrefixes& prefixes);

}  // namespace gt
