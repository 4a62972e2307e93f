// What the kicks do in both fidelities: how far and where the ball goes, and what happens to the
// robot.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"
#include "base/Statistics.h"
#include "measure/worlds/MovedRobot.h"
#include "representations/motion/KickTable.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// What one kick did.
struct Kicked {
  Vector2d way = Vector2d::Zero();  ///< mm, of the ball, in the robot's system before the kick
  double seconds = 0;               ///< from the request until the robot stands
  double strike = 0;                ///< until the ball is fastest
  Pose2D moved;                     ///< of the robot
  bool fell = false;
  bool overlaps = false;  ///< There is no room for the ball: the robot stands there.
  double byHead = 0;      ///< Share of the ball's speed that it gained where the head alone pushed.
};

/// Whether the robot's head touches the ball, and no other part of it.
bool touchesByHeadAlone(const World& world) {
  const RobotParts& parts = world.parts(0);
  bool byHead = false;
  for (int i = 0; i < world.data().ncon; ++i) {
    const mjContact& contact = world.data().contact[i];
    const int first = world.model().geom_bodyid[contact.geom1];
    const int second = world.model().geom_bodyid[contact.geom2];
    if (first != world.ballBody(0) && second != world.ballBody(0)) continue;
    const int other = first == world.ballBody(0) ? second : first;
    const bool ofRobot = world.model().body_rootid[other] == parts.body;
    if (ofRobot && other != parts.headBody) return false;
    byHead |= ofRobot;
  }
  return byHead;
}

/// A robot in the middle of the field faces anywhere, walks some steps as it does on its way to a
/// ball, and is asked for the kick; the ball is put down as the kick begins. When the robot stands
/// again, the ball rolls, and no wall has stopped it yet: from there its way is calculated.
Kicked kick(MovedRobot& robot, const std::string& name, const Vector2d& place, Random& random) {
  robot.request = {};
  robot.world().placeBall(0, {1900, 1200});
  robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
  robot.run(0.6);
  robot.request.type = MotionType::walk;
  robot.request.walk = {0.5 * random.symmetric(), 100 * random.uniform(), 60 * random.symmetric()};
  robot.run(1 + 0.5 * random.uniform());
  robot.request = {};
  robot.request.type = MotionType::specialAction;
  robot.request.specialAction = name;
  constexpr double longest = 8;  // s
  double waited = 0;
  for (; robot.motion().executed.specialAction != name && waited < longest; waited += tickSeconds)
    robot.step();
  const Pose2D from = robot.body().pose;
  robot.world().placeBall(0, from * place);
  Kicked kicked;
  robot.step();
  constexpr double pushed = 30;  // mm/s
  kicked.overlaps = robot.world().ball(0).speed.norm() > pushed;
  if (kicked.overlaps) return kicked;
  double fastest = 0, gained = 0, before = 0;  // mm/s
  const auto step = [&] {
    robot.step();
    kicked.seconds += tickSeconds;
    const double speed = robot.world().ball(0).speed.norm();
    const double gain = std::max(0., speed - std::exchange(before, speed));
    gained += gain;
    if (touchesByHeadAlone(robot.world())) kicked.byHead += gain;
    if (speed > fastest) kicked.strike = kicked.seconds;
    fastest = std::max(fastest, speed);
  };
  robot.request = {};
  while (robot.motion().executed.type == MotionType::specialAction && kicked.seconds < longest)
    step();
  if (gained > 0) kicked.byHead /= gained;
  kicked.moved = robot.body().pose.relativeTo(from);
  const BallState& ball = robot.world().ball(0);
  const double slowing = robot.simulation().scene().physics.deceleration;
  const Vector2d rolls = ball.speed * ball.speed.norm() / (2 * slowing);
  kicked.way = relative(from, Vector2d{ball.position + rolls}) - place;
  // What rolls over on purpose stands again now; others fall only when they stand again.
  for (double after = 0; after < 1; after += tickSeconds) {
    robot.step();
    kicked.fell |= robot.hasFallen();
  }
  return kicked;
}

/// What a kick is measured for: balls around a place (mm) that shall go in a direction (degrees).
struct KickAim {
  double x, y, direction;
  double window;  ///< mm, to all sides
};

/// A ball somewhere where a kick shall reach it.
Vector2d somewhere(const KickAim& aim, Random& random) {
  return {aim.x + aim.window * random.symmetric(), aim.y + aim.window * random.symmetric()};
}

void measure(MovedRobot& robot, const std::string& motion, const KickAim& aim, int balls,
             Random& random, Measurement& measurement) {
  std::vector<double> lengths, astray, seconds;
  int falls = 0, missed = 0;
  double moved = 0, turned = 0, ahead = 0, byHead = 0;
  for (int i = 0; i < balls; ++i) {
    const Vector2d place = somewhere(aim, random);
    const Kicked kicked = kick(robot, motion, place, random);
    const double length = kicked.way.norm();
    constexpr double touched = 50;  // mm
    lengths.push_back(length);
    seconds.push_back(kicked.seconds);
    falls += kicked.fell;
    ahead += kicked.way.dot(direction(fromDegrees(aim.direction))) / balls;
    moved += kicked.moved.translation.norm() / balls;
    turned += toDegrees(kicked.moved.rotation) / balls;
    byHead += kicked.byHead / balls;
    if (length > touched)
      astray.push_back(toDegrees(normalize(angleOf(kicked.way) - fromDegrees(aim.direction))));
    else
      ++missed;
  }
  const std::string name = "motion.kick." + motion;
  const auto share = [&](int count) { return 100. * count / balls; };
  measurement.add(name + ".length", "mm", mean(lengths));
  measurement.add(name + ".ahead", "mm", ahead);
  measurement.add(name + ".missed", "%", share(missed), Aim::atMost(5));
  measurement.add(name + ".falls", "%", share(falls), Aim::atMost(2));
  measurement.add(name + ".seconds", "s", mean(seconds));
  if (robot.simulation().scene().fidelity ==
      Fidelity::dynamic)  // In the other one nothing touches.
    measurement.add(name + ".byHead", "%", 100 * byHead);
  measurement.add(name + ".robot.moved", "mm", moved);
  measurement.add(name + ".robot.turned", "deg", turned);
  if (astray.empty()) return;
  // From the direction that the kick shall have: how one robot differs from another counts, too.
  const double squares = std::inner_product(astray.begin(), astray.end(), astray.begin(), 0.);
  measurement.add(name + ".astray", "deg", mean(astray));
  measurement.add(name + ".spread", "deg", std::sqrt(squares / static_cast<double>(astray.size())),
                  Aim::atMost(10));
}

/// The files that a job's kicks come from: the project's, or a team's laid over them.
class KickFiles {
 public:
  static Result<KickFiles> open(const Job& job, const DataRoot& root) {
    KickFiles files;
    files.paths_ = ConfigurationPaths::in(root);
    const auto folder = teamOfVersion(job.parameter("team"), root);
    if (!folder) return folder.error();
    if (folder->empty()) return files;
    auto team = TeamFolder::open(*folder, files.paths_);
    if (!team) return team.error();
    files.team_ = std::move(*team);
    files.paths_ = files.team_->paths();
    return files;
  }
  const std::string& motions() const { return paths_.motions; }
  Result<KickTable> table() const {
    KickTable table;
    if (auto read = readConfig(paths_.config + "/kicks.cfg", table); !read)
      return named(read.error());
    return table;
  }
  /// An error about one of the files, with the name that it has in the team's folder.
  Error named(Error error) const { return team_ ? team_->named(std::move(error)) : error; }

 private:
  std::unique_ptr<TeamFolder> team_;
  ConfigurationPaths paths_;
};

/// The kicks of a folder of motion descriptions: those in its folder kicks/.
std::vector<std::string> kicksIn(const std::string& motions) {
  std::vector<std::string> names;
  std::error_code failed;  // then there are none
  for (const auto& entry : std::filesystem::directory_iterator{motions + "/kicks", failed})
    if (entry.path().extension() == ".mof") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

/// A robot that stands and shall kick.
struct Kicker {
  KickFiles files;
  KickTable table;
  std::unique_ptr<MovedRobot> robot;

  static Result<Kicker> make(const Job& job, const DataRoot& root) {
    auto scene = dynamicScene(job, root);
    if (!scene) return scene.error();
    scene->balls.resize(1);
    auto files = KickFiles::open(job, root);
    if (!files) return files.error();
    auto table = files->table();
    if (!table) return table.error();
    auto robot = MovedRobot::make(root, *scene, job.seed, files->motions());
    if (!robot) return files->named(robot.error());
    (*robot)->standUp();
    return Kicker{*std::move(files), *std::move(table), *std::move(robot)};
  }
};

Result<Measurement> kickAll(const Job& job, const DataRoot& root) {
  const auto made = Kicker::make(job, root);
  if (!made) return made.error();
  const auto& [files, table, robot] = *made;
  Measurement measurement;
  const std::string& only = job.parameter("kick");
  for (const std::string& name : kicksIn(files.motions())) {
    Random random = Random{job.seed}.fork(name);
    const int index = table.find(name);
    if (only != name && (only != "all" || index < 0)) continue;
    KickAim aim{150, 0, 0, job.number("window")};
    if (index >= 0) {
      const KickDescription& kick = table.kicks[static_cast<std::size_t>(index)];
      aim = {kick.x, kick.y, kick.direction, aim.window};
    }
    for (const auto& [parameter, number] :
         {std::pair{"x", &aim.x}, {"y", &aim.y}, {"direction", &aim.direction}})
      if (job.parameter(parameter) != "table") *number = job.number(parameter);
    measure(*robot, name, aim, static_cast<int>(job.number("balls")), random, measurement);
  }
  if (measurement.values.empty()) return Error{.field = only, .what = "is no kick"};
  return measurement;
}

/// Places before a robot, in mm.
struct Grid {
  int step, nearest, farthest;
};

/// Balls at all places of a grid, one each.
void measurePlaces(MovedRobot& robot, const std::string& motion, const Grid& grid, Random& random,
                   Measurement& measurement) {
  constexpr int widest = 180;  // mm
  double seconds = 0, x = 0, y = 0, turned = 0;
  int kicks = 0;
  std::vector<double> strikes;
  const std::string name = "kicks." + motion;
  for (int ahead = grid.nearest; ahead <= grid.farthest; ahead += grid.step)
    for (int left = -widest; left <= widest; left += grid.step) {
      const Kicked kicked = kick(robot, motion, Vector2d(ahead, left), random);
      if (kicked.overlaps) continue;
      ++kicks;
      seconds += kicked.seconds;
      x += kicked.moved.translation.x();
      y += kicked.moved.translation.y();
      turned += toDegrees(kicked.moved.rotation);
      constexpr double touched = 150;  // mm
      const std::string at = name + ".at." + std::to_string(ahead) + "." + std::to_string(left);
      const double length = kicked.way.norm();
      measurement.add(at + ".hit", "", length > touched);
      measurement.add(at + ".fell", "", kicked.fell);
      if (length <= touched) continue;
      strikes.push_back(kicked.strike);
      measurement.add(at + ".length", "mm", length);
      measurement.add(at + ".direction", "deg", toDegrees(angleOf(kicked.way)));
    }
  measurement.add(name + ".seconds", "s", seconds / kicks);
  measurement.add(name + ".robot.x", "mm", x / kicks);
  measurement.add(name + ".robot.y", "mm", y / kicks);
  measurement.add(name + ".robot.turned", "deg", turned / kicks);
  if (!strikes.empty()) {
    std::ranges::sort(strikes);
    measurement.add(name + ".strike", "s", strikes[strikes.size() / 2]);
  }
}

Result<Measurement> measureGrid(const Job& job, const DataRoot& root) {
  const auto made = Kicker::make(job, root);
  if (!made) return made.error();
  const auto& [files, table, robot] = *made;
  Measurement measurement;
  const auto number = [&](const char* name) { return static_cast<int>(job.number(name)); };
  const Grid grid{number("step"), number("nearest"), number("farthest")};
  if (grid.step < 1) return Error{.field = "step", .what = "expected some mm"};
  const std::string& only = job.parameter("kick");
  for (const std::string& name : kicksIn(files.motions())) {
    Random random = Random{job.seed}.fork(name);
    // What ends in Right is the mirrored Left.
    if (only == name || (only == "all" && table.find(name) >= 0 && !name.ends_with("Right")))
      measurePlaces(*robot, name, grid, random, measurement);
  }
  if (measurement.values.empty()) return Error{.field = only, .what = "is no kick"};
  return measurement;
}

Parameter kickTeamParameter() {
  Parameter parameter = teamParameter("team");
  parameter.description = "whose kicks, and values: " + parameter.description;
  return parameter;
}

}  // namespace

Experiment kickTableExperiment() {
  return {
      "kicks",
      "What each kick does with a ball at each place of a grid: of this scripts/kick-table makes "
      "the table of kicks",
      {{"profile", "how far all is from perfect", Parameter::Kind::choice, {"padova", "benign"}},
       changeParameter(),
       fidelityParameter(),
       {"kick", "one of them, or all of the table", Parameter::Kind::text, {"all"}},
       kickTeamParameter(),
       {"step", "mm from place to place; the table has 20", Parameter::Kind::number, {"60"}},
       {"nearest", "mm ahead, of the places", Parameter::Kind::number, {"60"}},
       {"farthest", "mm ahead, of the places", Parameter::Kind::number, {"220"}}},
      measureGrid};
}

Experiment kickExperiment() {
  return {"motion.kick",
          "Where the ball goes that lies near to the place where a kick plays it best",
          {profileParameter(),
           changeParameter(),
           fidelityParameter(),
           varietyParameter(),
           {"kick", "one of them, or all", Parameter::Kind::text, {"all"}},
           kickTeamParameter(),
           {"x", "mm ahead, where the ball lies", Parameter::Kind::text, {"table"}},
           {"y", "mm to the left", Parameter::Kind::text, {"table"}},
           {"direction", "degrees, where it shall go", Parameter::Kind::text, {"table"}},
           {"window", "mm by which it lies elsewhere at most", Parameter::Kind::number, {"15"}},
           {"balls", "that each of them kicks", Parameter::Kind::number, {"5"}},
           valuesParameter()},
          withValues<kickAll>};
}

}  // namespace gt
