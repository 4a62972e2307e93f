// Has robots look at a checkerboard, or play, that do not know how their bodies lean nor how wide
// their cameras see, and compares what they find out with the truth.
#include <algorithm>
#include <memory>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "base/File.h"
#include "measure/worlds/GameViews.h"
#include "modules/perception/calibration/CheckerboardDetector.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "modules/perception/testing/FoundPercepts.h"
#include "simulation/Simulation.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// A robot that stands before the board, looks around, and believes something of its camera.
class Watcher : public RobotController {
 public:
  Watcher(const CameraInfo& believed, std::uint64_t seed) : believed_{believed}, random_{seed} {
    for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
      joints_[legJoint(leg, 1)] = isFore(leg) ? -0.1 : -0.25;
      joints_[legJoint(leg, 2)] = 0.1;
      joints_[legJoint(leg, 3)] = isFore(leg) ? 0.7 : 0.85;
    }
  }

  void cycle(const RobotInput& input, RobotOutput& output) override {
    constexpr int ticksBetween = 60, ticksToGetThere = 50;
    if (ticks_++ % ticksBetween == 0) {
      joints_[Joint::headTilt] = random_.uniform(-0.2, 0.15);
      joints_[Joint::headPan] = random_.uniform(-0.35, 0.35);
    }
    output.joints.angles = joints_;
    if (!input.image || ticks_ % ticksBetween < ticksToGetThere) return;
    Image image = *input.image;
    image.info = believed_;
    sensorDataProcessor_.update(
        {input.now}, input.sensors, image, RobotDimensions{}, RobotCalibration{}, FieldDimensions{},
        MotionInfo{}, OdometryData{}, Previous<BallPercept>{percepts_.ball},
        Previous<LandmarksPercept>{percepts_.landmarks}, matrix_, body_, psd_, learned_);
    detector_.update(image, matrix_, input.sensors, RobotDimensions{}, RobotCalibration{},
                     percepts_, debug_);
    found_ += detector_.corners().empty() ? 0 : 1;
    ++pictures_;
  }
  const CameraCalibration& calibration() const { return detector_.calibration(); }
  double foundShare() const { return 100.0 * found_ / std::max(pictures_, 1); }

 private:
  CameraInfo believed_;
  Random random_;
  JointAngles joints_;
  int ticks_ = 0;
  DefaultSensorDataProcessor sensorDataProcessor_;
  CheckerboardDetector detector_;
  CameraMatrix matrix_;
  BodyPercept body_;
  PsdPercept psd_;
  LearnedCalibration learned_;
  FoundPercepts percepts_;
  Debug debug_{1 << 16};
  int found_ = 0, pictures_ = 0;
};

Result<Measurement> calibrateCamera(const Job& job, const DataRoot& root) {
  constexpr int mostTicks = 240 * 125;
  auto scene = loadScene(job, root, "scenes/checkerboard.scene");
  if (!scene) return scene.error();
  Random random{Random{job.seed}.fork("calibration")};
  SceneRobot& robot = scene->robots.front();
  robot.x = random.uniform(-780, -620);
  robot.y = random.uniform(-60, 60);
  robot.rotation = random.uniform(-8, 8);
  robot.bodyTilt = random.uniform(-4, 4);
  robot.bodyRoll = random.uniform(-3, 3);
  const CameraInfo camera;
  CameraInfo believed;
  believed.focalX *= random.uniform(0.88, 1.12);
  believed.focalY *= random.uniform(0.88, 1.12);
  auto simulation = Simulation::make(*scene, job.seed);
  if (!simulation) return simulation.error();
  auto controller = std::make_unique<Watcher>(believed, job.seed);
  const Watcher& watcher = *controller;
  (*simulation)->attach(0, std::move(controller));
  for (int i = 0; i < mostTicks && watcher.calibration().pictures == 0; ++i) (*simulation)->step();
  Measurement measured;
  const std::string name = "vision.calibration.";
  const CameraCalibration& found = watcher.calibration();
  measured.add(name + "done", "%", found.pictures > 0 ? 100 : 0, Aim::atLeast(100));
  measured.add(name + "board", "%", watcher.foundShare());
  if (found.pictures == 0) return measured;
  const auto compare = [&](const char* what, double value, double before, double truth) {
    const auto error = [&](double v) { return std::abs(toDegrees(v - truth)); };
    measured.add(name + what, "deg", error(value), Aim::atMost(0.3));
    measured.add(name + what + ".before", "deg", error(before));
  };
  compare("openingAngleX", found.openingAngleX, believed.openingAngleX(), camera.openingAngleX());
  compare("openingAngleY", found.openingAngleY, believed.openingAngleY(), camera.openingAngleY());
  compare("bodyTilt", found.body.bodyTiltOffset, 0, fromDegrees(robot.bodyTilt));
  compare("bodyRoll", found.body.bodyRollOffset, 0, fromDegrees(robot.bodyRoll));
  measured.add(name + "corners", "pixel", found.error);
  return measured;
}

/// A root whose robots believe that their bodies lean by so much (rad) and that their legs are
/// longer than they are, by a share.
Result<std::unique_ptr<ChangedRoot>> mistaken(const DataRoot& root, double tilt, double roll,
                                              double longer) {
  auto changed = ChangedRoot::make(root, "");
  if (!changed) return changed;
  RobotDimensions robot;
  for (Vector3d* bone : {&robot.upperLeg, &robot.lowerLegFore, &robot.lowerLegHind})
    *bone *= 1 + longer;
  const DataRoot within = (*changed)->root();
  if (auto done = writeFile(within.path("config/dimensions.cfg"), writeConfig(robot)); !done)
    return done.error();
  if (auto done =
          writeFile(within.path("config/robot.cfg"), writeConfig(RobotCalibration{tilt, roll}));
      !done)
    return done.error();
  return changed;
}

/// Robots begin a match with wrong beliefs: how far the camera matrices are off in the mean of the
/// first seconds, and after a minute.
Result<Measurement> calibrateInPlay(const Job& job, const DataRoot& root) {
  constexpr double wrong = fromDegrees(3), longer = 0.05;
  constexpr double first = 15, minute = 60, during = 15;  // s
  const double tilt = job.seed % 2 == 0 ? wrong : -wrong, roll = job.seed % 4 < 2 ? wrong : -wrong;
  const auto changed = mistaken(root, tilt, roll, longer);
  if (!changed) return changed.error();
  MatchOptions options{(*changed)->root()};
  options.seed = job.seed;
  options.profile = job.parameter("profile");
  options.fidelity = job.parameter("fidelity");
  options.minutes = 2;
  auto match = Match::make(options);
  if (!match) return match.error();
  const Simulation& simulation = (*match)->simulation();
  struct Errors {
    RunningStatistics tilt, roll, height;
  };
  struct OfRobot {
    Time last = never();
    Errors before, after;
  };
  std::vector<OfRobot> robots((*match)->robots().size());
  for (double now = 0; now < minute + during;) {
    (*match)->step();
    now = static_cast<double>((*match)->time().ms) / 1000;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const auto* matrix = (*match)->robots()[i]->robot().provided<CameraMatrix>();
      if (!matrix || !matrix->valid || matrix->time == robots[i].last) continue;
      robots[i].last = matrix->time;
      if (now >= first && now < minute) continue;
      const std::size_t index = (*match)->robotIndex(i);
      const Pose3D truth =
          trueMatrix(simulation.lastView(index), simulation.world().robot(index).pose).pose;
      const Eigen::AngleAxisd turn(matrix->pose.rotation * truth.rotation.transpose());
      Errors& errors = now < first ? robots[i].before : robots[i].after;
      errors.tilt.add(toDegrees(turn.angle() * turn.axis().y()));
      errors.roll.add(toDegrees(turn.angle() * turn.axis().x()));
      errors.height.add(matrix->pose.translation.z() - truth.translation.z());
    }
  }
  Measurement measured;
  for (const auto& [name, errors] :
       {std::pair{"before", &OfRobot::before}, {"after", &OfRobot::after}}) {
    std::vector<double> tilts, rolls, heights;
    for (const OfRobot& robot : robots) {
      if ((robot.*errors).tilt.count() == 0) continue;
      tilts.push_back(std::abs((robot.*errors).tilt.mean()));
      rolls.push_back(std::abs((robot.*errors).roll.mean()));
      heights.push_back(std::abs((robot.*errors).height.mean()));
    }
    const std::string prefix = std::string{"vision.selfCalibration."} + name;
    measured.add(prefix + ".tilt", "deg", mean(tilts));
    measured.add(prefix + ".roll", "deg", mean(rolls));
    measured.add(prefix + ".height", "mm", mean(heights));
    measured.add(prefix + ".tilt.worst", "deg", quantile(tilts, 1));
    measured.add(prefix + ".roll.worst", "deg", quantile(rolls, 1));
  }
  return measured;
}

}  // namespace

Experiments calibrationExperiments() {
  return {{"vision.calibration",
           "Opening angles and body offsets that robots find with a checkerboard",
           {profileParameter()},
           calibrateCamera},
          {"vision.selfCalibration",
           "What is left in play of wrong beliefs of tilt, roll (3 degrees) and legs (5 % longer)",
           {profileParameter(), fidelityParameter()},
           calibrateInPlay}};
}

}  // namespace gt
