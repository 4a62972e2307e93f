#include "simulation/scene/SceneModel.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "simulation/scene/ModelSource.h"

namespace gt {
namespace {

xmlNode* addElement(xmlNode* parent, const char* name) {
  return xmlNewChild(parent, nullptr, BAD_CAST name, nullptr);
}

/// Joins models to one document, and collects errors and warnings about parts that are left out.
class Composer {
 public:
  Composer(const SceneDescription& scene, const Random& audience, std::vector<Error>& findings)
      : scene_(scene), audience_(audience), findings_(findings) {
    xmlDocSetRootElement(document_.get(), root_);
  }

  /// The scene's model; null after an error.
  Model compose();

 private:
  /// A copy of a file's things in the scene, whose rows stand one behind another.
  struct Part {
    const ModelSource* source;
    ModelRows rows;
    std::string prefix;
  };

  void readSources();
  bool isThere(const std::string& file, const FilePlace& place, const char* field);
  void readBody(const std::string& file, const FilePlace& place);
  bool isRight() const;
  std::vector<const ModelSource*> allSources() const;

  xmlNode* add(xmlNode* into, xmlNode* element, const ModelPrefixes& prefixes, bool asset = false);
  void addCompiler();
  void addMeshOption(xmlNode* compiler, const char* name, const char* usual);
  void addDefaults(const ModelSource& source);
  void addField();
  void addAssets(const ModelSource& source);
  void addBody(const std::string& file, const std::string& name, TeamColor team);

  void wearBlue(const ModelSource& source, xmlNode* body);

  Result<Model> compileWhole();
  void deriveConstants(mjModel& model) const;
  Error misfit(const ModelSource& source) const;

  const SceneDescription& scene_;
  const Random audience_;
  std::vector<Error>& findings_;
  XmlDocument document_{xmlNewDoc(BAD_CAST "1.0")};
  xmlNode* root_ = xmlNewNode(nullptr, BAD_CAST "mujoco");
  xmlNode* defaults_ = nullptr;
  std::optional<ModelSource> field_;
  /// Of robots and balls, by path; empty if something is wrong with the file.
  std::map<std::string, std::optional<ModelSource>> sources_;
  std::set<std::string> assetPrefixes_;
  std::vector<Part> parts_;
};

bool Composer::isThere(const std::string& file, const FilePlace& place, const char* field) {
  const std::string path = scene_.resolve(file);
  std::error_code code;
  if (std::filesystem::is_regular_file(path, code)) return true;
  findings_.push_back(scene_.missing(file, place, field));
  return false;
}

void Composer::readBody(const std::string& file, const FilePlace& place) {
  const std::string path = scene_.resolve(file);
  if (sources_.contains(path) || !isThere(file, place, "model")) return;
  // Files of one name may stand in several folders.
  const std::string stem = std::filesystem::path{path}.stem().string();
  std::string prefix = stem + "/";
  for (int i = 2; !assetPrefixes_.insert(prefix).second; ++i)
    prefix = stem + std::to_string(i) + "/";
  sources_[path] = readBodySource(path, prefix, findings_);
}

bool Composer::isRight() const {
  return std::ranges::none_of(findings_,
                              [](const Error& e) { return e.severity == Severity::error; });
}

/// Reads all files, even if one of them has errors.
void Composer::readSources() {
  if (isThere(scene_.field, scene_.fieldPlace, "field"))
    field_ = readFieldSource(scene_, audience_, findings_);
  for (const SceneRobot* robot : scene_.allRobots()) readBody(robot->model, robot->place);
  for (const SceneBall& ball : scene_.balls) readBody(ball.model, ball.place);
}

xmlNode* Composer::add(xmlNode* into, xmlNode* element, const ModelPrefixes& prefixes, bool asset) {
  xmlNode* copy = xmlAddChild(into, xmlDocCopyNode(element, document_.get(), 1));
  prefixNames(copy, prefixes, asset);
  return copy;
}

std::vector<const ModelSource*> Composer::allSources() const {
  std::vector<const ModelSource*> all{&*field_};
  for (const auto& [path, source] : sources_) all.push_back(&*source);
  return all;
}

/// Sets an option for meshes. Meshes are compiled in the joined model, so all files must state the
/// same value.
void Composer::addMeshOption(xmlNode* compiler, const char* name, const char* usual) {
  for (const ModelSource* source : allSources()) {
    if (source->alone->nmesh == 0) continue;
    std::string value = source->file.compilerAttribute(name);
    if (value.empty()) value = usual;
    if (const std::string other = attribute(compiler, name); other.empty()) {
      setAttribute(compiler, name, value);
    } else if (other != value) {
      const xmlNode* place = source->file.compilerWith(name);
      findings_.push_back(source->file.at(place ? place : source->file.root(), name,
                                          "expected \"" + other +
                                              "\", which another file of the scene has: one counts "
                                              "for all meshes"));
    }
  }
}

/// Adds a compiler under which every file that is valid alone is valid. The model's numbers do not
/// come from it.
void Composer::addCompiler() {
  xmlNode* compiler = addElement(root_, "compiler");
  setAttribute(compiler, "angle", "degree");
  setAttribute(compiler, "autolimits", "true");
  addMeshOption(compiler, "convexhull", "true");
  addMeshOption(compiler, "exactmeshinertia", "false");
  for (const ModelSource* source : allSources()) {
    if (source->file.compilerAttribute("balanceinertia") == "true")
      setAttribute(compiler, "balanceinertia", "true");
    for (const char* name : {"boundmass", "boundinertia"}) {
      const std::string bound = source->file.compilerAttribute(name);
      if (std::atof(bound.c_str()) > std::atof(attribute(compiler, name).c_str()))
        setAttribute(compiler, name, bound);
    }
  }
  for (xmlNode* own : field_->file.sections("compiler"))
    for (xmlNode* child : elementsOf(own)) add(compiler, child, field_->prefixes);
}

/// A file's main class becomes a class below the scene's main one, which is empty. A later section
/// adds to the main class of an earlier one, but not to the classes that stand in that.
void Composer::addDefaults(const ModelSource& source) {
  const std::vector<xmlNode*> sections = source.file.sections("default");
  xmlNode* own = defaults_;
  for (std::size_t i = 0; i < std::max<std::size_t>(sections.size(), 1); ++i) {
    own = addElement(own, "default");
    const bool last = i + 1 >= sections.size();
    setAttribute(own, "class", source.prefixes.mainClass() + (last ? "" : std::to_string(i)));
    if (i >= sections.size()) break;
    for (xmlNode* element : elementsOf(sections[i])) add(own, element, source.prefixes, true);
  }
}

void Composer::addField() {
  addDefaults(*field_);
  for (xmlNode* section : elementsOf(field_->file.root())) {
    const std::string name = nameOf(section);
    if (name == "compiler" || name == "default") continue;
    setMainClass(add(root_, section, field_->prefixes, name == "asset"), field_->prefixes);
  }
  parts_.push_back({&*field_, field_->rows, ""});
}

void Composer::addAssets(const ModelSource& source) {
  for (xmlNode* section : source.file.sections("asset"))
    setMainClass(add(root_, section, source.prefixes, true), source.prefixes);
}

/// Tricots are the geoms of class "tricot"; an explicit material overrides the class's red.
void Composer::wearBlue(const ModelSource& source, xmlNode* body) {
  const auto tricots = [](xmlNode* top) {
    std::vector<xmlNode*> found;
    forEachElement(top, [&](xmlNode* node) {
      if (nameOf(node) == "geom" && classOf(node) == "tricot") found.push_back(node);
    });
    return found;
  };
  for (xmlNode* tricot : tricots(body)) setAttribute(tricot, "material", "blue");
  if (mj_name2id(source.alone.get(), mjOBJ_MATERIAL, "blue") >= 0) return;
  for (const xmlNode* tricot : tricots(source.body))
    findings_.push_back(source.file.at(tricot, "material",
                                       "expected a material \"blue\" for robots of the blue team"));
}

void Composer::addBody(const std::string& file, const std::string& name, TeamColor team) {
  ModelSource& source = *sources_.at(scene_.resolve(file));
  const bool first =
      std::ranges::none_of(parts_, [&](const Part& p) { return p.source == &source; });
  Part& part = parts_.emplace_back(Part{&source, source.rows, name + "/"});
  if (first) {
    addDefaults(source);
    addAssets(source);
  } else {
    part.rows[ModelKind::material].clear();
  }
  const ModelPrefixes prefixes{part.prefix, source.prefixes.assets};
  xmlNode* world = addElement(root_, "worldbody");
  xmlNode* body = xmlAddChild(world, xmlDocCopyNode(source.body, document_.get(), 1));
  if (team == TeamColor::blue) wearBlue(source, body);
  prefixNames(body, prefixes, false);
  setMainClass(world, prefixes);
  for (const char* sections : {"contact", "equality", "tendon", "sensor"})
    for (xmlNode* section : source.file.sections(sections))
      setMainClass(add(root_, section, prefixes), prefixes);
}

/// The error about a file whose parts do not fit those of the joined model, because its compiler
/// leaves parts out or fuses them.
Error Composer::misfit(const ModelSource& source) const {
  for (const char* name : {"discardvisual", "fusestatic"})
    if (source.file.compilerAttribute(name) == "true")
      return source.file.at(source.file.compilerWith(name), name,
                            "changes what the model consists of, which a scene cannot take over: "
                            "expected \"false\"");
  return source.file.at(source.file.root(), "",
                        "cannot be joined to the scene: it consists of other parts there");
}

/// Lets MuJoCo derive again the values that depend on changed numbers. Statistics that the field's
/// file states are kept.
void Composer::deriveConstants(mjModel& model) const {
  const mjStatistic before = model.stat;
  mj_setConst(&model, makeData(model).get());
  for (const xmlNode* section : field_->file.sections("statistic")) {
    for (const auto& [name, value] : {std::pair{"meaninertia", &mjStatistic::meaninertia},
                                      {"meanmass", &mjStatistic::meanmass},
                                      {"meansize", &mjStatistic::meansize},
                                      {"extent", &mjStatistic::extent}})
      if (!attribute(section, name).empty()) model.stat.*value = before.*value;
    if (!attribute(section, "center").empty()) std::ranges::copy(before.center, model.stat.center);
  }
}

/// Compiles the document, and copies into the model the numbers of each file compiled alone.
Result<Model> Composer::compileWhole() {
  auto whole = compileModel(xmlText(*document_), scene_.file);
  if (!whole)
    return Error{.file = scene_.file,
                 .what = "its models do not fit together: " + whole.error().what};
  mjModel& model = **whole;
  OfModelKinds<int> first;
  bool changed = false;
  for (const Part& part : parts_) {
    NumberCopy numbers{*part.source->alone, part.rows, model, first, part.prefix};
    if (!numbers.fits()) return misfit(*part.source);
    changed |= numbers.copy();
    for (std::size_t kind = 0; kind < first.values.size(); ++kind)
      first.values[kind] += static_cast<int>(part.rows.values[kind].size());
  }
  for (std::size_t kind = 0; kind < first.values.size(); ++kind)
    if (first.values[kind] != countOf(model, static_cast<ModelKind>(kind)))
      return misfit(*parts_.back().source);
  if (changed) deriveConstants(model);
  return whole;
}

Model Composer::compose() {
  readSources();
  if (!isRight()) return nullptr;
  setAttribute(root_, "model", attribute(field_->file.root(), "model"));
  addCompiler();
  if (!isRight()) return nullptr;
  defaults_ = addElement(root_, "default");
  addField();
  for (const SceneRobot* robot : scene_.allRobots())
    addBody(robot->model, robot->name, robot->team);
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
    addBody(scene_.balls[i].model, "ball" + std::to_string(i), TeamColor::red);
  if (!isRight()) return nullptr;
  auto whole = compileWhole();
  if (whole) return std::move(*whole);
  findings_.push_back(whole.error());
  return nullptr;
}

}  // namespace

Result<Model> composeModel(const SceneDescription& scene, const Random& audience,
                           std::vector<Error>* warnings) {
  std::vector<Error> findings;
  auto model = Composer{scene, audience, findings}.compose();
  const auto error = std::ranges::find(findings, Severity::error, &Error::severity);
  if (!model) return *error;
  if (warnings) *warnings = std::move(findings);
  return model;
}

void checkModel(const SceneDescription& scene, std::vector<Error>& findings) {
  std::vector<Error> own;
  Composer{scene, Random{}, own}.compose();
  findings.insert(findings.end(), own.begin(), own.end());
}

}  // namespace gt
