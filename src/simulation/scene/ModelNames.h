#pragma once
#include <libxml/tree.h>
#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

namespace gt {

/// The prefixes that the names of a model file get in a scene.
struct ModelPrefixes {
  std::string things;  ///< Bodies, joints, geoms, sensors and so on.
  std::string assets;  ///< Materials, meshes, textures, height fields and default classes.
  /// The scene's name of the file's main class; the scene's own main class is empty.
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

/// The references of an element to things, without those of elements below it. References to assets
/// are not included.
std::vector<ModelReference> referencesOf(const xmlNode* node);

/// Adds the prefixes to all names and references in an element and below it.
void prefixNames(xmlNode* node, const ModelPrefixes& prefixes, bool asset);

/// Sets the file's main class at the elements of a section that have no class and may have one.
void setMainClass(xmlNode* section, const ModelPrefixes& prefixes);

}  // namespace gt
