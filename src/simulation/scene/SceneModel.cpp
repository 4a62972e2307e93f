#include "simulation/scene/SceneModel.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "base/Enum.h"
#include "simulation/scene/ScenePeople.h"
#include "simulation/scene/Xml.h"
#include "streams/File.h"

namespace gt {
namespace {

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

/// Joins models to one document, and collects what is wrong with them.
class Composer {
 public:
  Composer(const SceneDescription& scene, std::vector<Error>& errors)
      : scene_(scene), errors_(errors) {}

  /// The text of the whole; nothing after an error.
  std::optional<std::string> compose();

 private:
  /// A model file that was read: its defaults and assets stand in the document already.
  struct Part {
    XmlDocument document;
    std::string prefix;
    xmlNode* body = nullptr;
  };

  /// A document that the scene names; null if it cannot be had.
  XmlDocument read(const std::string& file, const FilePlace& place, const char* field);
  /// A model; null if it cannot be had.
  const Part* part(const std::string& file, const FilePlace& place);
  void addShared(const Part& part);
  xmlNode* addBody(const Part& part, const std::string& prefix);
  void addRobot(const SceneRobot& robot);
  void addBall(const SceneBall& ball, std::size_t index);
  void removeFlags();
  void separateField();

  const SceneDescription& scene_;
  std::vector<Error>& errors_;
  XmlDocument document_;
  xmlNode* root_ = nullptr;
  std::map<std::string, Part> parts_;
};

XmlDocument Composer::read(const std::string& file, const FilePlace& place, const char* field) {
  const std::string path = scene_.resolve(file);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) {
    errors_.push_back(scene_.missing(file, place, field));
    return nullptr;
  }
  auto document = readXml(path, "mujoco");
  if (document) return std::move(*document);
  errors_.push_back(document.error());
  return nullptr;
}

const Composer::Part* Composer::part(const std::string& file, const FilePlace& place) {
  if (const auto known = parts_.find(file); known != parts_.end()) return &known->second;
  Part part;
  part.document = read(file, place, "model");
  if (!part.document) return nullptr;
  part.prefix = std::filesystem::path{file}.stem().string() + "/";
  xmlNode* root = xmlDocGetRootElement(part.document.get());
  if (xmlNode* world = childOf(root, "worldbody")) part.body = childOf(world, "body");
  if (!part.body) {
    errors_.push_back({scene_.resolve(file), lineOf(root), "worldbody", "expected a <body> in it"});
    return nullptr;
  }
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

void Composer::addRobot(const SceneRobot& robot) {
  const Part* part = this->part(robot.model, robot.place);
  if (!part) return;
  xmlNode* body = addBody(*part, robot.name + "/");
  // Tricots are the geoms of class "tricot"; an explicit material overrides the class's red.
  forEachElement(body, [&](xmlNode* node) {
    if (robot.team == TeamColor::blue && attribute(node, "class") == part->prefix + "tricot")
      setAttribute(node, "material", part->prefix + "blue");
  });
}

void Composer::addBall(const SceneBall& ball, std::size_t index) {
  if (const Part* part = this->part(ball.model, ball.place))
    addBody(*part, "ball" + std::to_string(index) + "/");
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

/// MuJoCo tests each geom of one body with each of another, but only bodies that are near each
/// other, and all are near the world's own: so what stands on the floor gets bodies of its own.
void Composer::separateField() {
  xmlNode* world = childOf(root_, "worldbody", true);
  std::vector<xmlNode*> geoms;
  for (xmlNode* child = world->children; child; child = child->next) {
    if (child->type != XML_ELEMENT_NODE || nameOf(child) != "geom") continue;
    // Geoms keep their numbers: all before the last floor stay what they are.
    attribute(child, "type") == "plane" ? geoms.clear() : geoms.push_back(child);
  }
  xmlNode* next = childOf(world, "body");
  for (xmlNode* geom : geoms) {
    xmlNode* body = xmlNewNode(nullptr, BAD_CAST "body");
    next ? xmlAddPrevSibling(next, body) : xmlAddChild(world, body);
    xmlUnlinkNode(geom);
    xmlAddChild(body, geom);
  }
}

std::optional<std::string> Composer::compose() {
  const std::size_t before = errors_.size();
  document_ = read(scene_.field, scene_.fieldPlace, "field");
  // The models are looked at even if there is no field to put them on.
  if (!document_) document_.reset(xmlNewDoc(BAD_CAST "1.0"));
  root_ = xmlDocGetRootElement(document_.get());
  if (!root_) {
    root_ = xmlNewNode(nullptr, BAD_CAST "mujoco");
    xmlDocSetRootElement(document_.get(), root_);
  }
  if (!scene_.flags) removeFlags();
  addAudience(childOf(root_, "worldbody", true), scene_.audience);
  addReferees(childOf(root_, "worldbody", true), scene_.referees);
  if (scene_.fidelity == Fidelity::dynamic) separateField();
  for (const SceneRobot* robot : scene_.allRobots()) addRobot(*robot);
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) addBall(scene_.balls[i], i);
  if (errors_.size() > before) return std::nullopt;

  xmlChar* text = nullptr;
  int size = 0;
  xmlDocDumpFormatMemory(document_.get(), &text, &size, 1);
  std::string result{reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
  xmlFree(text);
  return result;
}

/// Compiles each file of a scene alone that is not among the errors yet: lines of the joined text
/// mean nothing to a person.
void compileFiles(const SceneDescription& scene, std::vector<Error>& errors) {
  std::set<std::string> files{scene.resolve(scene.field)};
  for (const SceneRobot* robot : scene.allRobots()) files.insert(scene.resolve(robot->model));
  for (const SceneBall& ball : scene.balls) files.insert(scene.resolve(ball.model));
  for (const Error& error : errors) files.erase(error.file);
  for (const std::string& path : files) {
    const auto content = readFile(path);
    if (!content) continue;  // reported already
    if (auto alone = compileModel(*content, path); !alone) errors.push_back(alone.error());
  }
}

/// The model; null, and there are errors, if it cannot be made.
Model composed(const SceneDescription& scene, std::vector<Error>& errors) {
  const std::size_t before = errors.size();
  const auto text = Composer{scene, errors}.compose();
  std::optional<Error> misfit;
  if (text) {
    auto model = compileModel(*text, scene.file);
    if (model) return std::move(*model);
    misfit = {scene.file, 0, "", "its models do not fit together: " + model.error().what};
  }
  compileFiles(scene, errors);
  if (errors.size() == before) errors.push_back(*misfit);
  return nullptr;
}

}  // namespace

Result<Model> composeModel(const SceneDescription& scene) {
  std::vector<Error> errors;
  auto model = composed(scene, errors);
  if (model) return model;
  return errors.front();
}

void checkModel(const SceneDescription& scene, std::vector<Error>& errors) {
  composed(scene, errors);
}

}  // namespace gt
