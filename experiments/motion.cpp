// How well robots move in the dynamic fidelity: whether they stand, walk and fall.
#include <algorithm>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "base/Statistics.h"
#include "match/Match.h"
#include "measure/worlds/MovedRobot.h"
#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/walking/WalkParameters.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// Counts how often robots lose their feet.
class Falls {
 public:
  explicit Falls(const World& world) : world_{world}, stands_(world.activeRobots(), true) {}

  void look() {
    for (std::size_t i = 0; i < stands_.size(); ++i) {
      const bool stands = world_.robot(i).posture == Posture::standing;
      count_ += stands_[i] && !stands;
      stands_[i] = stands;
    }
  }
  int count() const { return count_; }

 private:
  const World& world_;
  std::vector<bool> stands_;
  int count_ = 0;
};

Result<Measurement> stand(const Job& job, const DataRoot& root) {
  MatchOptions options{root};
  options.seed = job.seed;
  options.scene = root.path("scenes/" + job.parameter("scene") + ".scene");
  options.profile = job.parameter("profile");
  options.fidelity = "dynamic";
  auto match = Match::make(options);
  if (!match) return match.error();
  Simulation& simulation = (*match)->simulation();
  Falls falls{simulation.world()};
  while (simulation.time().ms < 10'000) {
    (*match)->step();
    falls.look();
  }
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  measured.add("motion.stand." + job.parameter("scene") + ".falls", "falls", falls.count(),
               Aim::atMost(0));
  return measured;
}

/// A walk at full speed.
struct FullWalk {
  std::string_view name;
  Pose2D request;  // mm/s, rad/s
  Aim speed;       // mm/s, or degrees/s of a turn
};

constexpr double full = 1000, fullTurn = 10;
const std::array<FullWalk, 6> fullWalks{{{"forward", {0, full, 0}, Aim::atLeast(220)},
                                         {"backward", {0, -full, 0}, Aim::atLeast(150)},
                                         {"left", {0, 0, full}, Aim::atLeast(150)},
                                         {"right", {0, 0, -full}, Aim::atLeast(150)},
                                         {"turnLeft", {fullTurn, 0, 0}, Aim::atLeast(120)},
                                         {"turnRight", {-fullTurn, 0, 0}, Aim::atLeast(120)}}};

/// A robot on the field, alone or with others that stand still.
Result<std::unique_ptr<MovedRobot>> walker(const Job& job, const DataRoot& root,
                                           const std::string& motions = "configured",
                                           std::size_t robots = 1) {
  const auto scene = dynamicScene(job, root, robots);
  if (!scene) return scene.error();
  return MovedRobot::make(root, *scene, job.seed,
                          motions == "configured" ? root.path("motions") : motions);
}

Result<Measurement> walkFully(const Job& job, const DataRoot& root) {
  const FullWalk& walk = *std::ranges::find(fullWalks, job.parameter("direction"), &FullWalk::name);
  auto made = walker(job, root);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  robot.standUp();
  // Along the field, which is long enough for that.
  const bool turns = walk.request.rotation != 0;
  const double ahead = angleOf(walk.request.translation);
  robot.world().placeRobot(0, turns ? Pose2D{} : Pose2D{normalize(-ahead), -1800, 0});
  robot.run(0.5);
  robot.request.type = MotionType::walk;
  robot.request.walkType = *enumValue<WalkType>(job.parameter("type"));
  robot.request.walk = walk.request;
  constexpr double warmUp = 2, measured = 8;  // s
  robot.run(warmUp);

  Pose2D way, byOdometry;
  bool fell = false;
  for (double time = 0; time < measured; time += tickSeconds) {
    const Pose2D before = robot.body().pose, counted = robot.odometry().pose;
    robot.step();
    const auto add = [](Pose2D& sum, const Pose2D& from, const Pose2D& to) {
      const Pose2D step = to.relativeTo(from);
      sum.rotation += step.rotation;
      sum.translation += step.translation;
    };
    add(way, before, robot.body().pose);
    add(byOdometry, counted, robot.odometry().pose);
    fell |= robot.hasFallen();
  }
  const auto speed = [&](const Pose2D& sum) {
    return turns ? toDegrees(sum.rotation) / measured * (walk.request.rotation > 0 ? 1 : -1)
                 : sum.translation.dot(direction(ahead)) / measured;
  };
  Measurement measurement;
  const std::string name = "motion.walk." + std::string{walk.name};
  measurement.add(name + ".speed", turns ? "deg/s" : "mm/s", speed(way), walk.speed);
  measurement.add(name + ".odometryError", "%", 100 * std::abs(speed(byOdometry) / speed(way) - 1),
                  Aim::atMost(5));
  if (turns)
    measurement.add(name + ".drift", "mm/s", way.translation.norm() / measured);
  else
    measurement.add(name + ".turning", "deg/s", std::abs(toDegrees(way.rotation)) / measured,
                    Aim::atMost(2));
  measurement.add(name + ".falls", "falls", fell, Aim::atMost(0));
  return measurement;
}

Result<Measurement> wander(const Job& job, const DataRoot& root) {
  auto made = walker(job, root);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  robot.standUp();
  Random random = Random{job.seed}.fork("wander");
  const double seconds = 60 * job.number("minutes");
  int falls = 0;
  double until = 0;  // s: walks like this
  robot.request.type = MotionType::walk;
  robot.request.walkType = *enumValue<WalkType>(job.parameter("type"));
  while (static_cast<double>(robot.simulation().time().ms) < 1000 * seconds) {
    const double now = static_cast<double>(robot.simulation().time().ms) / 1000;
    const bool atTheWall = std::abs(robot.body().pose.translation.x()) > 1500 ||
                           std::abs(robot.body().pose.translation.y()) > 900;
    if (now >= until) {
      robot.request.walk = {fullTurn * random.symmetric() * random.uniform(),
                            full * direction(pi * random.symmetric())};
      until = now + random.uniform(0.5, 4);
    }
    // Back to the middle of the field, before a wall is in the way.
    if (atTheWall) robot.world().placeRobot(0, {robot.body().pose.rotation, 0, 0});
    robot.step();
    if (!robot.hasFallen()) continue;
    ++falls;
    robot.world().standUp(0);
  }
  Measurement measurement;
  measurement.add("motion.wander.falls", "1/h", falls / seconds * 3600, Aim::atMost(1));
  return measurement;
}

/// The mean speed of a robot, true and as it believes (mm/s, rad/s, in its own axes).
struct BothSpeeds {
  Pose2D truth, believed;
};

BothSpeeds speedsDuring(MovedRobot& robot, double seconds) {
  BothSpeeds mean;
  for (double time = 0; time < seconds; time += tickSeconds) {
    const Pose2D before = robot.body().pose, counted = robot.odometry().pose;
    robot.step();
    const auto add = [&](Pose2D& sum, const Pose2D& step) {
      sum.rotation += step.rotation / seconds;
      sum.translation += step.translation / seconds;
    };
    add(mean.truth, robot.body().pose.relativeTo(before));
    add(mean.believed, robot.odometry().pose.relativeTo(counted));
  }
  return mean;
}

/// Walks with speeds of chance, and finds the corrections for which the robot does what it believes
/// (report 3.9.1.3): least squares over all speeds.
Result<Measurement> odometry(const Job& job, const DataRoot& root) {
  WalkTypes types;
  if (auto read = readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), types); !read)
    return read.error();
  const WalkType type = *enumValue<WalkType>(job.parameter("type"));
  auto made = walker(job, root);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  robot.standUp();
  Random random = Random{job.seed}.fork("odometry");
  robot.request.type = MotionType::walk;
  robot.request.walkType = type;
  constexpr double startUp = 1, measured = 2;  // s
  std::vector<BothSpeeds> walks;
  double way = 0, astray = 0;  // mm/s
  RunningStatistics turn;
  while (walks.size() < static_cast<std::size_t>(job.number("walks"))) {
    robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
    robot.request.walk = {random.uniform() < 0.5 ? 0 : 3 * random.symmetric(),
                          random.uniform(0, 400) * direction(pi * random.symmetric())};
    robot.run(startUp);
    const BothSpeeds& walk = walks.emplace_back(speedsDuring(robot, measured));
    way += walk.truth.translation.norm();
    astray += (walk.truth.translation - walk.believed.translation).norm();
    turn.add(toDegrees(std::abs(walk.truth.rotation - walk.believed.rotation)));
  }
  // Ahead: share of the feet's speed, and what steps make by themselves; sideways: share, and place
  // of the turn; turns: share, and by walking sideways.
  const WalkParameters& now = types[type];
  const auto rows = static_cast<Eigen::Index>(walks.size());
  Eigen::MatrixX2d ahead(rows, 2), sideways(rows, 2), turns(rows, 2);
  Eigen::MatrixX3d truth(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BothSpeeds& walk = walks[static_cast<std::size_t>(i)];
    const Pose2D feet = now.feetFor(walk.believed);
    ahead.row(i) << feet.translation.x(), 1;
    sideways.row(i) << feet.translation.y(), walk.truth.rotation;
    turns.row(i) << feet.rotation, feet.translation.y();
    truth.row(i) << walk.truth.translation.x(), walk.truth.translation.y(), walk.truth.rotation;
  }
  const auto fit = [&](const Eigen::MatrixX2d& speeds, Eigen::Index axis) {
    return Vector2d{speeds.colPivHouseholderQr().solve(truth.col(axis))};
  };
  const Vector2d x = fit(ahead, 0), y = fit(sideways, 1), r = fit(turns, 2);
  Measurement measurement;
  measurement.add("motion.odometry.wayError", "%", 100 * astray / way, Aim::atMost(5));
  measurement.add("motion.odometry.turnError", "deg/s", turn.mean(), Aim::atMost(3));
  measurement.add("motion.odometry.correctionX", "", x[0]);
  measurement.add("motion.odometry.driftX", "mm/s", x[1]);
  measurement.add("motion.odometry.correctionY", "", y[0]);
  measurement.add("motion.odometry.turnCenter", "mm", y[1]);
  measurement.add("motion.odometry.correctionR", "", r[0]);
  measurement.add("motion.odometry.counterRotation", "rad/mm", -r[1] / r[0]);
  return measurement;
}

/// As the walk does it, or as the report does, which does not react.
Result<void> useLoop(const Job& job, MovedRobot& robot) {
  if (job.parameter("loop") == "closed") return {};
  return robot.configure("WalkingEngine", "InvKin", "[balance]\nyield 0\nplacement 0\nlift 0\n");
}

/// Is pushed at a shoulder while it walks, in a direction of chance.
Result<Measurement> push(const Job& job, const DataRoot& root) {
  auto made = walker(job, root);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  if (auto done = useLoop(job, robot); !done) return done.error();
  robot.standUp();
  Random random = Random{job.seed}.fork("push");
  robot.request.type = MotionType::walk;
  robot.request.walkType = *enumValue<WalkType>(job.parameter("type"));
  constexpr double lasts = 0.1, walks = 2.5, afterwards = 2;  // s
  const int attempts = static_cast<int>(job.number("attempts"));
  int up = 0;
  for (int i = 0; i < attempts; ++i) {
    robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
    robot.request.walk = {0, job.number("speed") * direction(pi * random.symmetric())};
    robot.run(walks + random.uniform());
    const Vector2d force = job.number("impulse") / lasts * direction(pi * random.symmetric());
    const Vector3d shoulder =
        shoulderOf({}, random.uniform() < 0.5 ? Leg::foreLeft : Leg::foreRight);
    bool fell = false;
    for (double time = 0; time < lasts + afterwards; time += tickSeconds) {
      if (time < lasts) robot.world().push(0, {force.x(), force.y(), 0}, shoulder);
      robot.step();
      fell |= robot.hasFallen();
    }
    up += !fell;
    if (fell) robot.world().standUp(0);
  }
  Measurement measurement;
  measurement.add("motion.push." + job.parameter("loop") + ".up", "%", 100. * up / attempts);
  return measurement;
}

/// Walks over a bar that lies across its way: a wall that is let into the ground.
Result<Measurement> stumble(const Job& job, const DataRoot& root) {
  auto made = walker(job, root);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  if (auto done = useLoop(job, robot); !done) return done.error();
  World& world = robot.world();
  const int wall = mj_name2id(&world.model(), mjOBJ_GEOM, "wallLeft");
  if (wall < 0) return Error{.what = "the scene has no wall named wallLeft"};
  const double half = 1000 * world.model().geom_size[3 * wall + 2];
  robot.standUp();
  world.moveGeom(wall, {0, 0, job.number("height") - half});
  Random random = Random{job.seed}.fork("stumble");
  robot.request.type = MotionType::walk;
  robot.request.walkType = *enumValue<WalkType>(job.parameter("type"));
  robot.request.walk = {0, job.number("speed"), 0};
  constexpr double longest = 8, before = 400, behind = 200;  // s, mm
  const int attempts = static_cast<int>(job.number("attempts"));
  int over = 0;
  for (int i = 0; i < attempts; ++i) {
    world.placeRobot(0, {pi / 2, 200 * random.symmetric(), -before - 50 * random.uniform()});
    bool fell = false;
    for (double time = 0; time < longest && !fell; time += tickSeconds) {
      robot.step();
      fell = robot.hasFallen();
      if (robot.body().pose.translation.y() < behind) continue;
      ++over;
      break;
    }
    if (fell) world.standUp(0);
  }
  Measurement measurement;
  measurement.add("motion.stumble." + job.parameter("loop") + ".over", "%", 100. * over / attempts);
  return measurement;
}

/// Lays a robot down, with its legs anywhere, until it rests.
void layDown(MovedRobot& robot, Posture posture, Random& random) {
  const double variety = 0.6 * random.uniform();  // rad
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    for (int number = 1; number <= 3; ++number) {
      const Joint joint = legJoint(leg, number);
      const auto limits = limitsOf(joint);
      const double angle = robot.body().joints[joint] + variety * random.symmetric();
      robot.world().turnJoint(0, joint, std::clamp(angle, limits.low, limits.high));
    }
  robot.world().throwOver(0, posture);
  robot.run(0.5);
}

/// Gets up from where it lies.
Result<Measurement> getUp(const Job& job, const DataRoot& root) {
  const bool crowded = job.parameter("beside") == "opponent";
  auto made = walker(job, root, job.parameter("motions"), crowded ? 2 : 1);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  robot.standUp();
  const auto posture = *enumValue<Posture>(job.parameter("from"));
  const int attempts = static_cast<int>(job.number("attempts"));
  Random random = Random{job.seed}.fork("getUp");
  constexpr double standHeight = 90, level = fromDegrees(20);  // mm, rad
  constexpr double longest = 8, allowed = 4, stands = 0.3;     // s
  int up = 0;
  double meanTime = 0;
  RunningStatistics lean;
  for (int i = 0; i < attempts; ++i) {
    robot.request = {};
    robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
    robot.run(0.5);
    layDown(robot, posture, random);
    if (crowded) {  // somebody stands where its legs will be
      const double where = pi * random.symmetric();
      robot.world().placeRobot(
          1, {pi * random.symmetric(), robot.body().pose.translation + 230 * direction(where)});
    }
    robot.request = {};
    robot.request.type = MotionType::getup;
    double seconds = 0, upright = 0;
    while (seconds < longest && upright < stands) {
      robot.step();
      seconds += tickSeconds;
      const RobotBody& body = robot.body();
      const bool stays = body.posture == Posture::standing && body.height > standHeight &&
                         std::abs(body.tilt) < level && std::abs(body.roll) < level;
      upright = stays ? upright + tickSeconds : 0;
      lean.add(toDegrees(std::acos(std::cos(body.tilt) * std::cos(body.roll))));
    }
    seconds -= upright;
    up += upright >= stands && seconds <= allowed;
    meanTime += seconds / attempts;
  }
  Measurement measurement;
  const std::string name =
      "motion.getUp." + job.parameter("from") + (crowded ? ".besideOpponent" : "");
  measurement.add(name + ".up", "%", 100. * up / attempts, Aim::atLeast(99));
  measurement.add(name + ".seconds", "s", meanTime);
  measurement.add(name + ".lean", "deg", lean.mean());
  return measurement;
}

}  // namespace

Experiments motionExperiments() {
  Parameter postures{"from", "how the robot lies at first", Parameter::Kind::each, {}};
  for (const auto name : enumNames<Posture>) postures.values.emplace_back(name);
  Parameter types{"type", "of the walk", Parameter::Kind::each, {}, true};
  for (const auto name : enumNames<WalkType>) types.values.emplace_back(name);
  Parameter directions{"direction", "in which it walks at full speed", Parameter::Kind::each, {}};
  for (const FullWalk& each : fullWalks) directions.values.emplace_back(each.name);
  const Parameter loops{
      "loop", "whether the walk reacts", Parameter::Kind::each, {"open", "closed"}};
  return {{"motion.walk",
           "Speed, drift and odometry of walks at full speed; friction, masses and strength are "
           "each seed otherwise",
           {profileParameter(), changeParameter(), fidelityParameter(), varietyParameter(), types,
            directions, valuesParameter()},
           withValues<walkFully>},
          {"motion.wander",
           "Falls of a robot that walks at full speed in random directions",
           {profileParameter(),
            changeParameter(),
            fidelityParameter(),
            types,
            valuesParameter(),
            {"minutes", "of walking", Parameter::Kind::number, {"10"}}},
           withValues<wander>},
          {"motion.odometry",
           "How far what robots believe to walk is from what they walk, and the corrections for it",
           {profileParameter(),
            changeParameter(),
            fidelityParameter(),
            varietyParameter(),
            types,
            valuesParameter(),
            {"walks", "of each robot", Parameter::Kind::number, {"20"}}},
           withValues<odometry>},
          {"motion.push",
           "Who stays up when it is pushed at a shoulder while it walks",
           {profileParameter(),
            changeParameter(),
            fidelityParameter(),
            varietyParameter(),
            types,
            loops,
            valuesParameter(),
            {"impulse", "of the push, N s", Parameter::Kind::number, {"2"}},
            {"speed", "of the walk, mm/s", Parameter::Kind::number, {"200"}},
            {"attempts", "of each robot", Parameter::Kind::number, {"5"}}},
           withValues<push>},
          {"motion.stumble",
           "Who gets over a bar that lies across its way",
           {profileParameter(),
            changeParameter(),
            fidelityParameter(),
            varietyParameter(),
            types,
            loops,
            valuesParameter(),
            {"height", "of the bar, mm", Parameter::Kind::number, {"12"}},
            {"speed", "of the walk, mm/s", Parameter::Kind::number, {"200"}},
            {"attempts", "of each robot", Parameter::Kind::number, {"3"}}},
           withValues<stumble>},
          {"motion.stand",
           "Who falls in the first ten seconds of a scene",
           {profileParameter(),
            {"scene",
             "from the folder scenes, in the dynamic fidelity",
             Parameter::Kind::each,
             {"match", "one-robot", "penalty-shoot-out", "ball-challenge", "localization-challenge",
              "obstacle-challenge"}}},
           stand},
          {"motion.getUp",
           "Whether and how fast robots get up within 4 s, their legs anywhere",
           {profileParameter(),
            changeParameter(),
            fidelityParameter(),
            varietyParameter(),
            postures,
            valuesParameter(),
            {"beside", "who stands there", Parameter::Kind::each, {"nobody", "opponent"}},
            {"motions", "folder of motion descriptions", Parameter::Kind::text, {"configured"}},
            {"attempts", "of each robot", Parameter::Kind::number, {"5"}}},
           withValues<getUp>}};
}

}  // namespace gt
