#include "simulation/scene/SceneTree.h"

#include <charconv>
#include <cmath>

#include "base/Enum.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr double farthest = 1e5;  // mm: nothing is put further away

std::string textOf(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                   std::round(number * 1000) / 1000 + 0.0)
                         .ptr;
    if (!text.empty()) text += ' ';
    text.append(digits.data(), end);
  }
  return text;
}

std::string textOf(bool value) {
  return value ? "true" : "false";
}

Error wrong(std::string what) {
  return {"", 0, "", std::move(what)};
}

Result<std::vector<double>> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || !(std::abs(number) <= farthest))
      return wrong("expected numbers up to " + textOf({farthest}) + ", found \"" + text + "\"");
    numbers.push_back(number);
    at = next;
  }
  return numbers;
}

template <typename E>
Result<E> enumOf(const std::string& text) {
  if (const auto value = enumValue<E>(text)) return *value;
  std::string names;
  for (const auto name : enumNames<E>) names += (names.empty() ? "" : ", ") + std::string{name};
  return wrong("expected one of " + names + ", found \"" + text + "\"");
}

Result<bool> boolOf(const std::string& text) {
  if (text == "true" || text == "on" || text == "1") return true;
  if (text == "false" || text == "off" || text == "0") return false;
  return wrong("expected on or off, found \"" + text + "\"");
}

std::string nameOf(const mjModel& model, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name ? name : "";
}

}  // namespace

SceneTree::SceneTree(Simulation& simulation) : simulation_(simulation) {
  const SceneDescription& scene = simulation_.scene();
  std::size_t i = 0;
  for (const auto* group : {&scene.robots, &scene.extras})
    for (const SceneRobot& robot : *group) addRobot(i++, robot.name);
  for (std::size_t ball = 0; ball < simulation_.world().ballCount(); ++ball) addBall(ball);
  addActuators();
  addFieldSensors();
  addEmitters();
  addField();
  addGame();
}

std::vector<SceneTree::Object> SceneTree::list(std::string_view path) const {
  while (!path.empty() && path.back() == '/') path.remove_suffix(1);
  std::vector<Object> objects;
  for (const auto& [name, node] : nodes_) {
    const bool below = name.size() > path.size() && name.starts_with(path) &&
                       (path.empty() || name[path.size()] == '/');
    if (below || name == path) objects.push_back({name, node.help, node.set != nullptr});
  }
  return objects;
}

Result<std::string> SceneTree::get(const std::string& path) const {
  const auto node = nodes_.find(path);
  if (node == nodes_.end()) return Error{"", 0, path, "there is no such object"};
  return node->second.get();
}

Result<void> SceneTree::set(const std::string& path, const std::string& value) {
  const auto node = nodes_.find(path);
  if (node == nodes_.end()) return Error{"", 0, path, "there is no such object"};
  if (!node->second.set) return Error{"", 0, path, "can only be watched"};
  if (const auto done = node->second.set(value); !done)
    return Error{"", 0, path, done.error().what};
  return {};
}

void SceneTree::add(std::string path, std::string_view help, std::function<std::string()> get,
                    std::function<Result<void>(const std::string&)> set) {
  nodes_.insert_or_assign(std::move(path), Node{help, std::move(get), std::move(set)});
}

void SceneTree::addNumbers(const std::string& path, std::string_view help,
                           std::function<std::string()> get, std::size_t least, std::size_t most,
                           std::function<void(const Numbers&)> set) {
  add(path, help, std::move(get), [=](const std::string& text) -> Result<void> {
    const auto numbers = numbersOf(text);
    if (!numbers) return numbers.error();
    if (numbers->size() < least || numbers->size() > most)
      return wrong("expected " + std::to_string(least) +
                   (most > least ? " to " + std::to_string(most) : "") + " numbers, found " +
                   std::to_string(numbers->size()));
    set(*numbers);
    return {};
  });
}

template <typename T>
void SceneTree::addFields(const std::string& path, std::function<T()> get,
                          std::function<void(const T&)> set) {
  T value{};
  forEachField(value, [&](const auto& f, auto&) {
    const std::string name{f.name};
    add(
        path + "/" + name, f.doc, [=] { return *getByPath(get(), name); },
        [=](const std::string& text) -> Result<void> {
          T changed = get();
          if (auto done = setByPath(changed, name, text); !done) return done;
          set(changed);
          return {};
        });
  });
}

void SceneTree::addRobot(std::size_t i, const std::string& name) {
  const std::string path = "robots/" + name;
  Simulation& s = simulation_;
  const auto body = [&s, i]() -> const RobotBody& { return s.world().robot(i); };
  addNumbers(
      path, "x y in mm, and the angle in deg; the robot is put on its feet there",
      [=] {
        const Pose2D& pose = body().pose;
        return textOf({pose.translation.x(), pose.translation.y(), toDegrees(pose.rotation)});
      },
      2, 3,
      [&s, i](const Numbers& n) {
        const double angle =
            n.size() > 2 ? normalize(fromDegrees(n[2])) : s.world().robot(i).pose.rotation;
        s.world().placeRobot(i, {angle, n[0], n[1]});
      });
  add(
      path + "/posture", "standing, onLeftSide or onRightSide: thrown over, and put back",
      [=] { return std::string{enumName(body().posture)}; },
      [&s, i](const std::string& text) -> Result<void> {
        const auto posture = enumOf<Posture>(text);
        if (!posture) return posture.error();
        s.world().throwOver(i, *posture);
        return {};
      });
  add(path + "/height", "mm: the body's origin above the ground",
      [=] { return textOf({body().height}); });
  add(path + "/tilt", "deg, nose up", [=] { return textOf({toDegrees(body().tilt)}); });
  add(path + "/roll", "deg, right side down", [=] { return textOf({toDegrees(body().roll)}); });
  add(path + "/executed", "whether the last command met no obstacle",
      [=] { return textOf(!body().blocked); });
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    addNumbers(
        path + "/joints/" + std::string{enumNames<Joint>[j]},
        "deg; put there by hand, until the robot moves it",
        [=] { return textOf({toDegrees(body().joints.values[j])}); }, 1, 1,
        [&s, i, j](const Numbers& n) {
          s.world().turnJoint(i, static_cast<Joint>(j), fromDegrees(n[0]));
        });
  if (i < s.world().activeRobots()) addActiveRobot(i, path);
}

void SceneTree::addActiveRobot(std::size_t i, const std::string& path) {
  Simulation& s = simulation_;
  for (std::size_t k = 0; k < enumCount<Switch>; ++k) {
    const auto which = static_cast<Switch>(k);
    add(
        path + "/switches/" + std::string{enumName(which)}, "on: pressed by hand",
        [&s, i, which] { return textOf(s.sensors(i).isPressed(which)); },
        [&s, i, which](const std::string& text) -> Result<void> {
          const auto on = boolOf(text);
          if (!on) return on.error();
          s.sensors(i).press(which, *on);
          return {};
        });
  }
  add(path + "/sensors/psd", "mm: as the robot measures it",
      [&s, i] { return textOf({s.input(i).sensors.newest().psd}); });
  add(path + "/sensors/acceleration", "mm/s^2: as the robot measures it", [&s, i] {
    const Vector3d& a = s.input(i).sensors.newest().acceleration;
    return textOf({a.x(), a.y(), a.z()});
  });
  add(
      path + "/radio", "off: the robot is cut off from its team mates",
      [&s, i] { return textOf(!s.radio().isCut(i)); },
      [&s, i](const std::string& text) -> Result<void> {
        const auto on = boolOf(text);
        if (!on) return on.error();
        s.radio().cut(i, !*on);
        return {};
      });
  add(
      path + "/penalty", "that the referee takes it off the field for; none: it comes back",
      [&s, i] { return std::string{enumName(s.referee().penalty(i))}; },
      [&s, i](const std::string& text) -> Result<void> {
        const auto penalty = enumOf<Penalty>(text);
        if (!penalty) return penalty.error();
        s.referee().penalize(s.world(), i, *penalty);
        return {};
      });
  addFields<CameraEffects>(
      path + "/camera", [&s, i] { return s.camera(i); },
      [&s, i](const CameraEffects& effects) { s.setCamera(i, effects); });
}

void SceneTree::addBall(std::size_t i) {
  Simulation& s = simulation_;
  addNumbers(
      "balls/" + std::to_string(i), "x y in mm, and the speed in mm/s; it rests if none is given",
      [&s, i] {
        const BallState& ball = s.world().ball(i);
        return textOf({ball.position.x(), ball.position.y(), ball.speed.x(), ball.speed.y()});
      },
      2, 4,
      [&s, i](const Numbers& n) {
        s.world().placeBall(i, {n[0], n[1]}, {n.size() > 2 ? n[2] : 0, n.size() > 3 ? n[3] : 0});
      });
}

void SceneTree::addActuators() {
  for (const Actuators::Actuator& actuator : simulation_.actuators().all()) {
    const std::string name = actuator.name, path = "actuators/" + name;
    Simulation& s = simulation_;
    const std::size_t directions = actuator.directions();
    addNumbers(
        path, "the command: -1 to 1 for each direction",
        [&s, name, directions] {
          const auto& command = s.actuators().find(name)->command;
          std::string text;
          for (std::size_t k = 0; k < directions; ++k)
            text += (k > 0 ? " " : "") + textOf({command[k]});
          return text;
        },
        directions, directions,
        [&s, name](const Numbers& n) {
          auto& command = s.actuators().find(name)->command;
          for (std::size_t k = 0; k < n.size(); ++k) command[k] = std::clamp(n[k], -1., 1.);
        });
    add(path + "/kind", "rotational, translational, space or vehicle",
        [kind = actuator.kind] { return std::string{enumName(kind)}; });
    add(path + "/executed", "whether the last command met no obstacle",
        [&s, name] { return textOf(s.actuators().find(name)->executed); });
    const int joint = actuator.joint;
    add(path + "/position", "x y z in mm", [&s, joint] {
      const int body = s.world().model().jnt_bodyid[joint];  // each fidelity has its own
      const Vector3d p = fromMuJoCo(s.world().data().xpos + 3 * body);
      return textOf({p.x(), p.y(), p.z()});
    });
    if (actuator.kind == ActuatorKind::rotational || actuator.kind == ActuatorKind::translational) {
      const double unit = actuator.kind == ActuatorKind::rotational ? toDegrees(1) : 1000;
      addNumbers(
          path + "/where", "deg or mm; put there by hand",
          [&s, joint, unit] {
            return textOf({unit * s.world().data().qpos[s.world().model().jnt_qposadr[joint]]});
          },
          1, 1,
          [&s, joint, unit](const Numbers& n) {
            const double at = n[0] / unit;
            s.world().moveJoint(joint, {&at, 1});
          });
    }
  }
}

void SceneTree::addFieldSensors() {
  auto& sensors = simulation_.fieldSensors().all();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    auto* sensor = &sensors[i];
    add("sensors/" + sensor->name, "what it measured last", [sensor] {
      std::string text;
      for (const double value : sensor->value) text += (text.empty() ? "" : " ") + textOf({value});
      return text;
    });
    addNumbers(
        "sensors/" + sensor->name + "/noise", "standard deviation of what it measures",
        [sensor] { return textOf({sensor->noise}); }, 1, 1,
        [sensor](const Numbers& n) { sensor->noise = std::abs(n[0]); });
  }
}

void SceneTree::addEmitters() {
  Simulation& s = simulation_;
  const mjModel& model = s.world().model();
  addNumbers(
      "emitters/ambient", "the intensity that reaches all: red, green, blue",
      [&s] {
        const auto& ambient = s.world().model().vis.headlight.ambient;
        return textOf({ambient[0], ambient[1], ambient[2]});
      },
      3, 3,
      [&s](const Numbers& n) {
        s.world().setAmbient({n[0], n[1], n[2]});
      });
  for (int light = 0; light < model.nlight; ++light) {
    std::string name = nameOf(model, mjOBJ_LIGHT, light);
    if (name.empty()) name = std::to_string(light);
    addNumbers(
        "emitters/" + name, "how strongly it shines: 0 to 1",
        [&s, light] { return textOf({s.world().emission(light)}); }, 1, 1,
        [&s, light](const Numbers& n) { s.world().emit(light, n[0]); });
  }
}

void SceneTree::addField() {
  Simulation& s = simulation_;
  const mjModel& model = s.world().model();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const std::string name = nameOf(model, mjOBJ_GEOM, geom);
    if (name.empty() || model.body_weldid[model.geom_bodyid[geom]] != 0) continue;
    addNumbers(
        "field/" + name, "x y z in mm of its middle",
        [&s, geom] {
          const Vector3d p = fromMuJoCo(s.world().data().geom_xpos + 3 * geom);
          return textOf({p.x(), p.y(), p.z()});
        },
        3, 3,
        [&s, geom](const Numbers& n) {
          s.world().moveGeom(geom, {n[0], n[1], n[2]});
        });
  }
}

void SceneTree::addGame() {
  Simulation& s = simulation_;
  Referee& referee = s.referee();
  addFields<GameParameters>(
      "game", [&referee] { return referee.parameters(); },
      [&referee](const GameParameters& p) { referee.change(p); });
  addFields<RuleParameters>(
      "rules", [&referee] { return referee.rules(); },
      [&referee](const RuleParameters& p) { referee.change(p); });
  addFields<RadioParameters>(
      "radio", [&s] { return s.radio().parameters(); },
      [&s](const RadioParameters& p) { s.radio().change(p); });
  addFields<NoiseParameters>(
      "noise", [&s] { return s.scene().noise; },
      [&s](const NoiseParameters& p) { s.changeNoise(p); });
  add(
      "game/state", "initial, ready, set, playing or finished",
      [&referee] { return std::string{enumName(referee.state())}; },
      [&s](const std::string& text) -> Result<void> {
        const auto state = enumOf<GameState>(text);
        if (!state) return state.error();
        s.referee().changeState(*state, s.time());
        return {};
      });
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    addNumbers(
        "game/score/" + std::string{enumName(team)}, "goals",
        [&referee, team] { return std::to_string(referee.score(team)); }, 1, 1,
        [&s, team](const Numbers& n) {
          s.referee().setScore(team, static_cast<int>(std::abs(n[0])), s.time());
        });
  add(
      "fidelity", "kinematic or dynamic",
      [&s] { return std::string{enumName(s.scene().fidelity)}; },
      [&s](const std::string& text) -> Result<void> {
        const auto fidelity = enumOf<Fidelity>(text);
        if (!fidelity) return fidelity.error();
        return s.changeFidelity(*fidelity);
      });
}

}  // namespace gt
