#include "simulation/objects/SceneTree.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

#include "base/Enum.h"
#include "base/Number.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr double farthestPlace = 1e5;  // mm: nothing is put further away

std::string textOf(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ' ';
    text += numberText(std::round(number * 1000) / 1000 + 0.0);
  }
  return text;
}
std::string textOf(std::initializer_list<double> numbers) {
  return textOf(std::span{numbers.begin(), numbers.size()});
}
std::string textOf(const Vector3d& v) {
  return textOf({v.x(), v.y(), v.z()});
}

Result<std::vector<double>> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  std::string blanks = text;
  std::ranges::replace(blanks, ',', ' ');
  std::istringstream words{blanks};
  for (std::string word; words >> word;) {
    double number = 0;
    if (!setScalar(valueOf(number), word, {-farthestPlace, farthestPlace}))
      return Error{.what = "expected numbers up to " + textOf({farthestPlace}) + ", found \"" +
                           text + "\""};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

SceneTree::SceneTree(Simulation& simulation) : simulation_(simulation) {
  std::size_t i = 0;
  for (const SceneRobot* robot : simulation_.scene().allRobots()) addRobot(i++, robot->name);
  for (std::size_t ball = 0; ball < simulation_.world().ballCount(); ++ball) addBall(ball);
  addActuators();
  addFieldSensors();
  addCeilingCamera();
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
  if (node == nodes_.end()) return Error{.field = path, .what = "there is no such object"};
  return node->second.get();
}

Result<void> SceneTree::set(const std::string& path, const std::string& value) {
  const auto node = nodes_.find(path);
  if (node == nodes_.end()) return Error{.field = path, .what = "there is no such object"};
  if (!node->second.set) return Error{.field = path, .what = "can only be watched"};
  if (const auto done = node->second.set(value); !done)
    return Error{.field = path, .what = done.error().what};
  return {};
}

void SceneTree::add(std::string path, std::string_view help, std::function<std::string()> get,
                    std::function<Result<void>(const std::string&)> set) {
  nodes_.insert_or_assign(std::move(path), Node{help, std::move(get), std::move(set)});
}

void SceneTree::addNumbers(const std::string& path, std::string_view help,
                           std::function<std::string()> get, std::size_t least, std::size_t most,
                           std::function<void(const Numbers&)> set) {
  add(path, help, std::move(get),
      [=, set = std::move(set)](const std::string& text) -> Result<void> {
        const auto numbers = numbersOf(text);
        if (!numbers) return numbers.error();
        if (numbers->size() < least || numbers->size() > most)
          return Error{.what = "expected " + std::to_string(least) +
                               (most > least ? " to " + std::to_string(most) : "") +
                               " numbers, found " + std::to_string(numbers->size())};
        set(*numbers);
        return {};
      });
}

template <typename Get, typename Set>
void SceneTree::addValue(const std::string& path, std::string_view help, Get get, Set set) {
  using T = std::invoke_result_t<Get>;
  std::function<Result<void>(const std::string&)> setText;
  if constexpr (!std::is_null_pointer_v<Set>)
    setText = [set](const std::string& text) -> Result<void> {
      T value{};
      if (const auto done = setScalar(valueOf(value), text); !done)
        return Error{.what = done.error().what + ", found \"" + text + "\""};
      if constexpr (std::is_void_v<std::invoke_result_t<Set, T>>) {
        set(value);
        return {};
      } else {
        return set(value);
      }
    };
  add(
      path, help,
      [get] {
        const T value = get();
        return scalarText(valueOf(value));
      },
      std::move(setText));
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
  addValue(
      path + "/posture", "how it lies or stands: thrown over, and put back",
      [=] { return body().posture; },
      [&s, i](Posture posture) { s.world().throwOver(i, posture); });
  add(path + "/height", "mm: the body's origin above the ground",
      [=] { return textOf({body().height}); });
  add(path + "/tilt", "deg, nose up", [=] { return textOf({toDegrees(body().tilt)}); });
  add(path + "/roll", "deg, right side down", [=] { return textOf({toDegrees(body().roll)}); });
  addValue(path + "/executed", "whether the last command met no obstacle",
           [=] { return !body().blocked; });
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
    addValue(
        path + "/switches/" + std::string{enumName(which)}, "true: pressed by hand",
        [&s, i, which] { return s.sensors(i).isPressed(which); },
        [&s, i, which](bool on) { s.sensors(i).press(which, on); });
  }
  addNumbers(
      path + "/tailPush", "deg to the left: pushed by hand, against its servo",
      [&s, i] { return textOf({toDegrees(s.sensors(i).tailPush())}); }, 1, 1,
      [&s, i](const Numbers& n) { s.sensors(i).pushTail(fromDegrees(n[0])); });
  add(path + "/sensors/psd", "mm: as the robot measures it",
      [&s, i] { return textOf({s.input(i).sensors.newest().psd}); });
  add(path + "/sensors/acceleration", "mm/s^2: as the robot measures it",
      [&s, i] { return textOf(s.input(i).sensors.newest().acceleration); });
  addValue(
      path + "/radio", "false: the robot is cut off from its teammates",
      [&s, i] { return !s.radio().isCut(i); }, [&s, i](bool on) { s.radio().cut(i, !on); });
  addValue(
      path + "/penalty", "that the referee takes it off the field for; none: it comes back",
      [&s, i] { return s.referee().penalty(i); },
      [&s, i](Penalty penalty) { s.referee().penalize(s.world(), i, penalty); });
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
          return textOf(std::span{s.actuators().find(name)->command}.first(directions));
        },
        directions, directions,
        [&s, name](const Numbers& n) {
          auto& command = s.actuators().find(name)->command;
          for (std::size_t k = 0; k < n.size(); ++k) command[k] = std::clamp(n[k], -1., 1.);
        });
    addValue(path + "/kind", "rotational, translational, space or vehicle",
             [kind = actuator.kind] { return kind; });
    addValue(path + "/executed", "whether the last command met no obstacle",
             [&s, name] { return s.actuators().find(name)->executed; });
    const int joint = actuator.joint;
    add(path + "/position", "x y z in mm", [&s, joint] {
      const int body = s.world().model().jnt_bodyid[joint];  // each fidelity has its own
      return textOf(fromMuJoCo(s.world().data().xpos + 3 * body));
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
    add("sensors/" + sensor->name, describe(sensor->kind),
        [this, i] { return textOf(simulation_.readFieldSensor(i)); });
    addNumbers(
        "sensors/" + sensor->name + "/noise", "standard deviation of what it measures",
        [sensor] { return textOf({sensor->noise}); }, 1, 1,
        [sensor](const Numbers& n) { sensor->noise = std::abs(n[0]); });
  }
}

void SceneTree::addCeilingCamera() {
  const SceneDescription& scene = simulation_.scene();
  if (!scene.ceilingCamera) return;
  Simulation& s = simulation_;
  add("ceilingCamera/ball", "x y in mm as measured last; none if it was not seen", [&s] {
    const CeilingCameraPercept& percept = s.lastCeilingPercept();
    return percept.ballSeen ? textOf({percept.ball.x(), percept.ball.y()}) : "none";
  });
  std::size_t i = 0;
  for (const SceneRobot* robot : scene.allRobots())
    add("ceilingCamera/" + robot->name,
        "x y in mm and the angle in deg as measured last; none if it was not seen",
        [&s, player = s.players()[i++]]() -> std::string {
          for (const MarkedRobot& seen : s.lastCeilingPercept().robots)
            if (seen.teamColor == player.teamColor && seen.number == player.number())
              return textOf({seen.pose.translation.x(), seen.pose.translation.y(),
                             toDegrees(seen.pose.rotation)});
          return "none";
        });
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
        [&s, geom] { return textOf(fromMuJoCo(s.world().data().geom_xpos + 3 * geom)); }, 3, 3,
        [&s, geom](const Numbers& n) {
          s.world().moveGeom(geom, {n[0], n[1], n[2]});
        });
  }
}

template <typename T>
void SceneTree::addElement(const std::string& path, T SceneDescription::*element) {
  Simulation& s = simulation_;
  addFields<T>(
      path, [&s, element] { return s.scene().*element; },
      [&s, element](const T& parameters) {
        SceneDescription scene = s.scene();
        scene.*element = parameters;
        s.change(scene);
      });
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
  addElement("radio", &SceneDescription::radio);
  addElement("noise", &SceneDescription::noise);
  addElement("body", &SceneDescription::body);
  addElement("walking", &SceneDescription::walking);
  addElement("dynamics", &SceneDescription::dynamics);
  addElement("physics", &SceneDescription::physics);
  addValue(
      "profile",
      "perfect, benign, padova or rough: sets noise, body, walking, cameras, physics, radio",
      [&s] { return s.scene().profile; },
      [&s](Profile profile) {
        SceneDescription scene = s.scene();
        setProfile(scene, profile);
        s.change(scene);
      });
  addValue(
      "game/state", "initial, ready, set, playing or finished",
      [&referee] { return referee.state(); },
      [&s](GameState state) { s.referee().order(state, s.world()); });
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    addValue(
        "game/score/" + std::string{enumName(team)}, "goals",
        [&referee, team] { return static_cast<std::uint16_t>(referee.score(team)); },
        [&s, team](std::uint16_t goals) { s.referee().setScore(team, goals, s.time()); });
  addValue(
      "fidelity", "kinematic or dynamic", [&s] { return s.scene().fidelity; },
      [&s](Fidelity fidelity) { return s.changeFidelity(fidelity); });
}

}  // namespace gt
