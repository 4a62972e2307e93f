// What the kicks do in both fidelities: how far and where the ball goes, and what happens to the
// robot.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "base/Statistics.h"
#include "measure/worlds/MovedRobot.h"
#include "modules/motion/specialactions/MotionNetLoader.h"

namespace gt {
namespace {

/// What one kick did.
struct Kicked {
  Vector2d way = Vector2d::Zero();  ///< mm, of the ball, in the robot's system before the kick
  double seconds = 0;               ///< from the request until the robot stands
  Pose2D moved;                     ///< of the robot
  bool fell = false;
};

/// A robot in the middle of the field faces anywhere. When it stands again, the ball rolls, and no
/// wall has stopped it yet: from there its way is calculated.
Kicked kick(MovedRobot& robot, const std::string& name, const Vector2d& place, double heading) {
  const Pose2D start{heading, 0, 0};
  robot.request = {};
  robot.world().placeBall(0, {1900, 1200});
  robot.world().placeRobot(0, start);
  robot.run(0.6);
  const Pose2D from = robot.body().pose;
  robot.world().placeBall(0, from * place);
  Kicked kicked;
  robot.request.type = MotionType::specialAction;
  robot.request.specialAction = name;
  const auto step = [&] {
    robot.step();
    kicked.seconds += tickSeconds;
    kicked.fell |= robot.hasFallen();
  };
  constexpr double longest = 5;  // s
  while (robot.motion().executed.specialAction != name && kicked.seconds < longest) step();
  robot.request = {};
  while (robot.motion().executed.type == MotionType::specialAction && kicked.seconds < longest)
    step();
  kicked.moved = robot.body().pose.relativeTo(from);
  const BallState& ball = robot.world().ball(0);
  const double slowing = robot.simulation().scene().physics.deceleration;
  const Vector2d rolls = ball.speed * ball.speed.norm() / (2 * slowing);
  kicked.way = relative(from, Vector2d{ball.position + rolls}) - place;
  return kicked;
}

/// A ball somewhere where a kick reaches it.
Vector2d somewhere(const KickDescription& kick, Random& random) {
  const KickDescription::Reach& reach = kick.reach[random.index(kick.reach.size())];
  return {random.uniform(reach.nearest, reach.farthest),
          random.uniform(reach.rightmost, reach.leftmost)};
}

void measure(MovedRobot& robot, const MotionNet::Motion& motion, int balls, Random& random,
             Measurement& measurement) {
  std::vector<double> lengths, astray, seconds;
  int falls = 0, missed = 0;
  double moved = 0, turned = 0, ahead = 0;
  for (int i = 0; i < balls; ++i) {
    const Vector2d place = somewhere(motion.kick, random);
    const Kicked kicked = kick(robot, motion.name, place, pi * random.symmetric());
    const double length = kicked.way.norm();
    constexpr double touched = 50;  // mm
    lengths.push_back(length);
    seconds.push_back(kicked.seconds);
    falls += kicked.fell;
    ahead += kicked.way.dot(direction(fromDegrees(motion.kick.direction))) / balls;
    moved += kicked.moved.translation.norm() / balls;
    turned += toDegrees(kicked.moved.rotation) / balls;
    if (length > touched)
      astray.push_back(
          toDegrees(normalize(angleOf(kicked.way) - fromDegrees(motion.kick.direction))));
    else
      ++missed;
  }
  const std::string name = "motion.kick." + motion.name;
  const auto share = [&](int count) { return 100. * count / balls; };
  measurement.add(name + ".length", "mm", mean(lengths));
  measurement.add(name + ".ahead", "mm", ahead);
  measurement.add(name + ".missed", "%", share(missed), Aim::atMost(5));
  measurement.add(name + ".falls", "%", share(falls), Aim::atMost(2));
  measurement.add(name + ".seconds", "s", mean(seconds));
  measurement.add(name + ".robot.moved", "mm", moved);
  measurement.add(name + ".robot.turned", "deg", turned);
  if (astray.empty()) return;
  // From the direction that the kick shall have: how one robot differs from another counts, too.
  const double squares = std::inner_product(astray.begin(), astray.end(), astray.begin(), 0.);
  measurement.add(name + ".astray", "deg", mean(astray));
  measurement.add(name + ".spread", "deg", std::sqrt(squares / static_cast<double>(astray.size())),
                  Aim::atMost(10));
}

Result<Measurement> kickAll(const Job& job, const DataRoot& root) {
  auto scene = dynamicScene(job, root);
  if (!scene) return scene.error();
  scene->balls.resize(1);
  const std::string folder =
      job.parameter("motions") == "configured" ? root.path("motions") : job.parameter("motions");
  const auto net = loadMotionNet(folder);
  if (!net) return net.error();
  auto robot = MovedRobot::make(root, *scene, job.seed, folder);
  if (!robot) return robot.error();
  (*robot)->standUp();
  Measurement measurement;
  const std::string& only = job.parameter("kick");
  for (const MotionNet::Motion& motion : net->motions) {
    Random random = Random{job.seed}.fork(motion.name);
    if (motion.isKick() && (only == "all" || only == motion.name))
      measure(**robot, motion, static_cast<int>(job.number("balls")), random, measurement);
  }
  if (measurement.values.empty()) return Error{.field = only, .what = "is no kick"};
  return measurement;
}

}  // namespace

Experiment kickExperiment() {
  return {"motion.kick",
          "Where the ball goes that lies anywhere where a kick reaches it",
          {profileParameter(),
           changeParameter(),
           fidelityParameter(),
           varietyParameter(),
           {"kick", "one of them, or all", Parameter::Kind::text, {"all"}},
           {"motions", "folder of motion descriptions", Parameter::Kind::text, {"configured"}},
           {"balls", "that each of them kicks", Parameter::Kind::number, {"5"}},
           valuesParameter()},
          withValues<kickAll>};
}

}  // namespace gt
