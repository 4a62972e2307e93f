// Special actions that are no kicks: whether the robot stays on its feet, or gets up afterwards.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "measure/worlds/MovedRobot.h"

namespace gt {
namespace {

constexpr double longest = 12;  // s: of an action

/// What became of a robot that performed an action.
struct Shown {
  bool stands = false;    ///< It stands half a second later.
  bool up = false;        ///< It stands afterwards, by its getup engine if it has to.
  double seconds = 0;     ///< of the action
  double recovering = 0;  ///< s, from then on until it stands
  Pose2D moved;
  double farthest = 0;  ///< rad: how far the body leaned at most
  double held = 0;      ///< rad: how far it leaned when the request ended
  double rolled = 0;    ///< rad, about its long axis, + to the right
};

/// How far the body's back is from pointing up.
double lean(const RobotBody& body) {
  return std::acos(std::cos(body.tilt) * std::cos(body.roll));
}

/// Upright and at rest on its feet.
bool stands(const RobotBody& body) {
  constexpr double standHeight = 90, level = fromDegrees(20);  // mm, rad
  return body.posture == Posture::standing && body.height > standHeight &&
         std::abs(body.tilt) < level && std::abs(body.roll) < level;
}

Shown show(MovedRobot& robot, const std::string& name, double holds, Random& random) {
  robot.request = {};
  robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
  robot.run(0.6);
  const Pose2D from = robot.body().pose;
  Shown shown;
  const auto step = [&](double& clock) {
    const RobotBody before = robot.body();
    robot.step();
    clock += tickSeconds;
    shown.farthest = std::max(shown.farthest, lean(robot.body()));
    constexpr double steep = fromDegrees(60);  // from there on, there is hardly a roll
    if (std::abs(before.tilt) < steep) shown.rolled += normalize(robot.body().roll - before.roll);
  };
  const auto performs = [&] { return robot.motion().executed.specialAction == name; };
  robot.request.type = MotionType::specialAction;
  robot.request.specialAction = name;
  while (!performs() && shown.seconds < longest) step(shown.seconds);
  // What holds a posture ends when something else is requested.
  for (const double until = shown.seconds + holds; shown.seconds < until;) step(shown.seconds);
  shown.held = lean(robot.body());
  robot.request = {};
  while (robot.motion().executed.type == MotionType::specialAction && shown.seconds < longest)
    step(shown.seconds);
  double calm = 0;
  for (int i = 0; i < 60; ++i) step(calm);
  shown.stands = stands(robot.body());
  shown.moved = robot.body().pose.relativeTo(from);
  if (!shown.stands) robot.request.type = MotionType::getup;
  constexpr double rests = 0.3, allowed = 4;  // s
  double upright = 0;
  while (upright < rests && shown.recovering < allowed + rests) {
    step(shown.recovering);
    upright = stands(robot.body()) ? upright + tickSeconds : 0;
  }
  shown.up = upright >= rests;
  shown.recovering -= upright;
  return shown;
}

/// The motions of the folder shows/.
std::vector<std::string> showsIn(const DataRoot& root) {
  std::vector<std::string> names;
  std::error_code failed;  // then there are none
  for (const auto& entry : std::filesystem::directory_iterator{root.path("motions/shows"), failed})
    if (entry.path().extension() == ".mof") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

Result<Measurement> showAll(const Job& job, const DataRoot& root) {
  const auto scene = dynamicScene(job, root);
  if (!scene) return scene.error();
  auto robot = MovedRobot::make(root, *scene, job.seed);
  if (!robot) return robot.error();
  (*robot)->standUp();
  Measurement measurement;
  const std::string& only = job.parameter("show");
  const int times = static_cast<int>(job.number("times"));
  for (const std::string& name : showsIn(root)) {
    if (only != "all" && only != name) continue;
    Random random = Random{job.seed}.fork(name);
    int standing = 0, up = 0;
    double seconds = 0, recovering = 0, turned = 0, moved = 0;
    double farthest = 0, held = 0, rolled = 0, ahead = 0, left = 0;
    for (int i = 0; i < times; ++i) {
      const Shown shown = show(**robot, name, job.number("holds"), random);
      standing += shown.stands;
      up += shown.up;
      seconds += shown.seconds / times;
      recovering += shown.recovering / times;
      turned += toDegrees(shown.moved.rotation) / times;
      moved += shown.moved.translation.norm() / times;
      ahead += shown.moved.translation.x() / times;
      left += shown.moved.translation.y() / times;
      farthest += toDegrees(shown.farthest) / times;
      held += toDegrees(shown.held) / times;
      rolled += toDegrees(shown.rolled) / times;
      if (!shown.up) (*robot)->world().standUp(0);
    }
    const std::string prefix = "motion.show." + name;
    measurement.add(prefix + ".stands", "%", 100. * standing / times, Aim::atLeast(98));
    measurement.add(prefix + ".up", "%", 100. * up / times, Aim::atLeast(99));
    measurement.add(prefix + ".seconds", "s", seconds);
    measurement.add(prefix + ".recovering", "s", recovering);
    measurement.add(prefix + ".turned", "deg", turned);
    measurement.add(prefix + ".moved", "mm", moved);
    measurement.add(prefix + ".ahead", "mm", ahead);
    measurement.add(prefix + ".left", "mm", left);
    measurement.add(prefix + ".lean", "deg", farthest);
    measurement.add(prefix + ".heldLean", "deg", held);
    measurement.add(prefix + ".rolled", "deg", rolled);
  }
  if (measurement.values.empty()) return Error{.field = only, .what = "is no show"};
  return measurement;
}

}  // namespace

Experiment showExperiment() {
  return {"motion.show",
          "Whether robots stand after each motion of the folder shows, or how soon they get up",
          {profileParameter(),
           changeParameter(),
           fidelityParameter(),
           varietyParameter(),
           {"show", "one of them, or all", Parameter::Kind::text, {"all"}},
           {"holds", "s for which it is requested", Parameter::Kind::number, {"2"}},
           {"times", "each robot performs it", Parameter::Kind::number, {"3"}},
           valuesParameter()},
          withValues<showAll>};
}

}  // namespace gt
