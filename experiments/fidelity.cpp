// Walks by the same commands in the kinematic and in the dynamic fidelity: how far one is from the
// other.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "Experiments.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "simulation/scene/ProfileTable.h"
#include "simulation/world/World.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr int seconds = 60, warmUpSeconds = 2;
constexpr int oneSecond = 1000 / static_cast<int>(tickMs);  // in ticks

struct Walk {
  std::string_view name;
  Pose2D request;  // rad/s, mm/s
};

const std::array<Walk, 10> walks{{{"forward100", {0, 100, 0}},
                                  {"forward200", {0, 200, 0}},
                                  {"backward100", {0, -100, 0}},
                                  {"left80", {0, 0, 80}},
                                  {"right80", {0, 0, -80}},
                                  {"turnLeft", {1, 0, 0}},
                                  {"turnRight", {-1, 0, 0}},
                                  {"diagonal", {0, 80, 60}},
                                  {"curveLeft", {0.5, 120, 0}},
                                  {"curveRight", {-0.5, 120, 0}}}};

/// What a walk was like.
struct Way {
  Pose2D speed;                                  ///< rad/s, mm/s in the robot's own axes
  double height = 0;                             ///< mm, of the body
  double pitch = 0, pitchStandardDeviation = 0;  ///< rad, of the camera, + up
  bool fell = false;
};

Result<Way> walk(const DataRoot& root, const Pose2D& request, Fidelity fidelity) {
  auto scene = loadScene(root.path("scenes/match.scene"));
  if (!scene) return scene.error();
  scene->fidelity = fidelity;
  setProfile(*scene, Profile::perfect);
  scene->robots.resize(1);
  scene->balls.clear();
  auto world = makeWorld(*scene, Random{1});
  if (!world) return world.error();
  InvKinWalkingEngine engine;
  if (auto read =
          readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), engine.parameters);
      !read)
    return read.error();

  Way way;
  MotionRequest motion;
  WalkingEngineOutput output;
  double height = 0, pitch = 0, pitchSquares = 0;
  Pose2D sum;
  for (int i = 0; i < (warmUpSeconds + seconds) * oneSecond; ++i) {
    if (i == oneSecond) {
      motion.type = MotionType::walk;
      motion.walk = request;
    }
    engine.update({}, motion, {}, {}, {MotionInfo{}}, output);
    const RobotCommand command{
        output.joints.angles,
        {output.speed.rotation * tickSeconds, output.speed.translation * tickSeconds}};
    const RobotBody& robot = (*world)->robot(0);
    // The middle of the field again, before a wall is in the way.
    const bool far = robot.pose.translation.cwiseAbs().maxCoeff() > 700;
    if (far || i == 0) (*world)->placeRobot(0, {});
    const Pose2D before = far ? Pose2D{} : robot.pose;
    (*world)->step({&command, 1});
    if (i < warmUpSeconds * oneSecond) continue;
    const Pose2D step = robot.pose.relativeTo(before);
    sum.rotation += step.rotation;
    sum.translation += step.translation;
    height += robot.height;
    const double tilt = std::asin(std::clamp((*world)->camera(0).rotation(2, 0), -1., 1.));
    pitch += tilt;
    pitchSquares += tilt * tilt;
    way.fell |= robot.posture != Posture::standing;
  }
  constexpr double ticks = seconds * oneSecond;
  way.speed = {sum.rotation / seconds, sum.translation / seconds};
  way.height = height / ticks;
  way.pitch = pitch / ticks;
  way.pitchStandardDeviation =
      std::sqrt(std::max(0., pitchSquares / ticks - way.pitch * way.pitch));
  return way;
}

void add(Measurement& measured, const std::string& name, const Way& way) {
  measured.add(name + ".x", "mm/s", way.speed.translation.x());
  measured.add(name + ".y", "mm/s", way.speed.translation.y());
  measured.add(name + ".rotation", "rad/s", way.speed.rotation);
  measured.add(name + ".bodyHeight", "mm", way.height);
  measured.add(name + ".cameraPitch", "deg", toDegrees(way.pitch));
  measured.add(name + ".cameraPitch.deviation", "deg", toDegrees(way.pitchStandardDeviation));
  measured.add(name + ".fell", "", way.fell);
}

Result<Measurement> compare(const Job& job, const DataRoot& root) {
  const Walk& w = *std::ranges::find(walks, job.parameter("walk"), &Walk::name);
  const auto kinematic = walk(root, w.request, Fidelity::kinematic);
  if (!kinematic) return kinematic.error();
  const auto dynamic = walk(root, w.request, Fidelity::dynamic);
  if (!dynamic) return dynamic.error();
  Measurement measured;
  const std::string name = "fidelity." + std::string{w.name};
  add(measured, name + ".kinematic", *kinematic);
  add(measured, name + ".dynamic", *dynamic);
  const Vector2d& wanted = kinematic->speed.translation;
  if (const double speed = wanted.norm(); speed > 1)
    measured.add(name + ".speed", "%", 100 * dynamic->speed.translation.dot(wanted) / speed / speed,
                 Aim::atLeast(50));
  if (w.request.rotation != 0)
    measured.add(name + ".turn", "%", 100 * dynamic->speed.rotation / kinematic->speed.rotation,
                 Aim::atLeast(50));
  else
    measured.add(name + ".drift", "deg/s", toDegrees(dynamic->speed.rotation));
  measured.add(name + ".height", "mm", dynamic->height - kinematic->height);
  measured.add(name + ".pitch", "deg", toDegrees(dynamic->pitch - kinematic->pitch));
  return measured;
}

}  // namespace

Experiment fidelityExperiment() {
  Parameter which{"walk", "what the robot is told to do", Parameter::Kind::each, {}};
  for (const Walk& w : walks) which.values.emplace_back(w.name);
  return {"fidelity",
          "The same walks in the kinematic and in the dynamic fidelity",
          {which},
          compare,
          true};
}

}  // namespace gt
