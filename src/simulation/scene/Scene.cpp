#include "simulation/scene/Scene.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "base/Enum.h"
#include "simulation/scene/Xml.h"
#include "simulation/world/World.h"
#include "streams/File.h"

namespace gt {
namespace {

/// Reads the elements of one scene file, and goes on after errors.
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
  void readOptics(const xmlNode* node, CameraInfo& optics);
  void readElement(const xmlNode* node, SceneDescription& scene);
  void readRobots(const xmlNode* group, std::vector<SceneRobot>& into);
  void readBalls(const xmlNode* group, std::vector<SceneBall>& into);
  void expectEmpty(const xmlNode* node);
  void checkRobots(const SceneDescription& scene);

  std::string path_;
  XmlPlaces places_;
  std::vector<Error>& errors_;
};

/// An element as a person knows it: <robot>.
std::string tag(const xmlNode* node) {
  return std::string{"<"}.append(nameOf(node)).append(">");
}

std::optional<std::string> parse(const std::string& text, const Range& range, double& value) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(number))
    return "expected a number, found \"" + text + "\"";
  if (range.bounds() && (number < range.low || number > range.high))
    return text + " is outside " + std::to_string(range.low) + " .. " + std::to_string(range.high);
  value = number;
  return std::nullopt;
}

std::optional<std::string> parse(const std::string& text, const Range& range, int& value) {
  double number = 0;
  if (auto wrong = parse(text, range, number)) return wrong;
  value = static_cast<int>(number);
  if (value != number) return "expected a whole number, found \"" + text + "\"";
  return std::nullopt;
}

std::optional<std::string> parse(const std::string& text, const Range&, std::string& value) {
  if (text.empty()) return "must not be empty";
  value = text;
  return std::nullopt;
}

std::optional<std::string> parse(const std::string& text, const Range&, bool& value) {
  if (text != "true" && text != "false") return "expected true or false, found \"" + text + "\"";
  value = text == "true";
  return std::nullopt;
}

template <typename E>
requires std::is_enum_v<E> std::optional<std::string> parse(const std::string& text, const Range&,
                                                            E& value) {
  if (const auto e = enumValue<E>(text)) {
    value = *e;
    return std::nullopt;
  }
  std::string names;
  for (const auto name : enumNames<E>) names += (names.empty() ? "" : ", ") + std::string{name};
  return "expected one of " + names + ", found \"" + text + "\"";
}

template <typename T>
void SceneReader::readAttributes(const xmlNode* node, T& into) {
  for (const xmlAttr* a = node->properties; a; a = a->next) {
    if (a->ns) continue;  // xsi:noNamespaceSchemaLocation
    const std::string name = nameOf(reinterpret_cast<const xmlNode*>(a));
    const std::string value = attribute(node, name.c_str());
    bool known = false;
    std::optional<std::string> wrong;
    forEachField(into, [&](const auto& f, auto& member) {
      if (f.name != name) return;
      known = true;
      wrong = parse(value, f.range, member);
    });
    if (!known) error(node, name, tag(node) + " has no such attribute");
    if (wrong) error(node, name, *wrong);
  }
}

void SceneReader::readOptics(const xmlNode* node, CameraInfo& optics) {
  readAttributes(node, optics);
  if (attribute(node, "centerX").empty()) optics.centerX = optics.width / 2.0;
  if (attribute(node, "centerY").empty()) optics.centerY = optics.height / 2.0;
  constexpr int largest = 1280;  // Each robot has such pictures.
  for (const auto& [name, size] : {std::pair{"width", optics.width}, {"height", optics.height}})
    if (size > largest) error(node, name, "expected at most " + std::to_string(largest));
  constexpr double longest = static_cast<double>((World::cameraHistory - 1) * tickMs);
  if ((optics.height - 1) * optics.rowTime > longest)
    error(node, "rowTime", "all rows together take longer than " + std::to_string(longest) + " ms");
}

void SceneReader::expectEmpty(const xmlNode* node) {
  for (const xmlNode* child = node->children; child; child = child->next)
    if (child->type != XML_COMMENT_NODE) error(child, nameOf(child), tag(node) + " has no content");
}

void SceneReader::readRobots(const xmlNode* group, std::vector<SceneRobot>& into) {
  for (const xmlNode* node = group->children; node; node = node->next) {
    if (node->type == XML_COMMENT_NODE) continue;
    if (node->type != XML_ELEMENT_NODE || nameOf(node) != "robot") {
      error(node, nameOf(node), "expected <robot>");
      continue;
    }
    SceneRobot robot;
    robot.place = places_.of(node);
    readAttributes(node, robot);
    expectEmpty(node);
    if (robot.name.empty())
      robot.name = std::string{enumName(robot.team)} + std::to_string(robot.player().number());
    into.push_back(robot);
  }
}

void SceneReader::readBalls(const xmlNode* group, std::vector<SceneBall>& into) {
  for (const xmlNode* node = group->children; node; node = node->next) {
    if (node->type == XML_COMMENT_NODE) continue;
    if (node->type != XML_ELEMENT_NODE || nameOf(node) != "ball") {
      error(node, nameOf(node), "expected <ball>");
      continue;
    }
    SceneBall ball;
    ball.place = places_.of(node);
    readAttributes(node, ball);
    expectEmpty(node);
    into.push_back(ball);
    if (into.size() == maxSceneBalls + 1)
      error(node, "ball", "is one more than " + std::to_string(maxSceneBalls));
  }
}

void SceneReader::readElement(const xmlNode* node, SceneDescription& scene) {
  const std::string name = nameOf(node);
  struct NoAttributes {
    static constexpr auto fields() { return Fields{}; }
  } none;
  if (name == "robots" || name == "extras" || name == "balls") {
    readAttributes(node, none);
    if (name == "balls") return readBalls(node, scene.balls);
    return readRobots(node, name == "robots" ? scene.robots : scene.extras);
  }
  expectEmpty(node);
  if (name == "noise") return readAttributes(node, scene.noise);
  if (name == "camera") return readAttributes(node, scene.camera);
  if (name == "optics") return readOptics(node, scene.optics);
  if (name == "physics") return readAttributes(node, scene.physics);
  if (name == "radio") {
    readAttributes(node, scene.radio);
    if (scene.radio.delayMin > scene.radio.delayMax)
      error(node, "delayMin", "is greater than delayMax");
    return;
  }
  if (name == "game") return readAttributes(node, scene.game);
  if (name == "rules") return readAttributes(node, scene.rules);
  return error(node, name,
               "expected <noise>, <camera>, <optics>, <physics>, <radio>, <game>, <rules>, "
               "<robots>, <extras> or <balls>");
}

void SceneReader::checkRobots(const SceneDescription& scene) {
  std::set<std::string> names;
  std::set<std::pair<TeamColor, PlayerRole>> players;
  std::size_t count = 0;
  for (const auto* group : {&scene.robots, &scene.extras})
    for (const SceneRobot& robot : *group) {
      if (++count == maxSceneRobots + 1)
        error(robot.place, "robot", "is one more than " + std::to_string(maxSceneRobots));
      if (robot.name.find('/') != std::string::npos)
        error(robot.place, "name", "\"" + robot.name + "\" must not contain a slash");
      if (!names.insert(robot.name).second)
        error(robot.place, "name", "a second robot \"" + robot.name + "\"");
      const bool plays = scene.game.referee && group == &scene.robots;
      if (plays && !players.insert({robot.team, robot.role}).second)
        error(robot.place, "role",
              "a second " + std::string{enumName(robot.role)} + " of the " +
                  std::string{enumName(robot.team)} + " team");
    }
}

SceneDescription SceneReader::read(const xmlNode* root) {
  SceneDescription scene;
  scene.file = path_;
  readAttributes(root, scene);
  std::set<std::string> seen;
  for (const xmlNode* node = root->children; node; node = node->next) {
    if (node->type == XML_COMMENT_NODE) continue;
    if (node->type != XML_ELEMENT_NODE)
      error(node, nameOf(node), "expected an element");
    else if (!seen.insert(nameOf(node)).second)
      error(node, nameOf(node), "a second " + tag(node));
    else
      readElement(node, scene);
  }
  checkRobots(scene);
  return scene;
}

}  // namespace

std::string SceneDescription::resolve(const std::string& path) const {
  const std::filesystem::path p{path};
  if (p.is_absolute()) return path;
  return (std::filesystem::path{file}.parent_path() / p).lexically_normal().string();
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

}  // namespace gt
