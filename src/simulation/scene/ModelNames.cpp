#include "simulation/scene/ModelNames.h"

#include <array>
#include <string_view>
#include <utility>

#include "simulation/scene/ModelRows.h"
#include "simulation/scene/Xml.h"

namespace gt {
namespace {

constexpr std::array references{
    std::pair{"body", mjOBJ_BODY},      std::pair{"body1", mjOBJ_BODY},
    std::pair{"body2", mjOBJ_BODY},     std::pair{"target", mjOBJ_BODY},
    std::pair{"geom", mjOBJ_GEOM},      std::pair{"geom1", mjOBJ_GEOM},
    std::pair{"geom2", mjOBJ_GEOM},     std::pair{"sidesite", mjOBJ_SITE},
    std::pair{"site", mjOBJ_SITE},      std::pair{"refsite", mjOBJ_SITE},
    std::pair{"cranksite", mjOBJ_SITE}, std::pair{"slidersite", mjOBJ_SITE},
    std::pair{"joint", mjOBJ_JOINT},    std::pair{"joint1", mjOBJ_JOINT},
    std::pair{"joint2", mjOBJ_JOINT},   std::pair{"jointinparent", mjOBJ_JOINT},
    std::pair{"tendon", mjOBJ_TENDON},  std::pair{"tendon1", mjOBJ_TENDON},
    std::pair{"tendon2", mjOBJ_TENDON}, std::pair{"actuator", mjOBJ_ACTUATOR}};

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  for (const std::string_view one : names)
    if (one == name) return true;
  return false;
}

/// The type that an attribute such as objtype="site" names.
mjtObj namedType(const std::string& name) {
  return static_cast<mjtObj>(mju_str2Type(name.c_str()));
}

bool isAssetType(mjtObj type) {
  return type == mjOBJ_MATERIAL || type == mjOBJ_MESH || type == mjOBJ_TEXTURE ||
         type == mjOBJ_HFIELD;
}

void addPrefix(xmlNode* node, const char* name, const std::string& prefix) {
  const std::string value = attribute(node, name);
  if (!value.empty()) setAttribute(node, name, prefix + value);
}

}  // namespace

std::string classOf(const xmlNode* node) {
  std::string name = attribute(node, "class");
  while (name.empty() && (node = node->parent) && node->type == XML_ELEMENT_NODE)
    name = attribute(node, "childclass");
  return name.empty() ? "main" : name;
}

std::vector<ModelReference> referencesOf(const xmlNode* node) {
  std::vector<ModelReference> found;
  for (const auto& [name, type] : references)
    if (const std::string value = attribute(node, name); !value.empty())
      found.push_back({name, value, type});
  for (const auto& [name, type] : {std::pair{"objname", "objtype"}, {"refname", "reftype"}})
    if (const std::string value = attribute(node, name); !value.empty())
      if (const mjtObj kind = namedType(attribute(node, type)); !isAssetType(kind))
        found.push_back({name, value, kind});
  return found;
}

void prefixNames(xmlNode* top, const ModelPrefixes& prefixes, bool asset) {
  forEachElement(top, [&](xmlNode* node) {
    // The world is the scene's.
    for (const ModelReference& reference : referencesOf(node))
      if (reference.name != "world" || modelKindOf(reference.type) != ModelKind::body)
        setAttribute(node, reference.attribute.c_str(), prefixes.things + reference.name);
    for (const auto& [name, type] : {std::pair{"objname", "objtype"}, {"refname", "reftype"}})
      if (isAssetType(namedType(attribute(node, type)))) addPrefix(node, name, prefixes.assets);
    addPrefix(node, "name", asset ? prefixes.assets : prefixes.things);
    for (const char* name : {"material", "mesh", "texture", "hfield"})
      addPrefix(node, name, prefixes.assets);
    for (const char* name : {"class", "childclass"}) {
      const std::string value = attribute(node, name);
      if (!value.empty())
        setAttribute(node, name, value == "main" ? prefixes.mainClass() : prefixes.assets + value);
    }
    // A composite's bodies, joints and so on have names that begin with its own prefix.
    if (nameOf(node) == "composite" && !prefixes.things.empty())
      setAttribute(node, "prefix", prefixes.things + attribute(node, "prefix"));
  });
}

void setMainClass(xmlNode* section, const ModelPrefixes& prefixes) {
  if (!isOneOf(nameOf(section),
               {"asset", "worldbody", "contact", "equality", "tendon", "actuator"}))
    return;
  for (xmlNode* node : elementsOf(section)) {
    const std::string name = nameOf(node);
    if (isOneOf(name, {"exclude", "texture", "hfield", "skin", "composite"})) continue;
    const char* kind = name == "body" ? "childclass" : "class";
    if (attribute(node, kind).empty()) setAttribute(node, kind, prefixes.mainClass());
  }
}

}  // namespace gt
