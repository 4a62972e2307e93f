// Where a robot looks: whether it sees the ball, how long it looks away from it, and what it knows
// of the rest meanwhile (report 3.9.3).
#include <algorithm>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "WorldModelWatch.h"
#include "framework/Requests.h"
#include "match/SimulatedRobot.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

/// The first robot of a scene, with its whole program, among others that stand still, and a ball.
class LookingRobot {
 public:
  static Result<std::unique_ptr<LookingRobot>> make(const Job& job, const DataRoot& root,
                                                    std::size_t opponents) {
    auto scene = dynamicScene(job, root, 8);
    if (!scene) return scene.error();
    const auto striker = scene->robots[2];
    scene->robots.erase(scene->robots.begin(), scene->robots.begin() + 4);
    scene->robots.resize(opponents);
    scene->robots.insert(scene->robots.begin(), striker);
    scene->balls.resize(1);
    const auto configuration = loadConfiguration(ConfigurationPaths::in(root));
    if (!configuration) return configuration.error();
    const auto layout = loadLayout(scene->resolve(striker.layout));
    if (!layout) return layout.error();
    auto simulation = Simulation::make(*scene, job.seed);
    if (!simulation) return simulation.error();
    std::unique_ptr<LookingRobot> made{new LookingRobot{*std::move(simulation), job.seed}};
    const auto program = SimulatedRobot::enter(*made->simulation_, 0,
                                               {*configuration, *layout, striker.player(), job.seed,
                                                platformRepresentations(), striker.address});
    if (!program) return program.error();
    made->program_ = *program;
    if (auto done = made->program_->robot().request(
            SolutionRequest{"HeadControl", job.parameter("solution")});
        !done)
      return done.error();
    return made;
  }

  /// Overrides the behavior: the robot executes an option or, with a head control mode, a basic
  /// behavior.
  void execute(const std::string& root, const std::string& headMode = {}) {
    BehaviorControlRequest request;
    request.root = root;
    request.basicBehavior = !headMode.empty();
    if (request.basicBehavior) request.outputs = {{"head_control_mode", headMode}};
    program_->robot().fromTools().write(simulation_->time(), request);
    program_->robot().answer();
  }
  /// A tick of 8 ms. Returns whether there was an image.
  bool step() {
    simulation_->step();
    if (body().posture != Posture::standing) simulation_->world().standUp(0);
    return simulation_->input(0).image;
  }
  void run(double seconds) {
    for (double time = 0; time < seconds; time += tickSeconds) step();
  }

  /// Puts the ball somewhere on the field, as far from the robot and in such a direction. If there
  /// is no such place, the robot is put somewhere else, too.
  void placeBall(double nearest, double farthest, double widest) {
    constexpr double x = 1800, y = 1050;  // mm, clear of the walls and goals
    for (int attempt = 0;; ++attempt) {
      const Vector2d place =
          random_.uniform(nearest, farthest) * direction(widest * random_.symmetric());
      const Vector2d onField = body().pose * place;
      if (std::abs(onField.x()) < x && std::abs(onField.y()) < y && isFree(onField))
        return simulation_->world().placeBall(0, onField);
      if (attempt % 20 == 19) placeRobot();
    }
  }
  void placeRobot() {
    constexpr double x = 1500, y = 800;  // mm
    Pose2D pose;
    do pose = {pi * random_.symmetric(), x * random_.symmetric(), y * random_.symmetric()};
    while (!isFree(pose.translation));
    simulation_->world().placeRobot(0, pose);
  }

  Simulation& simulation() { return *simulation_; }
  const RobotBody& body() const { return simulation_->world().robot(0); }
  const SimulatedRobot& program() const { return *program_; }
  const OracledWorldState& truth() const { return simulation_->input(0).oracle; }
  Time now() const { return simulation_->time(); }
  double ballDistance() const {
    return (simulation_->world().ball(0).position - body().pose.translation).norm();
  }
  /// Whether all of the ball lies in the last image.
  bool ballInImage() const {
    const CameraView& view = simulation_->lastView(0);
    const Vector3d ball = view.last.inverse() * ballCenter();
    if (ball.x() < 1) return false;
    const Vector2d center = view.info.project(ball);
    const double radius = view.info.focalX * simulation_->world().ballRadius(0) / ball.norm();
    return center.x() >= radius && center.x() <= view.info.width - radius && center.y() >= radius &&
           center.y() <= view.info.height - radius;
  }
  /// The angle between the optical axis and the ball, now (rad).
  double besideBall() const {
    const Vector3d ball = simulation_->world().camera(0).inverse() * ballCenter();
    return std::atan2(ball.tail<2>().norm(), ball.x());
  }
  bool sees() const { return program_->robot().provided<BallPercept>()->seen; }
  /// For how long it has not seen the ball (ms).
  std::int64_t unseen() const { return now() - program_->belief().ball->lastSeen; }

 private:
  LookingRobot(std::unique_ptr<Simulation> simulation, std::uint64_t seed)
      : simulation_{std::move(simulation)}, random_{Random{seed}.fork("head")} {}

  Vector3d ballCenter() const {
    const Vector2d& ball = simulation_->world().ball(0).position;
    return {ball.x(), ball.y(), simulation_->world().ballRadius(0)};
  }
  bool isFree(const Vector2d& place) const {
    constexpr double room = 350;  // mm
    for (std::size_t i = 1; i < simulation_->world().robotCount(); ++i)
      if ((simulation_->world().robot(i).pose.translation - place).norm() < room) return false;
    return true;
  }

  std::unique_ptr<Simulation> simulation_;
  SimulatedRobot* program_ = nullptr;  ///< Owned by the simulation.
  Random random_;
};

/// For how long the head is turned away from a ball to which it returns.
class Scans {
 public:
  void look(const LookingRobot& robot) {
    const bool away = robot.besideBall() > farOff;
    if (away == away_) return;
    away_ = away;
    if (away)
      began_ = robot.now();
    else if (began_ != never() && robot.now() - began_ < longest)
      lengths_.push_back(static_cast<double>(robot.now() - began_));
  }
  /// What comes next does not continue what was.
  void restart() {
    away_ = true;
    began_ = never();
  }
  const std::vector<double>& lengths() const { return lengths_; }

 private:
  static constexpr double farOff = 0.1;          // rad
  static constexpr std::int64_t longest = 1280;  // ms; after that the ball is searched

  bool away_ = true;
  Time began_ = never();
  std::vector<double> lengths_;
};

/// For so long after it was seen the ball counts as known.
constexpr std::int64_t knownFor = 1000;  // ms

/// Compares what the robot sees and knows after an image with the truth.
void compareWithTruth(LookingRobot& robot, const std::string& name, Tally& tally) {
  const bool inImage = robot.ballInImage();
  tally.count(name + ".inImage", inImage);
  if (inImage) tally.count(name + ".seen", robot.sees());
  tally.count(name + ".known", robot.unseen() < knownFor);
  tally.measure(
      name + ".pose", "mm",
      (robot.program().belief().pose->pose.translation - robot.truth().robotPose.translation)
          .norm());
}

Measurement measurementOf(const Tally& tally) {
  Measurement measurement;
  for (const auto& [name, rate] : tally.rates)
    measurement.add(name, "%", rate.percent(),
                    name == "motion.head.search.seen" ? Aim::atLeast(95) : Aim{});
  for (const auto& [name, errors] : tally.errors)
    measurement.add(name, errors.unit, mean(errors.values));
  return measurement;
}

/// A robot stands, and the ball lies somewhere before it.
Result<Measurement> searchForBall(const Job& job, const DataRoot& root) {
  auto made = LookingRobot::make(job, root, 0);
  if (!made) return made.error();
  LookingRobot& robot = **made;
  const std::string name = "motion.head.search";
  Tally tally;
  Scans scans;
  robot.placeRobot();
  robot.execute("stand", "search_auto");
  robot.run(1);
  for (int i = static_cast<int>(job.number("balls")); i > 0; --i) {
    robot.placeBall(300, 2000, fromDegrees(80));
    scans.restart();
    constexpr double longest = 12;            // s
    constexpr std::int64_t watchedFor = 300;  // ms
    const Time began = robot.now();
    bool found = false, watched = false;
    for (double time = 0; time < longest; time += tickSeconds) {
      const bool image = robot.step();
      if (!found && image && robot.sees() && robot.ballInImage()) {
        found = true;
        tally.measure(name + ".found", "s", static_cast<double>(robot.now() - began) / 1000);
      }
      // The search may overshoot the ball; what comes after it was watched is a scan.
      watched |= found && robot.program().belief().ball->consecutiveTimeSeen >= watchedFor;
      if (watched) scans.look(robot);
      if (found && image) compareWithTruth(robot, name, tally);
    }
    tally.count(name + ".foundShare", found);
  }
  Measurement measurement = measurementOf(tally);
  if (scans.lengths().empty()) return measurement;
  measurement.add("motion.head.scan.mean", "ms", mean(scans.lengths()));
  measurement.add("motion.head.scan.longest", "ms", std::ranges::max(scans.lengths()),
                  Aim::atMost(880));
  return measurement;
}

/// A robot walks to the ball, among opponents that stand still, as it does in a match.
Result<Measurement> approach(const Job& job, const DataRoot& root) {
  auto made = LookingRobot::make(job, root, static_cast<std::size_t>(job.number("opponents")));
  if (!made) return made.error();
  LookingRobot& robot = **made;
  const std::string name = "motion.head.approach";
  Tally tally;
  robot.placeRobot();
  robot.execute("stand", "search_for_landmarks");
  robot.run(5);
  for (int i = static_cast<int>(job.number("balls")); i > 0; --i) {
    robot.placeBall(800, 2000, fromDegrees(60));
    robot.execute("stand", "search_auto");
    robot.run(3);
    if (robot.unseen() > knownFor) continue;  // that is what searchForBall measures
    robot.execute("handle_ball");
    constexpr double longest = 15, arrived = 300, near = 600;  // s, mm
    double time = 0;
    for (; time < longest && robot.ballDistance() > arrived; time += tickSeconds) {
      if (!robot.step()) continue;
      compareWithTruth(robot, name, tally);
      if (robot.ballDistance() < near) tally.count(name + ".near.inImage", robot.ballInImage());
      comparePlayers(*robot.program().robot().provided<PlayersCollection>(),
                     robot.program().robot().setup().player.teamColor, robot.truth(), tally);
    }
    tally.count(name + ".arrived", time < longest);
    if (time < longest) tally.measure(name + ".seconds", "s", time);
  }
  Tally own;
  for (const auto& [key, rate] : tally.rates)
    if (key.starts_with(name)) own.rates[key] = rate;
  if (const auto known = tally.rates.find("players.opponents.known"); known != tally.rates.end())
    own.rates[name + ".opponents"] = known->second;
  for (const auto& [key, errors] : tally.errors)
    if (key.starts_with(name)) own.errors[key] = errors;
  return measurementOf(own);
}

}  // namespace

Experiments headExperiments() {
  const Parameter solution{
      "solution", "of HeadControl", Parameter::Kind::each, {"GT2003", "ActiveVision"}, true};
  return {
      {"motion.head.search",
       "Whether a standing robot that searches, watches and leaves the ball (search-auto) sees "
       "it, and for how long it looks away",
       {profileParameter(),
        changeParameter(),
        fidelityParameter(),
        varietyParameter(),
        solution,
        valuesParameter(),
        {"balls", "one after another, 12 s each", Parameter::Kind::number, {"5"}}},
       withValues<searchForBall>},
      {"motion.head.approach",
       "What a robot sees and knows while it walks to the ball among opponents that stand still",
       {profileParameter(),
        changeParameter(),
        fidelityParameter(),
        varietyParameter(),
        solution,
        valuesParameter(),
        {"opponents", "0 to 4", Parameter::Kind::number, {"3"}},
        {"balls", "one after another, 15 s each at most", Parameter::Kind::number, {"5"}}},
       withValues<approach>}};
}

}  // namespace gt
