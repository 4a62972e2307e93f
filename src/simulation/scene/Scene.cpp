#include "simulation/scene/Scene.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "base/Enum.h"
#include "base/File.h"
#include "simulation/scene/ProfileTable.h"
#include "simulation/scene/Xml.h"
#include "streams/Type.h"

namespace gt {
namespace {

/// Reads the elements of one scene file, and continues after errors.
class SceneReader {
 public:
  SceneReader(const std::string& path, const xmlDoc& document, std::string_view text,
              std::vector<Error>& errors)
      : path_(path), places_(document, text), errors_(errors) {}

  SceneDescription read(const xmlNode* root);

 private:
  void error(const FilePlace& place, const std::string& field, const std::string& what) {
    errors_.push_back(errorAt(path_, place, field, what));
  }
  /// At an element, or at one of its attributes.
  void error(const xmlNode* node, const std::string& field, const std::string& what) {
    error(places_.of(node, field), field, what);
  }

  template <typename T>
  void readAttributes(const xmlNode* node, T& into);
  void readProfile(const xmlNode* root, SceneDescription& scene);
  void checkOptics(const xmlNode* node, CameraInfo& optics);
  void readElement(const xmlNode* node, SceneDescription& scene);
  /// Calls visit(node) for each element of a group, which has no others than these.
  template <typename Visit>
  void forEachMember(const xmlNode* group, const std::string& element, Visit visit);
  void readRobots(const xmlNode* group, std::vector<SceneRobot>& into);
  void readBalls(const xmlNode* group, std::vector<SceneBall>& into);
  void expectEmpty(const xmlNode* node);
  void checkRobots(const SceneDescription& scene);

  std::string path_;
  XmlPlaces places_;
  std::vector<Error>& errors_;
};

/// Calls visit(child) for each child of a node but comments.
template <typename Visit>
void forEachChild(const xmlNode* node, const Visit& visit) {
  for (const xmlNode* child = node->children; child; child = child->next)
    if (child->type != XML_COMMENT_NODE) visit(child);
}

/// An element as it stands in a file: <robot>.
std::string tag(const xmlNode* node) {
  return std::string{"<"}.append(nameOf(node)).append(">");
}

/// Parses an attribute's value. If it is invalid, returns the reason and leaves the member
/// unchanged.
template <typename T>
std::optional<std::string> readValue(const std::string& text, const Range& range, T& member) {
  if (text.empty()) return "must not be empty";
  T value = member;
  auto done = setScalar(valueOf(value), text, range);
  if constexpr (std::is_floating_point_v<T>)
    if (done && !std::isfinite(value)) done = Error{.what = "expected a number"};
  if (!done) {
    const std::string& what = done.error().what;
    return what.starts_with("expected") ? what + ", found \"" + text + "\"" : what;
  }
  member = std::move(value);
  return std::nullopt;
}

template <typename T>
void SceneReader::readAttributes(const xmlNode* node, T& into) {
  for (const xmlAttr* a = node->properties; a; a = a->next) {
    if (a->ns) continue;  // xsi:noNamespaceSchemaLocation
    const std::string name = nameOf(reinterpret_cast<const xmlNode*>(a));
    const std::string value = attribute(node, name.c_str());
    std::optional<std::string> wrong = tag(node) + " has no such attribute";
    forEachField(into, [&](const auto& f, auto& member) {
      if (f.name == name) wrong = readValue(value, f.range, member);
    });
    if (wrong) error(node, name, *wrong);
  }
}

/// Applies the profile, before anything else of the scene is read. A wrong name of a profile is
/// reported with the errors of the other attributes.
void SceneReader::readProfile(const xmlNode* root, SceneDescription& scene) {
  setProfile(scene, enumValue<Profile>(attribute(root, "profile")).value_or(Profile::padova));
}

void SceneReader::checkOptics(const xmlNode* node, CameraInfo& optics) {
  if (attribute(node, "centerX").empty()) optics.centerX = optics.width / 2.0;
  if (attribute(node, "centerY").empty()) optics.centerY = optics.height / 2.0;
  for (const auto& [name, size] : {std::pair{"width", optics.width}, {"height", optics.height}})
    if (size > maxImageSize) error(node, name, "expected at most " + std::to_string(maxImageSize));
  constexpr double longest = CameraEffects::longestImage;
  if ((optics.height - 1) * optics.rowTime > longest)
    error(node, "rowTime", "all rows together take longer than " + std::to_string(longest) + " ms");
}

void SceneReader::expectEmpty(const xmlNode* node) {
  forEachChild(node, [&](const xmlNode* child) {
    error(child, nameOf(child), tag(node) + " has no content");
  });
}

template <typename Visit>
void SceneReader::forEachMember(const xmlNode* group, const std::string& element, Visit visit) {
  struct NoAttributes {
    static constexpr auto fields() { return Fields{}; }
  } none;
  readAttributes(group, none);
  forEachChild(group, [&](const xmlNode* node) {
    if (node->type != XML_ELEMENT_NODE || nameOf(node) != element)
      return error(node, nameOf(node), "expected <" + element + ">");
    visit(node);
    expectEmpty(node);
  });
}

void SceneReader::readRobots(const xmlNode* group, std::vector<SceneRobot>& into) {
  forEachMember(group, "robot", [&](const xmlNode* node) {
    SceneRobot& robot = into.emplace_back();
    robot.place = places_.of(node);
    readAttributes(node, robot);
    if (robot.name.empty())
      robot.name = std::string{enumName(robot.team)} + std::to_string(robot.player().number());
  });
}

void SceneReader::readBalls(const xmlNode* group, std::vector<SceneBall>& into) {
  forEachMember(group, "ball", [&](const xmlNode* node) {
    SceneBall& ball = into.emplace_back();
    ball.place = places_.of(node);
    readAttributes(node, ball);
    if (into.size() == maxSceneBalls + 1)
      error(node, "ball", "is one more than " + std::to_string(maxSceneBalls));
  });
}

void SceneReader::readElement(const xmlNode* node, SceneDescription& scene) {
  const std::string name = nameOf(node);
  std::map<std::string, std::function<void()>> readers;
  const auto addLeaf = [&](std::string_view element, auto& parameters) {
    readers.emplace(element, [this, node, &parameters] {
      readAttributes(node, parameters);
      expectEmpty(node);
    });
  };
  forEachProfileElement(scene, addLeaf);
  addLeaf("optics", scene.optics);
  addLeaf("dynamics", scene.dynamics);
  addLeaf("game", scene.game);
  addLeaf("rules", scene.rules);
  readers["ceilingCamera"] = [&] {
    readAttributes(node, scene.ceilingCamera.emplace());
    expectEmpty(node);
  };
  readers["challenge"] = [&] {
    readAttributes(node, scene.challenge.emplace());
    expectEmpty(node);
  };
  readers["robots"] = [&] { readRobots(node, scene.robots); };
  readers["extras"] = [&] { readRobots(node, scene.extras); };
  readers["balls"] = [&] { readBalls(node, scene.balls); };
  if (const auto reader = readers.find(name); reader != readers.end()) {
    reader->second();
    if (name == "optics") checkOptics(node, scene.optics);
    if (name == "radio" && scene.radio.delayMin > scene.radio.delayMax)
      error(node, "delayMin", "is greater than delayMax");
    return;
  }
  std::string names;
  for (const auto& [known, read] : readers) names += (names.empty() ? "<" : ", <") + known + ">";
  error(node, name, "expected one of " + names);
}

void SceneReader::checkRobots(const SceneDescription& scene) {
  std::set<std::string> names;
  std::set<std::pair<TeamColor, PlayerRole>> players;
  std::size_t count = 0;
  for (const SceneRobot* robot : scene.allRobots()) {
    const std::string &name = robot->name, &address = robot->address;
    if (++count == maxSceneRobots + 1)
      error(robot->place, "robot", "is one more than " + std::to_string(maxSceneRobots));
    if (name.find('/') != std::string::npos)
      error(robot->place, "name", "\"" + name + "\" must not contain a slash");
    constexpr std::string_view digits = "0123456789ABCDEF";
    if (!address.empty() &&
        (address.size() != 12 || address.find_first_not_of(digits) != std::string::npos))
      error(robot->place, "address", "expected 12 digits 0 to F, found \"" + address + "\"");
    if (!names.insert(name).second) error(robot->place, "name", "a second robot \"" + name + "\"");
    const bool plays = scene.game.referee && count <= scene.robots.size();
    if (plays && !players.insert({robot->team, robot->role}).second)
      error(robot->place, "role",
            "a second " + std::string{enumName(robot->role)} + " of the " +
                std::string{enumName(robot->team)} + " team");
  }
}

SceneDescription SceneReader::read(const xmlNode* root) {
  SceneDescription scene;
  scene.file = path_;
  scene.fieldPlace = places_.of(root, "field");
  scene.configPlace = places_.of(root, "config");
  scene.scriptPlace = places_.of(root, "script");
  readProfile(root, scene);
  readAttributes(root, scene);
  std::set<std::string> seen;
  forEachChild(root, [&](const xmlNode* node) {
    if (node->type != XML_ELEMENT_NODE)
      error(node, nameOf(node), "expected an element");
    else if (!seen.insert(nameOf(node)).second)
      error(node, nameOf(node), "a second " + tag(node));
    else
      readElement(node, scene);
  });
  checkRobots(scene);
  return scene;
}

}  // namespace

std::vector<const SceneRobot*> SceneDescription::allRobots() const {
  std::vector<const SceneRobot*> all;
  for (const auto* group : {&robots, &extras})
    for (const SceneRobot& robot : *group) all.push_back(&robot);
  return all;
}

std::string SceneDescription::resolve(const std::string& path) const {
  const std::filesystem::path p{path};
  if (p.is_absolute()) return path;
  return (std::filesystem::path{file}.parent_path() / p).lexically_normal().string();
}

Error SceneDescription::missing(const std::string& named, const FilePlace& place,
                                const std::string& attribute) const {
  const std::string what = attribute == "config" ? "there is no folder " : "there is no file ";
  const SceneDescription usual;
  const bool unwritten = named == usual.field || named == usual.config ||
                         named == SceneRobot{}.model || named == SceneRobot{}.layout ||
                         named == SceneBall{}.model;
  return errorAt(
      file, place, attribute,
      what + resolve(named) + (unwritten ? "; " + named + " is the attribute's default" : ""));
}

std::string SceneDescription::startScript() const {
  if (script.empty()) {
    const std::string usual = resolve("console.con");
    return std::filesystem::is_regular_file(usual) ? usual : "";
  }
  std::filesystem::path path{resolve(script)};
  if (!path.has_extension()) path += ".con";
  return path.string();
}

SceneDescription loadScene(const std::string& path, std::vector<Error>& errors) {
  const auto document = readXml(path, "scene");
  const auto text = readFile(path);
  if (document && text)
    return SceneReader{path, **document, *text, errors}.read(xmlDocGetRootElement(document->get()));
  errors.push_back(document ? text.error() : document.error());
  return {};
}

Result<SceneDescription> loadScene(const std::string& path) {
  std::vector<Error> errors;
  SceneDescription scene = loadScene(path, errors);
  if (!errors.empty()) return errors.front();
  return scene;
}

void findSceneFiles(const SceneDescription& scene, std::vector<Error>& errors) {
  std::error_code code;
  if (!std::filesystem::is_directory(scene.resolve(scene.config), code))
    errors.push_back(scene.missing(scene.config, scene.configPlace, "config"));
  const std::string script = scene.startScript();
  if (!script.empty() && !std::filesystem::is_regular_file(script, code))
    errors.push_back(
        errorAt(scene.file, scene.scriptPlace, "script", "there is no file " + script));
  for (const SceneRobot& robot : scene.robots)
    if (!std::filesystem::is_regular_file(scene.resolve(robot.layout), code))
      errors.push_back(scene.missing(robot.layout, robot.place, "layout"));
}

Result<void> findSceneFiles(const SceneDescription& scene) {
  std::vector<Error> errors;
  findSceneFiles(scene, errors);
  return errors.empty() ? Result<void>{} : errors.front();
}

}  // namespace gt
