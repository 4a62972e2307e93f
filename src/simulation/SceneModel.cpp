#include "simulation/SceneModel.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "base/Enum.h"
#include "simulation/ScenePeople.h"
#include "simulation/Xml.h"

namespace gt {
namespace {

void setAttribute(xmlNode* node, const char* name, const std::string& value) {
  xmlSetProp(node, BAD_CAST name, BAD_CAST value.c_str());
}

void addPrefix(xmlNode* node, const char* name, const std::string& prefix) {
  const std::string value = attribute(node, name);
  if (!value.empty()) setAttribute(node, name, prefix + value);
}

/// Calls visit(element) for an element and all below it.
template <typename Visit>
void forEachElement(xmlNode* node, const Visit& visit) {
  if (node->type != XML_ELEMENT_NODE) return;
  visit(node);
  for (xmlNode* child = node->children; child; child = child->next) forEachElement(child, visit);
}

xmlNode* childOf(xmlNode* parent, const char* name, bool create = false) {
  for (xmlNode* child = parent->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE && nameOf(child) == name) return child;
  return create ? xmlNewChild(parent, nullptr, BAD_CAST name, nullptr) : nullptr;
}

/// Joins models to one document.
class Composer {
 public:
  explicit Composer(const SceneDescription& scene) : scene_(scene) {}

  Result<std::string> compose();

 private:
  /// A model file that was read: its defaults and assets stand in the document already.
  struct Part {
    XmlDocument document;
    std::string prefix;
    xmlNode* body = nullptr;
  };

  Result<Part*> part(const std::string& file, const FilePlace& place);
  void addShared(const Part& part);
  xmlNode* addBody(const Part& part, const std::string& prefix);
  Result<void> addRobot(const SceneRobot& robot);
  Result<void> addBall(const SceneBall& ball, std::size_t index);
  void removeFlags();

  const SceneDescription& scene_;
  XmlDocument document_;
  xmlNode* root_ = nullptr;
  std::map<std::string, Part> parts_;
};

Result<Composer::Part*> Composer::part(const std::string& file, const FilePlace& place) {
  if (const auto known = parts_.find(file); known != parts_.end()) return &known->second;
  const std::string path = scene_.resolve(file);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    return errorAt(scene_.file, place, "model", "there is no file " + path);
  auto document = readXml(path, "mujoco");
  if (!document) return document.error();
  Part part;
  part.document = std::move(*document);
  part.prefix = std::filesystem::path{file}.stem().string() + "/";
  xmlNode* root = xmlDocGetRootElement(part.document.get());
  if (xmlNode* world = childOf(root, "worldbody")) part.body = childOf(world, "body");
  if (!part.body) return Error{path, lineOf(root), "worldbody", "expected a <body> in it"};
  addShared(part);
  return &parts_.emplace(file, std::move(part)).first->second;
}

void Composer::addShared(const Part& part) {
  for (const char* section : {"default", "asset"}) {
    xmlNode* from = childOf(xmlDocGetRootElement(part.document.get()), section);
    if (!from) continue;
    xmlNode* into = childOf(root_, section, true);
    for (xmlNode* child = from->children; child; child = child->next) {
      if (child->type != XML_ELEMENT_NODE) continue;
      xmlNode* copy = xmlAddChild(into, xmlDocCopyNode(child, document_.get(), 1));
      forEachElement(copy, [&](xmlNode* node) {
        for (const char* name : {"name", "class", "material"}) addPrefix(node, name, part.prefix);
      });
    }
  }
}

xmlNode* Composer::addBody(const Part& part, const std::string& prefix) {
  xmlNode* copy =
      xmlAddChild(childOf(root_, "worldbody", true), xmlDocCopyNode(part.body, document_.get(), 1));
  forEachElement(copy, [&](xmlNode* node) {
    addPrefix(node, "name", prefix);
    for (const char* name : {"class", "childclass", "material"}) addPrefix(node, name, part.prefix);
  });
  return copy;
}

Result<void> Composer::addRobot(const SceneRobot& robot) {
  auto model = part(robot.model, robot.place);
  if (!model) return model.error();
  const Part& part = **model;
  xmlNode* body = addBody(part, robot.name + "/");
  // Tricots are the geoms of class "tricot"; an explicit material overrides the class's red.
  forEachElement(body, [&](xmlNode* node) {
    if (robot.team == TeamColor::blue && attribute(node, "class") == part.prefix + "tricot")
      setAttribute(node, "material", part.prefix + "blue");
  });
  return {};
}

Result<void> Composer::addBall(const SceneBall& ball, std::size_t index) {
  auto model = part(ball.model, ball.place);
  if (!model) return model.error();
  addBody(**model, "ball" + std::to_string(index) + "/");
  return {};
}

/// As in the localization challenge of 2003 (facts, 2.3).
void Composer::removeFlags() {
  std::vector<xmlNode*> flags;
  forEachElement(childOf(root_, "worldbody", true), [&](xmlNode* node) {
    if (attribute(node, "class") == "flag") flags.push_back(node);
  });
  for (xmlNode* flag : flags) {
    xmlUnlinkNode(flag);
    xmlFreeNode(flag);
  }
}

Result<std::string> Composer::compose() {
  const std::string path = scene_.resolve(scene_.field);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    return Error{scene_.file, 0, "field", "there is no file " + path};
  auto field = readXml(path, "mujoco");
  if (!field) return field.error();
  document_ = std::move(*field);
  root_ = xmlDocGetRootElement(document_.get());
  if (!scene_.flags) removeFlags();
  addAudience(childOf(root_, "worldbody", true), scene_.audience);
  addReferees(childOf(root_, "worldbody", true), scene_.referees);
  for (const auto* group : {&scene_.robots, &scene_.extras})
    for (const SceneRobot& robot : *group)
      if (auto r = addRobot(robot); !r) return r.error();
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
    if (auto r = addBall(scene_.balls[i], i); !r) return r.error();

  xmlChar* text = nullptr;
  int size = 0;
  xmlDocDumpFormatMemory(document_.get(), &text, &size, 1);
  std::string result{reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
  xmlFree(text);
  return result;
}

}  // namespace

Result<std::string> composeText(const SceneDescription& scene) {
  return Composer{scene}.compose();
}

Result<Model> composeModel(const SceneDescription& scene) {
  const auto text = composeText(scene);
  if (!text) return text.error();
  auto model = compileModel(*text, scene.file);
  if (model) return model;
  // Lines of the joined text tell nothing: one of the files is to blame, or they do not fit.
  std::set<std::string> files{scene.field};
  for (const auto* group : {&scene.robots, &scene.extras})
    for (const SceneRobot& robot : *group) files.insert(robot.model);
  for (const SceneBall& ball : scene.balls) files.insert(ball.model);
  for (const std::string& name : files) {
    std::ifstream file{scene.resolve(name)};
    const std::string content{std::istreambuf_iterator<char>{file}, {}};
    if (auto alone = compileModel(content, scene.resolve(name)); !alone) return alone.error();
  }
  return Error{scene.file, 0, "", "its models do not fit together: " + model.error().what};
}

}  // namespace gt
