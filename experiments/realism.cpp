// Whether simulated robots err as the real ones did: the report's published figures, measured with
// the report's methods and constants in each profile (docs/realism.md).
#include <cmath>
#include <map>

#include "Experiments.h"
#include "GoToPoints.h"
#include "Profiles.h"
#include "base/Statistics.h"
#include "measure/Tally.h"
#include "measure/real/MatrixFit.h"
#include "measure/worlds/MovedRobot.h"
#include "modules/modeling/selflocator/LinesSelfLocator.h"
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

/// What lies measures nothing that is meant here.
constexpr const char* fallen = "the robot fell";

/// A robot in the profile of a job, with the camera matrix of the report.
Result<std::unique_ptr<SimulatedWalker>> walkerOf(const Job& job, const DataRoot& root,
                                                  WalkerWorld world = {.legsOnly = true},
                                                  Fidelity fidelity = Fidelity::kinematic) {
  Result<void> changed;
  world.profile = profileOf(job);
  world.change = [&](SceneDescription& scene) {
    scene.fidelity = fidelity;
    changed = changeNumbers(scene, job.parameter("change"));
  };
  auto walker = SimulatedWalker::make(root, job.seed, world);
  if (!changed) return changed.error();
  return walker;
}

/// Lines with 100 particles and one point of each type in an image, as on the robot of 2003.
LocatorOf<LinesSelfLocator> reportsLines(std::uint64_t seed) {
  LinesSelfLocator::Parameters parameters;
  parameters.particles = 100;
  parameters.edges.points = 1;
  return {parameters, seed};
}

double percentBelow(const std::vector<double>& errors, double limit) {
  const auto below =
      std::count_if(errors.begin(), errors.end(), [&](double e) { return e < limit; });
  return 100 * static_cast<double>(below) / static_cast<double>(errors.size());
}

/// A summary, and the share below the mean, which the report states.
void addErrors(Measurement& run, const std::string& name, const std::vector<double>& errors) {
  for (const auto& [of, value] : summaryOf(errors)) run.add(name + '.' + of, "mm", value);
  run.add(name + ".belowMean", "%", percentBelow(errors, mean(errors)));
}

/// How far a measured camera matrix is from the true one: where its axis points up, how it rolls
/// about it (deg), and the square of both errors and that of the height, each divided by what the
/// matrix tells of it.
struct MatrixErrors {
  std::vector<double> tilt, roll, height, squared;

  void add(const CameraMatrix& measured, const CameraMatrix& truth) {
    if (!measured.valid) return;
    const auto elevation = [](const CameraMatrix& matrix) {
      return toDegrees(std::asin(std::clamp(matrix.pose.rotation(2, 0), -1., 1.)));
    };
    const auto rolling = [](const CameraMatrix& matrix) {
      return toDegrees(std::atan2(matrix.pose.rotation(2, 1), matrix.pose.rotation(2, 2)));
    };
    const double higher = measured.pose.translation.z() - truth.pose.translation.z();
    tilt.push_back(std::abs(elevation(measured) - elevation(truth)));
    roll.push_back(std::abs(rolling(measured) - rolling(truth)));
    height.push_back(std::abs(higher));
    const Eigen::AngleAxisd turn(measured.pose.rotation * truth.pose.rotation.transpose());
    Vector3d error = turn.angle() * turn.axis();
    error.z() = higher;
    squared.push_back(error.dot(measured.covariance.ldlt().solve(error)) / 3);
  }
  void addTo(Measurement& run, const std::string& name) const {
    for (const auto& [of, sizes] : {std::pair{".tilt", &tilt}, {".roll", &roll}}) {
      run.add(name + of + ".mean", "deg", mean(*sizes));
      run.add(name + of + ".p95", "deg", quantile(*sizes, 0.95));
      std::vector<double> squares;
      for (const double size : *sizes) squares.push_back(size * size);
      run.add(name + of + ".rms", "deg", std::sqrt(mean(squares)));
    }
    run.add(name + ".height.mean", "mm", mean(height));
    run.add(name + ".told", "", mean(squared));
  }
};

/// Experiment 1 of report 3.3.3.4: a walk of 18 minutes.
Result<Measurement> walkAbout(const Job& job, const DataRoot& root) {
  auto walker =
      walkerOf(job, root, {.legsOnly = true}, *enumValue<Fidelity>(job.parameter("fidelity")));
  if (!walker) return walker.error();
  SimulatedWalker& robot = **walker;
  auto lines = reportsLines(job.seed);
  MatrixErrors matrices;
  std::vector<double> drifts, scales;
  Pose2D odometry = robot.odometry.pose, truth = robot.pose;
  double believed = 0, gone = 0;
  const auto images = static_cast<int>(SyntheticRobot::imagesPerMinute * job.number("minutes"));
  std::vector<double> errors;
  for (int i = 0; i < images; ++i) {
    const Pose2D before = robot.pose, beforeByOdometry = robot.odometry.pose;
    robot.step();
    if (robot.hasFallen()) return Error{.what = fallen};
    const double error = (lines(seenBy(robot)).pose.translation - robot.pose.translation).norm();
    if (i >= SyntheticRobot::imagesPerMinute / 6) errors.push_back(error);
    matrices.add(robot.camera, robot.trueCamera);
    const Vector2d step = robot.odometry.pose.relativeTo(beforeByOdometry).translation;
    believed += step.norm();
    if (step.norm() > 0) gone += robot.pose.relativeTo(before).translation.dot(step.normalized());
    if (i % SyntheticRobot::imagesPerMinute != 0) continue;
    const Pose2D walked = robot.odometry.pose.relativeTo(odometry);
    if (i > 0) drifts.push_back(((truth * walked).translation - robot.pose.translation).norm());
    odometry = robot.odometry.pose;
    truth = robot.pose;
  }
  Measurement run;
  addErrors(run, "realism.lines.walk", errors);
  matrices.addTo(run, "realism.matrix");
  if (!drifts.empty()) run.add("realism.odometry.minute", "mm", mean(drifts));
  run.add("realism.odometry.length", "%", 100 * gone / std::max(believed, 1.0));
  return run;
}

/// Experiment 2 of report 3.3.3.4: 68 points, reached by go-to-point.
Result<Measurement> goToPoint(const Job& job, const DataRoot& root) {
  auto walker = walkerOf(job, root);
  if (!walker) return walker.error();
  auto lines = reportsLines(job.seed);
  std::vector<double> stops, estimates;
  for (const Arrival& arrival :
       goToPoints(**walker, lines, static_cast<int>(job.number("points")), job.seed)) {
    stops.push_back(arrival.ofRobot);
    estimates.push_back(arrival.ofEstimate);
  }
  Measurement run;
  addErrors(run, "realism.lines.goal", stops);
  addErrors(run, "realism.lines.estimate", estimates);
  return run;
}

/// Figure 3.8 of the report: Monte-Carlo localization with 100 particles, from nothing and after
/// somebody put the robot elsewhere.
Result<Measurement> searchItself(const Job& job, const DataRoot& root) {
  constexpr int most = 500;
  auto walker = walkerOf(job, root, {.walks = false, .legsOnly = true});
  if (!walker) return walker.error();
  SimulatedWalker& robot = **walker;
  std::vector<double> nothing, displaced;
  for (int i = 0; i < static_cast<int>(job.number("trials")); ++i) {
    MonteCarloSelfLocator::Parameters parameters;
    parameters.particles = 100;
    LocatorOf<MonteCarloSelfLocator> locator{parameters,
                                             1000 * job.seed + static_cast<std::uint64_t>(i)};
    const auto locate = [&](SimulatedWalker& at) { return locator(seenBy(at)); };
    robot.kidnap();
    nothing.push_back(imagesUntilLocalized(robot, most, locate));
    robot.kidnap();
    displaced.push_back(imagesUntilLocalized(robot, most, locate));
  }
  Measurement run;
  for (const auto& [name, images] : {std::pair{"fromNothing", nothing}, {"displaced", displaced}})
    for (const auto& [of, value] : summaryOf(images))
      run.add("realism.montecarlo." + std::string{name} + '.' + of, "images", value);
  return run;
}

/// A robot that walks about, or stands: "stand", "walk", or type and speed of the walk.
WalkerWorld worldOfGait(const std::string& gait) {
  WalkerWorld world{.walks = gait != "stand"};
  if (const std::size_t dot = gait.find('.'); dot != std::string::npos) {
    world.walkType = *enumValue<WalkType>(gait.substr(0, dot));
    world.walkingSpeed = std::stod(gait.substr(dot + 1));
  }
  return world;
}

/// How far the camera matrix of a robot that walks about or stands is from the true one.
Result<Measurement> compareMatrices(const Job& job, const DataRoot& root) {
  const std::string &gait = job.parameter("gait"), &fidelity = job.parameter("fidelity");
  const std::string& posture = job.parameter("posture");
  WalkerWorld world = worldOfGait(gait);
  world.legsOnly = posture == "legs";
  auto walker = walkerOf(job, root, world, *enumValue<Fidelity>(fidelity));
  if (!walker) return walker.error();
  SimulatedWalker& robot = **walker;
  MatrixErrors matrices;
  const auto images = static_cast<int>(SyntheticRobot::imagesPerMinute * job.number("minutes"));
  constexpr int second = SyntheticRobot::imagesPerMinute / 60;
  for (int i = 0; i < images; ++i) {
    robot.step();
    if (robot.hasFallen()) return Error{.what = fallen};
    if (i < 2 * second) continue;
    matrices.add(robot.camera, robot.trueCamera);
  }
  Measurement run;
  matrices.addTo(run, "realism.matrix." + fidelity + "." + gait + "." + posture);
  return run;
}

/// What the lines that a robot sees say of its camera matrices, by the estimator that looks at the
/// real robot's log: it is told where each line really is in the image.
Result<Measurement> fitMatrices(const Job& job, const DataRoot& root) {
  auto walker = walkerOf(job, root);
  if (!walker) return walker.error();
  SimulatedWalker& robot = **walker;
  constexpr int every = 10;
  constexpr double spacing = 8;  // pixels
  const MatrixFit fit{robot.field};
  std::vector<double> checked, tilt, roll;
  MatrixErrors truth;
  const auto images = static_cast<int>(SyntheticRobot::imagesPerMinute * job.number("minutes"));
  for (int i = 0; i < images; ++i) {
    robot.step();
    if (i % every != 0 || !robot.camera.valid) continue;
    const auto lines = linesInImage(fit.linePoints(), robot.trueCamera, robot.pose, spacing);
    const auto correction = fit.fit(robot.camera, lines);
    checked.push_back(correction ? 100 : 0);
    if (!correction) continue;
    tilt.push_back(toDegrees(std::abs(correction->tilt)));
    roll.push_back(toDegrees(std::abs(correction->roll)));
    truth.add(robot.camera, robot.trueCamera);
  }
  Measurement run;
  run.add("realism.fit.checked", "%", mean(checked));
  if (tilt.empty()) return run;
  run.add("realism.fit.tilt.mean", "deg", mean(tilt));
  run.add("realism.fit.tilt.p95", "deg", quantile(tilt, 0.95));
  run.add("realism.fit.roll.mean", "deg", mean(roll));
  run.add("realism.fit.roll.p95", "deg", quantile(roll, 0.95));
  truth.addTo(run, "realism.fit.truth");
  return run;
}

/// How the body of a robot sways that walks ahead, and how far its way is from what it believes, in
/// both fidelities: what the profile's numbers for the kinematic one are chosen by.
Result<Measurement> sway(const Job& job, const DataRoot& root) {
  constexpr double warmUp = 1.5, measured = 3;  // s
  constexpr int walks = 10;
  auto scene = loadScene(job, root);
  if (!scene) return scene.error();
  scene->fidelity = *enumValue<Fidelity>(job.parameter("fidelity"));
  scene->game.referee = false;
  scene->robots.resize(1);
  scene->balls.clear();
  auto made = MovedRobot::make(root, *scene, job.seed);
  if (!made) return made.error();
  MovedRobot& robot = **made;
  robot.standUp();
  Random random{Random{job.seed}.fork("sway")};
  RunningStatistics tilt, roll, height;
  double gone = 0, believed = 0, astray = 0;
  for (int i = 0; i < walks; ++i) {
    robot.request = {};
    // Along the field, where no wall is in the way.
    robot.world().placeRobot(0, {0.5 * random.symmetric(), -1600, 0});
    robot.run(0.5);
    robot.request.type = MotionType::walk;
    robot.request.walkType = *enumValue<WalkType>(job.parameter("type"));
    robot.request.walk = {random.uniform(-0.2, 0.2), job.number("speed"), 0};
    robot.run(warmUp);
    const Pose2D from = robot.body().pose, counted = robot.odometry().pose;
    for (double time = 0; time < measured; time += tickSeconds) {
      robot.step();
      tilt.add(toDegrees(robot.body().tilt));
      roll.add(toDegrees(robot.body().roll));
      height.add(robot.body().height);
      if (robot.hasFallen()) return Error{.what = fallen};
    }
    const Vector2d way = robot.body().pose.relativeTo(from).translation;
    const Vector2d ofOdometry = robot.odometry().pose.relativeTo(counted).translation;
    gone += way.norm();
    believed += ofOdometry.norm();
    astray += (way - ofOdometry).norm();
  }
  Measurement run;
  const std::string name = "realism.sway." + job.parameter("fidelity") + '.' +
                           job.parameter("type") + '.' + job.parameter("speed");
  run.add(name + ".tilt", "deg", tilt.standardDeviation());
  run.add(name + ".roll", "deg", roll.standardDeviation());
  run.add(name + ".height", "mm", height.standardDeviation());
  run.add(name + ".way", "%", 100 * gone / believed);
  run.add(name + ".astray", "%", 100 * astray / believed);
  return run;
}

}  // namespace

Experiments realismExperiments() {
  using enum Parameter::Kind;
  const Parameter profile = profileParameter();
  const Parameter changes = changeParameter();
  return {
      {"realism.fit",
       "What the lines in images say of their camera matrices",
       {profile, changes, {"minutes", "of walking", number, {"4"}}},
       fitMatrices},
      {"realism.goToPoint",
       "How precisely Lines reaches 68 points (report 3.3.3.4: 94 and 84 mm)",
       {profile, changes, {"points", "to reach", number, {"68"}}},
       goToPoint},
      {"realism.matrix",
       "How far the measured camera matrix is from the true one",
       {profile,
        changes,
        {"fidelity", "of the motion", each, {"kinematic", "dynamic"}},
        {"gait",
         "of the robot: it stands, walks (normal, 150 mm/s), or type and mm/s of its walk",
         each,
         {"stand", "walk", "normal.100", "normal.200", "normal.1000", "fast.100", "fast.200",
          "fast.1000"}},
        {"posture", "what tilt and roll follow from", each, {"legs", "fused"}},
        {"minutes", "that it takes images", number, {"4"}}},
       compareMatrices},
      {"realism.search",
       "Images until the robot is found (report, figure 3.8: 14 to 40, 13)",
       {profile, changes, {"trials", "of each kind", number, {"15"}}},
       searchItself},
      {"realism.sway",
       "How the body of a walking robot sways, and how far it gets, as a share of what it believes",
       {profile,
        changes,
        {"fidelity", "of the motion", each, {"kinematic", "dynamic"}},
        {"type", "of the walk", each, {"normal", "fast"}},
        {"speed", "mm/s; 1000 is as fast as it can", each, {"100", "200", "1000"}}},
       sway},
      {"realism.walk",
       "Errors of Lines during a walk of 18 minutes (report 3.3.3.4: 105 mm)",
       {profile,
        changes,
        {"fidelity", "of the motion", choice, {"kinematic", "dynamic"}},
        {"minutes", "of walking", number, {"18"}}},
       walkAbout}};
}

}  // namespace gt
