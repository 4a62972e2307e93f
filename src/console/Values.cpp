#include "console/Values.h"

#include <algorithm>

#include "base/Number.h"
#include "console/Commands.h"

namespace gt {
namespace {

ConsoleValue ofNumber(double number) {
  return {numberText(number), number};
}

ConsoleValue ofText(std::string text) {
  if (text == "true" || text == "false") {
    const double number = text == "true";
    return {std::move(text), number};
  }
  const auto number = numberOf(text);
  return {std::move(text), number ? std::optional{*number} : std::nullopt};
}

template <typename E>
ConsoleValue ofEnum(E value) {
  return {std::string{enumName(value)}, std::nullopt};
}

std::pair<std::string, std::string> splitPath(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == path.npos ? std::pair{path, std::string{}}
                          : std::pair{path.substr(0, dot), path.substr(dot + 1)};
}

std::optional<ConsoleValue> gameValue(Session& session, const std::string& path) {
  const Referee& referee = session.simulation().referee();
  if (path == "time") return ofNumber(static_cast<double>(session.time().ms) / 1000);
  if (path == "half") return ofNumber(referee.half());
  if (path == "state") return ofEnum(referee.state());
  if (path == "kickOff") return ofEnum(referee.kickOff());
  if (path == "timeLeft")
    return ofNumber(static_cast<double>(referee.timeLeft(session.time())) / 1000);
  if (path == "score.red") return ofNumber(referee.score(TeamColor::red));
  if (path == "score.blue") return ofNumber(referee.score(TeamColor::blue));
  return std::nullopt;
}

/// The index of a ball by its name: ball is the first, ball1 the second.
std::optional<std::size_t> ballIndex(std::string_view name, std::size_t count) {
  if (!name.starts_with("ball")) return std::nullopt;
  const auto index =
      name == "ball" ? std::optional{std::size_t{0}} : numberFrom<std::size_t>(name.substr(4));
  return index && *index < count ? index : std::nullopt;
}

std::optional<ConsoleValue> ballValue(Session& session, const std::string& name,
                                      const std::string& field) {
  const World& world = session.simulation().world();
  const auto index = ballIndex(name, world.ballCount());
  if (!index) return std::nullopt;
  const BallState& ball = world.ball(*index);
  if (field == "x") return ofNumber(ball.position.x());
  if (field == "y") return ofNumber(ball.position.y());
  if (field == "speed") return ofNumber(ball.speed.norm());
  if (field == "toucher") {
    const auto& scene = session.simulation().scene();
    const auto toucher = static_cast<std::size_t>(ball.lastToucher);
    if (ball.lastToucher < 0) return ConsoleValue{"nobody", std::nullopt};
    return ConsoleValue{toucher < scene.robots.size()
                            ? scene.robots[toucher].name
                            : scene.extras[toucher - scene.robots.size()].name,
                        std::nullopt};
  }
  return std::nullopt;
}

/// The index in the world of a robot of the scene, active or passive.
std::optional<std::size_t> robotIndex(const SceneDescription& scene, std::string_view name) {
  const auto robots = scene.allRobots();
  const auto found = std::ranges::find(robots, name, &SceneRobot::name);
  return found == robots.end() ? std::nullopt : std::optional{std::size_t(found - robots.begin())};
}

std::optional<ConsoleValue> bodyValue(const RobotBody& body, const std::string& field) {
  if (field == "x") return ofNumber(body.pose.translation.x());
  if (field == "y") return ofNumber(body.pose.translation.y());
  if (field == "rotation") return ofNumber(toDegrees(body.pose.rotation));
  if (field == "height") return ofNumber(body.height);
  if (field == "tilt") return ofNumber(toDegrees(body.tilt));
  if (field == "roll") return ofNumber(toDegrees(body.roll));
  if (field == "walked") return ofNumber(body.walked);
  if (field == "posture") return ofEnum(body.posture);
  return std::nullopt;
}

Result<ConsoleValue> valueOfRobot(ConsoleRobot& robot, const std::string& path) {
  auto text = robot.observed().get(path);
  if (!text) return text.error();
  return ofText(std::move(*text));
}

/// An object of the scene tree, or one of its numbers.
std::optional<ConsoleValue> objectValue(Session& session, const std::string& path) {
  if (const auto object = objectPath(session, path))
    if (const auto value = session.tree().get(*object)) return ofText(*value);
  const std::size_t last = path.find_last_of("./");
  if (last == path.npos) return std::nullopt;
  const auto index = numberOf(path.substr(last + 1), 0, 100);
  const auto object = objectPath(session, path.substr(0, last));
  if (!index || !object) return std::nullopt;
  const auto value = session.tree().get(*object);
  const auto numbers = value ? splitWords(*value) : Result<Words>{value.error()};
  const auto at = static_cast<std::size_t>(*index);
  if (!numbers || at >= numbers->size()) return std::nullopt;
  return ofText((*numbers)[at]);
}

}  // namespace

std::optional<std::string> objectPath(Session& session, std::string path) {
  if (path.find('/') != path.npos) return path;
  std::ranges::replace(path, '.', '/');
  return session.tree().get(path) ? std::optional{path} : std::nullopt;
}

bool isOfMissingBody(Session& session, const std::string& path) {
  const auto [first, field] = splitPath(path);
  const ConsoleRobot* robot = session.find(first);
  return robot && !robot->index() && bodyValue({}, field);
}

Result<ConsoleValue> valueAt(Console& console, const std::string& path) {
  Session& session = console.session();
  if (auto value = gameValue(session, path)) return *value;
  const auto [first, field] = splitPath(path);
  if (auto value = ballValue(session, first, field)) return *value;
  if (const auto index = robotIndex(session.simulation().scene(), first))
    if (auto value = bodyValue(session.simulation().world().robot(*index), field)) return *value;
  if (isOfMissingBody(session, path))
    return Error{.field = path,
                 .what = "there is none: " + first + " has no body, it is no robot of the scene"};
  if (ConsoleRobot* robot = session.find(first)) {
    auto value = valueOfRobot(*robot, field);
    return value ? value : Error{.field = path, .what = value.error().what};
  }
  if (auto value = objectValue(session, path)) return *value;
  const auto robot = console.firstRobot();
  if (!robot || path.find('/') != path.npos)
    return Error{.field = path, .what = "there is no such value; try get ?"};
  return valueOfRobot(**robot, path);
}

std::optional<Vector2d> placeOf(Console& console, std::string_view name) {
  const World& world = console.session().simulation().world();
  if (const auto ball = ballIndex(name, world.ballCount())) return world.ball(*ball).position;
  if (const auto robot = robotIndex(console.session().simulation().scene(), name))
    return world.robot(*robot).pose.translation;
  return std::nullopt;
}

std::vector<std::string> valueNames(Console& console) {
  std::vector<std::string> names{"time",     "half",      "state",     "kickOff",
                                 "timeLeft", "score.red", "score.blue"};
  Session& session = console.session();
  for (std::size_t i = 0; i < session.simulation().world().ballCount(); ++i)
    for (const char* field : {"x", "y", "speed", "toucher"})
      names.push_back("ball" + (i == 0 ? "" : std::to_string(i)) + "." + field);
  for (const SceneRobot* robot : session.simulation().scene().allRobots())
    for (const char* field : {"x", "y", "rotation", "height", "tilt", "roll", "walked", "posture"})
      names.push_back(robot->name + "." + field);
  const auto first = console.firstRobot();
  if (!first) return names;
  ObservedRobot& robot = (*first)->observed();
  for (const std::string& representation : robot.representations())
    if (const auto paths = robot.paths(representation))
      names.insert(names.end(), paths->begin(), paths->end());
  return names;
}

}  // namespace gt
