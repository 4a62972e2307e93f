// Has robots look at a checkerboard that do not know how their bodies lean nor how wide their
// cameras see, and compares what they find out with the truth.
#include <algorithm>
#include <map>
#include <memory>

#include "Experiments.h"
#include "InParallel.h"
#include "Tally.h"
#include "modules/perception/calibration/CheckerboardDetector.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "simulation/Simulation.h"

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
    sensorDataProcessor_.update({input.now}, input.sensors, image, RobotDimensions{},
                                RobotCalibration{}, MotionInfo{}, OdometryData{}, matrix_, body_,
                                psd_);
    detector_.update(image, matrix_, input.sensors, RobotDimensions{}, RobotCalibration{}, ball_,
                     landmarks_, lines_, players_, obstacles_, debug_);
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
  BallPercept ball_;
  LandmarksPercept landmarks_;
  LinesPercept lines_;
  PlayersPercept players_;
  ObstaclesPercept obstacles_;
  Debug debug_{1 << 16};
  int found_ = 0, pictures_ = 0;
};

Result<Tally> calibrate(std::uint64_t seed) {
  constexpr int mostTicks = 240 * 125;
  auto scene = loadScene("scenes/checkerboard.scene");
  if (!scene) return scene.error();
  Random random{Random{seed}.fork("calibration")};
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
  auto simulation = Simulation::make(*scene, seed);
  if (!simulation) return simulation.error();
  auto controller = std::make_unique<Watcher>(believed, seed);
  const Watcher& watcher = *controller;
  (*simulation)->attach(0, std::move(controller));
  for (int i = 0; i < mostTicks && watcher.calibration().pictures == 0; ++i) (*simulation)->step();
  Tally tally;
  const CameraCalibration& found = watcher.calibration();
  tally.count("done", found.pictures > 0);
  tally.measure("board", "%", watcher.foundShare());
  if (found.pictures == 0) return tally;
  const auto degrees = [&](const char* name, double value, double truth) {
    tally.measure(name, "deg", std::abs(toDegrees(value - truth)));
  };
  degrees("openingAngleX", found.openingAngleX, camera.openingAngleX());
  degrees("openingAngleY", found.openingAngleY, camera.openingAngleY());
  degrees("openingAngleX.before", believed.openingAngleX(), camera.openingAngleX());
  degrees("openingAngleY.before", believed.openingAngleY(), camera.openingAngleY());
  degrees("bodyTilt", found.body.bodyTiltOffset, fromDegrees(robot.bodyTilt));
  degrees("bodyRoll", found.body.bodyRollOffset, fromDegrees(robot.bodyRoll));
  degrees("bodyTilt.before", 0, fromDegrees(robot.bodyTilt));
  degrees("bodyRoll.before", 0, fromDegrees(robot.bodyRoll));
  tally.measure("corners", "pixel", found.error);
  return tally;
}

}  // namespace

Result<void> measureCalibration(Figures& figures, const ExperimentOptions& options) {
  std::vector<Result<Tally>> results(options.seeds.size(), Tally{});
  inParallel(results.size(), [&](std::size_t i) { results[i] = calibrate(options.seeds[i]); });
  std::vector<double> done;
  std::map<std::string, std::pair<std::string, std::vector<double>>> errors;
  for (const auto& result : results) {
    if (!result) return result.error();
    done.push_back(result->rates.at("done").percent());
    for (const auto& [name, list] : result->errors) {
      errors[name].first = list.unit;
      errors[name].second.push_back(list.values.front());
    }
  }
  figures.add("vision.calibration.done", "%", done, Aim::atLeast(100));
  for (const auto& [name, list] : errors) {
    const bool error = list.first == "deg" && !name.ends_with(".before");
    figures.add("vision.calibration." + name, list.first, list.second,
                error ? Aim::atMost(0.3) : Aim{});
  }
  return {};
}

}  // namespace gt
