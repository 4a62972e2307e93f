// What the kicks do in both fidelities: how far and where the ball goes, and what happens to the
// robot.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"
#include "base/Statistics.h"
#include "measure/worlds/KickTables.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "representations/motion/KickTable.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// What a kick is measured for: balls around a place (mm) that shall go in a direction (degrees).
struct KickAim {
  double x, y, direction;
  double window;  ///< mm, to all sides
};

/// A ball somewhere where a kick shall reach it.
Vector2d somewhere(const KickAim& aim, Random& random) {
  return {aim.x + aim.window * random.symmetric(), aim.y + aim.window * random.symmetric()};
}

/// By how much a motion asks joints for more speed than is recommended, from line to line (%).
double hasteOf(const MotionNet& net, int motion) {
  double most = 0;
  const MotionNet::Node* before = nullptr;
  for (const MotionNet::Node& node : net.nodes) {
    if (node.kind != MotionNodeKind::data || node.motion != motion) continue;
    for (std::size_t j = 0; before && j < MotionNet::jointCount; ++j) {
      if (node.dontCare[j] || before->dontCare[j]) continue;
      const double seconds = tickSeconds * (node.interpolate ? node.frames : 1);
      const double speed = std::abs(node.angles[j] - before->angles[j]) / seconds;
      most = std::max(most, 100 * (speed / limitsOf(static_cast<Joint>(j)).speed - 1));
    }
    before = &node;
  }
  return most;
}

void measure(MovedRobot& robot, const std::string& motion, const KickAim& aim, int balls,
             Random& random, Measurement& measurement) {
  std::vector<double> lengths, astray, seconds;
  int falls = 0, missed = 0;
  double moved = 0, turned = 0, ahead = 0, byHead = 0;
  Vector2d movedAlong = Vector2d::Zero();
  for (int i = 0; i < balls; ++i) {
    const Vector2d place = somewhere(aim, random);
    const KickTrial kicked = tryKick(robot, motion, place, random);
    const double length = kicked.way.norm();
    constexpr double touched = 50;  // mm
    lengths.push_back(length);
    seconds.push_back(kicked.seconds);
    falls += kicked.fell;
    ahead += kicked.way.dot(direction(fromDegrees(aim.direction))) / balls;
    moved += kicked.moved.translation.norm() / balls;
    movedAlong += kicked.moved.translation / balls;
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
  measurement.add(name + ".robot.x", "mm", movedAlong.x());
  measurement.add(name + ".robot.y", "mm", movedAlong.y());
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
  const auto net = loadMotionNet(files.motions());
  if (!net) return files.named(net.error());
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
    measurement.add("motion.kick." + name + ".haste", "%", hasteOf(*net, net->find(name)),
                    Aim::atMost(0));
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
