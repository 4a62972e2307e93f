#include "simulation/scene/ModelSource.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/scene/FieldSensorModel.h"
#include "simulation/scene/ScenePeople.h"

namespace gt {
namespace {

/// Sections of a robot's or ball's file that do not come into a scene, and why.
constexpr std::array unusedSections{
    std::pair{"actuator", "the simulator's own servos move the joints"},
    std::pair{"option", "that of the field counts"},
    std::pair{"visual", "that of the field counts"},
    std::pair{"statistic", "that of the field counts"},
    std::pair{"custom", "only that of the field is read"},
    std::pair{"keyframe", "the scene puts robots and balls"}};

void remove(xmlNode* node) {
  xmlUnlinkNode(node);
  xmlFreeNode(node);
}

xmlNode* worldOf(ModelFile& file) {
  const auto worlds = file.sections("worldbody");
  return worlds.empty() ? xmlNewChild(file.root(), nullptr, BAD_CAST "worldbody", nullptr)
                        : worlds.front();
}

/// Removes the flags, as in the localization challenge of 2003 (facts, 2.3).
void removeFlags(ModelFile& field) {
  std::vector<xmlNode*> flags;
  for (xmlNode* world : field.sections("worldbody"))
    forEachElement(world, [&](xmlNode* node) {
      const std::string name = nameOf(node);
      if ((name == "geom" || name == "site") && classOf(node) == "flag") flags.push_back(node);
    });
  for (xmlNode* flag : flags) remove(flag);
}

/// Gives the geoms that stand on the floor bodies of their own. MuJoCo tests all geoms of two
/// bodies with each other if the bodies are near each other, and all are near the world's body.
void separateField(ModelFile& field) {
  // `fusestatic` would undo this, `settotalmass` would count the masses of the new bodies.
  if (field.compilerAttribute("fusestatic") == "true" ||
      !field.compilerAttribute("settotalmass").empty())
    return;
  std::vector<xmlNode*> geoms;
  xmlNode* next = nullptr;
  for (xmlNode* world : field.sections("worldbody"))
    for (xmlNode* child : elementsOf(world)) {
      const bool solid = nameOf(child) == "body" || nameOf(child) == "composite";
      if (!next && solid) next = child;
      if (nameOf(child) != "geom") continue;
      // Geoms keep their numbers: all before the last floor stay what they are.
      attribute(child, "type") == "plane" ? geoms.clear() : geoms.push_back(child);
    }
  xmlNode* world = worldOf(field);
  for (xmlNode* geom : geoms) {
    xmlNode* body = xmlNewNode(nullptr, BAD_CAST "body");
    next ? xmlAddPrevSibling(next, body) : xmlAddChild(world, body);
    xmlUnlinkNode(geom);
    xmlAddChild(body, geom);
  }
}

/// Selects what is left out of a model file, and collects the messages about it.
class Selection {
 public:
  Selection(ModelSource& source, std::vector<Error>& findings)
      : source_{source}, model_{*source.alone}, findings_{findings} {}

  void ofField();
  void ofBody();

 private:
  void leaveOut(xmlNode* node, const std::string& why) {
    warn(node, nameOf(node), "is left out of the scene: " + why);
    remove(node);
  }
  void warn(const xmlNode* node, const std::string& field, const std::string& what) {
    findings_.push_back(source_.file.at(node, field, what, Severity::warning));
  }
  void error(const xmlNode* node, const std::string& field, const std::string& what) {
    findings_.push_back(source_.file.at(node, field, what));
  }
  void setOption(xmlNode* option, const char* name, bool same, const char* why);
  void removeBesideBody();
  /// The reference of an element that is not in the scene; empty if there is none.
  std::string missing(xmlNode* node) const;
  void takeList(const char* section, ModelKind kind);
  void takeContacts();

  ModelSource& source_;
  const mjModel& model_;
  std::vector<Error>& findings_;
};

/// Removes an option that the simulator sets itself. Warns if the file's option differs.
void Selection::setOption(xmlNode* option, const char* name, bool same, const char* why) {
  if (attribute(option, name).empty()) return;
  if (!same) warn(option, name, std::string{"is left out of the scene: "} + why);
  xmlUnsetProp(option, BAD_CAST name);
}

void Selection::ofField() {
  for (xmlNode* option : source_.file.sections("option")) {
    const mjtNum* gravity = model_.opt.gravity;
    setOption(option, "timestep", false, "the simulator's own step counts");
    setOption(option, "solver", model_.opt.solver == mjSOL_NEWTON, "the simulator uses Newton's");
    setOption(option, "gravity",
              gravity[0] == 0 && gravity[1] == 0 && std::abs(gravity[2] + 9.81) < 0.01,
              "the simulator's own gravity counts");
  }
  // Sizes are MuJoCo's to choose: robots and balls are added.
  for (xmlNode* size : source_.file.sections("size")) remove(size);
  for (xmlNode* keys : source_.file.sections("keyframe"))
    leaveOut(keys, "it has no place for robots and balls");
  source_.rows = ModelRows::all(model_);
}

void Selection::ofBody() {
  for (const auto& [section, why] : unusedSections)
    for (xmlNode* node : source_.file.sections(section)) leaveOut(node, why);
  for (xmlNode* size : source_.file.sections("size")) remove(size);
  for (xmlNode* assets : source_.file.sections("asset"))
    for (xmlNode* asset : elementsOf(assets))
      if (nameOf(asset) == "skin") leaveOut(asset, "cameras see geoms only");
  removeBesideBody();
  if (!source_.body) return;
  const std::string name = attribute(source_.body, "name");
  const int body = name.empty() ? 1 : mj_name2id(&model_, mjOBJ_BODY, name.c_str());
  if (body < 1) return error(source_.body, "body", "is not part of the model");
  source_.rows = ModelRows::below(model_, body);
  source_.rows[ModelKind::material] = ModelRows::all(model_)[ModelKind::material];
  forEachElement(source_.body, [&](xmlNode* node) {
    if (const std::string other = missing(node); !other.empty())
      error(node, nameOf(node), "refers to " + other + ", which is not below the first body");
  });
  takeList("tendon", ModelKind::tendon);
  takeList("equality", ModelKind::equality);
  takeList("sensor", ModelKind::sensor);
  takeContacts();
}

/// A robot or ball is the first body of its file.
void Selection::removeBesideBody() {
  for (xmlNode* world : source_.file.sections("worldbody"))
    for (xmlNode* child : elementsOf(world)) {
      if (!source_.body && nameOf(child) == "body")
        source_.body = child;
      else
        leaveOut(child, "only the first body of the file is put");
    }
  if (!source_.body) error(source_.file.root(), "worldbody", "expected a <body> in it");
}

std::string Selection::missing(xmlNode* node) const {
  for (const auto& [attribute, name, type] : referencesOf(node)) {
    const std::optional<ModelKind> kind = modelKindOf(type);
    if (kind == ModelKind::body && name == "world") continue;
    if (!kind || !source_.rows.has(*kind, mj_name2id(&model_, type, name.c_str())))
      return "\"" + name + "\"";
  }
  return "";
}

/// Selects elements of a section whose rows have the same order in the model.
void Selection::takeList(const char* section, ModelKind kind) {
  std::vector<xmlNode*> elements;
  for (xmlNode* node : source_.file.sections(section))
    for (xmlNode* element : elementsOf(node)) elements.push_back(element);
  if (static_cast<int>(elements.size()) != countOf(model_, kind))
    return error(source_.body, "composite",
                 std::string{"makes a <"} + section + ">, which cannot be joined to a scene");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const int id = static_cast<int>(i);
    std::string other;
    forEachElement(elements[i], [&](xmlNode* node) {
      if (other.empty()) other = missing(node);
    });
    if (!other.empty())
      leaveOut(elements[i], "refers to " + other + ", which is not below the first body");
    else if (kind == ModelKind::sensor &&
             (model_.sensor_type[id] == mjSENS_USER || !fieldSensor(model_, id)))
      leaveOut(elements[i], "is of a kind that the simulator does not know");
    else
      source_.rows[kind].push_back(id);
  }
}

/// MuJoCo sorts pairs and exclusions, so their rows are found by what they refer to.
void Selection::takeContacts() {
  for (xmlNode* contacts : source_.file.sections("contact"))
    for (xmlNode* contact : elementsOf(contacts))
      if (const std::string other = missing(contact); !other.empty())
        leaveOut(contact, "refers to " + other + ", which is not below the first body");
  for (int pair = 0; pair < model_.npair; ++pair)
    if (source_.rows.has(ModelKind::geom, model_.pair_geom1[pair]) &&
        source_.rows.has(ModelKind::geom, model_.pair_geom2[pair]))
      source_.rows[ModelKind::pair].push_back(pair);
}

bool hasErrors(const std::vector<Error>& findings, std::size_t from) {
  return std::any_of(findings.begin() + static_cast<std::ptrdiff_t>(from), findings.end(),
                     [](const Error& e) { return e.severity == Severity::error; });
}

std::optional<ModelSource> compiled(ModelFile file, ModelPrefixes prefixes,
                                    std::vector<Error>& findings) {
  auto alone = file.compile();
  if (alone) return ModelSource{std::move(file), std::move(*alone), std::move(prefixes), {}, {}};
  findings.push_back(alone.error());
  return std::nullopt;
}

}  // namespace

std::optional<ModelSource> readFieldSource(const SceneDescription& scene, const Random& audience,
                                           std::vector<Error>& findings) {
  auto file = ModelFile::read(scene.resolve(scene.field), findings);
  if (!file) return std::nullopt;
  if (!scene.flags) removeFlags(*file);
  addAudience(worldOf(*file), scene.audience, audience);
  addReferees(worldOf(*file), scene.referees);
  if (scene.fidelity == Fidelity::dynamic) separateField(*file);
  auto source = compiled(std::move(*file), {}, findings);
  if (source) Selection{*source, findings}.ofField();
  return source;
}

std::optional<ModelSource> readBodySource(const std::string& path, const std::string& assetPrefix,
                                          std::vector<Error>& findings) {
  const std::size_t before = findings.size();
  auto file = ModelFile::read(path, findings);
  if (!file) return std::nullopt;
  auto source = compiled(std::move(*file), {"", assetPrefix}, findings);
  if (source) Selection{*source, findings}.ofBody();
  if (hasErrors(findings, before)) return std::nullopt;
  return source;
}

}  // namespace gt
