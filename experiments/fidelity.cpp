// Walks by the same commands in the kinematic and in the dynamic fidelity: how far one is from the
// other.
#include <algorithm>
#include <array>
#include <cmath>

#include "Experiments.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "simulation/world/World.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr int seconds = 60, warmUpSeconds = 2;
constexpr int ticksPerSecond = 1000 / static_cast<int>(tickMs);

struct Walk {
  const char* name;
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
  Pose2D speed;                          ///< rad/s, mm/s in the robot's own axes
  double height = 0;                     ///< mm, of the body
  double pitch = 0, pitchDeviation = 0;  ///< rad, of the camera, + up
  bool fell = false;
};

Result<Way> walk(const Pose2D& request, Fidelity fidelity) {
  auto scene = loadScene("scenes/match.scene");
  if (!scene) return scene.error();
  scene->fidelity = fidelity;
  scene->noise = {0, 0, 0, 0, 0};
  scene->robots.resize(1);
  scene->balls.clear();
  auto world = makeWorld(*scene, Random{1});
  if (!world) return world.error();
  InvKinWalkingEngine engine;
  if (auto read = readConfig("config/modules/WalkingEngine.InvKin.cfg", engine.parameters); !read)
    return read.error();

  Way way;
  MotionRequest motion;
  WalkingEngineOutput output;
  double height = 0, pitch = 0, pitchSquares = 0;
  Pose2D sum;
  for (int i = 0; i < (warmUpSeconds + seconds) * ticksPerSecond; ++i) {
    if (i == ticksPerSecond) {
      motion.type = MotionType::walk;
      motion.walk = request;
    }
    engine.update({}, motion, {}, {MotionInfo{}}, output);
    const RobotCommand command{
        output.joints.angles,
        {output.speed.rotation * tickSeconds, output.speed.translation * tickSeconds}};
    const RobotBody& robot = (*world)->robot(0);
    // The middle of the field again, before a wall is in the way.
    const bool far = robot.pose.translation.cwiseAbs().maxCoeff() > 700;
    if (far || i == 0) (*world)->placeRobot(0, {});
    const Pose2D before = far ? Pose2D{} : robot.pose;
    (*world)->step({&command, 1});
    if (i < warmUpSeconds * ticksPerSecond) continue;
    const Pose2D step = robot.pose.relativeTo(before);
    sum.rotation += step.rotation;
    sum.translation += step.translation;
    height += robot.height;
    const double tilt = std::asin(std::clamp((*world)->camera(0).rotation(2, 0), -1., 1.));
    pitch += tilt;
    pitchSquares += tilt * tilt;
    way.fell |= robot.posture != Posture::standing;
  }
  constexpr double ticks = seconds * ticksPerSecond;
  way.speed = {sum.rotation / seconds, sum.translation / seconds};
  way.height = height / ticks;
  way.pitch = pitch / ticks;
  way.pitchDeviation = std::sqrt(std::max(0., pitchSquares / ticks - way.pitch * way.pitch));
  return way;
}

void print(const char* name, const char* fidelity, const Way& way) {
  fmt::print("{:<12} {:<10} {:>7.1f} {:>7.1f} {:>7.2f} {:>8.1f} {:>7.2f} {:>7.2f}  {}\n", name,
             fidelity, way.speed.translation.x(), way.speed.translation.y(), way.speed.rotation,
             way.height, toDegrees(way.pitch), toDegrees(way.pitchDeviation),
             way.fell ? "fell" : "");
}

}  // namespace

Result<void> measureFidelity(Figures& figures, const ExperimentOptions&) {
  fmt::print("{:<12} {:<10} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7}\n", "walk", "fidelity", "x mm/s",
             "y mm/s", "rad/s", "height", "pitch", "+-deg");
  for (const Walk& w : walks) {
    const auto kinematic = walk(w.request, Fidelity::kinematic);
    if (!kinematic) return kinematic.error();
    const auto dynamic = walk(w.request, Fidelity::dynamic);
    if (!dynamic) return dynamic.error();
    print(w.name, "kinematic", *kinematic);
    print("", "dynamic", *dynamic);
    const std::string name = std::string{"fidelity."} + w.name;
    const Vector2d& wanted = kinematic->speed.translation;
    if (const double speed = wanted.norm(); speed > 1)
      figures.add(name + ".speed", "%",
                  {100 * dynamic->speed.translation.dot(wanted) / speed / speed}, Aim::atLeast(50));
    if (w.request.rotation != 0)
      figures.add(name + ".turn", "%", {100 * dynamic->speed.rotation / kinematic->speed.rotation},
                  Aim::atLeast(50));
    else
      figures.add(name + ".drift", "deg/s", {toDegrees(dynamic->speed.rotation)});
    figures.add(name + ".height", "mm", {dynamic->height - kinematic->height});
    figures.add(name + ".pitch", "deg", {toDegrees(dynamic->pitch - kinematic->pitch)});
  }
  return {};
}

}  // namespace gt
