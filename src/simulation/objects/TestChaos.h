#pragma once
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "representations/infrastructure/RobotDimensions.h"
#include "simulation/Simulation.h"
#include "simulation/objects/SceneTree.h"

namespace gt {

/// A robot's program that returns random output: any joint angles, any steps, values that are no
/// numbers, garbage by radio. It throws at `throwsAt`.
class MadController : public RobotController {
 public:
  MadController(const Random& random, Time throwsAt) : random_{random}, throwsAt_{throwsAt} {}

  void cycle(const RobotInput& input, RobotOutput& output) override {
    if (input.now >= throwsAt_) throw std::runtime_error("gone mad");
    if (random_.chance(0.03)) {
      for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
        const JointLimits limits = limitsOf(static_cast<Joint>(j));
        output.joints.angles.values[j] = random_.uniform(2 * limits.low, 2 * limits.high);
      }
      if (random_.chance(0.1)) output.joints.angles.values[random_.index(12)] = std::nan("");
      step_ = {random_.symmetric() * 0.05, random_.symmetric() * 5, random_.symmetric() * 5};
    }
    output.odometry.pose = output.odometry.pose * step_;
    if (random_.chance(0.001)) output.odometry.pose.translation.x() = std::nan("");
    if (!std::isfinite(output.odometry.pose.translation.x()) && random_.chance(0.1))
      output.odometry.pose = {};
    if (random_.chance(0.1)) {
      output.message.emplace();
      output.message->timeSent = Time{static_cast<std::int64_t>(random_())};
    }
  }

 private:
  Random random_;
  Time throwsAt_;
  Pose2D step_;
};

/// Random interventions in a scene: robots are thrown and put anywhere, balls kicked, robots
/// penalized, all objects set to anything.
class Chaos {
 public:
  Chaos(Simulation& simulation, std::uint64_t seed)
      : simulation_{simulation}, tree_{simulation}, objects_{tree_.list("")}, random_{seed} {
    std::erase_if(objects_, [](const SceneTree::Object& object) {
      // What would end the game, or rebuild the world all the time.
      return object.path == "game/state" || object.path == "game/minutes" ||
             object.path == "fidelity";
    });
    for (std::size_t i = 0; i < simulation.world().activeRobots(); ++i)
      simulation.attach(i, std::make_unique<MadController>(
                               random_.fork(std::to_string(i)),
                               i % 7 == 6 ? Time{20'000} : Time{std::int64_t{1} << 60}));
  }

  /// One tick, and sometimes something done to the scene.
  void step() {
    if (random_.chance(0.02)) {
      const std::size_t robot = random_.index(simulation_.world().robotCount());
      simulation_.world().throwOver(robot, static_cast<Posture>(random_.index(enumCount<Posture>)));
    }
    if (random_.chance(0.02))
      simulation_.world().placeRobot(
          random_.index(simulation_.world().robotCount()),
          {random_.symmetric() * 4, random_.symmetric() * 3000, random_.symmetric() * 2000});
    if (random_.chance(0.1) && simulation_.world().ballCount() > 0)
      simulation_.world().placeBall(random_.index(simulation_.world().ballCount()),
                                    {random_.symmetric() * 2000, random_.symmetric() * 1200},
                                    {random_.symmetric() * 5000, random_.symmetric() * 5000});
    if (random_.chance(0.3)) setAnything();
    simulation_.step();
  }

  /// Describes the first invalid state in the world; empty if there is none.
  std::string wrong() const {
    const World& world = simulation_.world();
    for (std::size_t i = 0; i < world.robotCount(); ++i) {
      const RobotBody& robot = world.robot(i);
      if (!robot.pose.translation.allFinite() || !std::isfinite(robot.pose.rotation) ||
          !std::isfinite(robot.height) || !robot.specificForce.allFinite() ||
          !(robot.pose.translation.norm() < 1e5))
        return "robot " + std::to_string(i) + " is nowhere";
      for (const double angle : robot.joints.values)
        if (!std::isfinite(angle)) return "a joint of robot " + std::to_string(i) + " is no number";
    }
    for (std::size_t i = 0; i < world.ballCount(); ++i)
      if (!world.ball(i).position.allFinite() || !world.ball(i).speed.allFinite())
        return "ball " + std::to_string(i) + " is nowhere";
    for (int i = 0; i < world.model().nq; ++i)
      if (!std::isfinite(world.data().qpos[i])) return "a coordinate is no number";
    return "";
  }

 private:
  void setAnything() {
    const std::string& path = objects_[random_.index(objects_.size())].path;
    std::string value;
    switch (random_.index(4)) {
      case 0:
        for (std::uint64_t n = 1 + random_.index(6); n > 0; --n)
          value += std::to_string(random_.symmetric() * std::pow(10, random_.uniform(-3, 4))) + ' ';
        value.pop_back();
        break;
      case 1:
        for (std::uint64_t n = random_.index(12); n > 0; --n)
          value += static_cast<char>(random_.index(256));
        break;
      case 2:
        value = random_.chance(0.5) ? "true" : "false";
        break;
      default:
        // What it is just now, moved by nothing.
        if (const auto now = tree_.get(path)) value = *now;
    }
    static_cast<void>(tree_.set(path, value));
  }

  Simulation& simulation_;
  SceneTree tree_;
  std::vector<SceneTree::Object> objects_;
  Random random_;
};

/// The match scene with a number of robots, which all have programs, and a number of balls.
inline Result<SceneDescription> crowdedScene(std::size_t robots, std::size_t balls,
                                             const std::string& file = "scenes/match.scene") {
  auto scene = loadScene(file);
  if (!scene) return scene;
  const std::vector<SceneRobot> team = scene->robots;
  scene->robots.clear();
  for (std::size_t i = 0; i < robots; ++i) {
    SceneRobot robot = team[i % team.size()];
    robot.name = "robot" + std::to_string(i);
    robot.x = -1800 + 700. * static_cast<double>(i % 6);
    robot.y = -900 + 550. * static_cast<double>(i / 6);
    scene->robots.push_back(robot);
  }
  const SceneBall ball = scene->balls.front();
  scene->balls.assign(balls, ball);
  for (std::size_t i = 0; i < balls; ++i) {
    scene->balls[i].x = -1500 + 330. * static_cast<double>(i);
    scene->balls[i].y = -600;
  }
  scene->game.penalties = true;
  return scene;
}

}  // namespace gt
