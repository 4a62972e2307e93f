// Has robots look at a checkerboard that do not know how their bodies lean nor how wide their
// cameras see, and compares what they find out with the truth.
#include <algorithm>
#include <memory>

#include "Experiments.h"
#include "Profiles.h"
#include "modules/perception/calibration/CheckerboardDetector.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "modules/perception/testing/FoundPercepts.h"
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
                                RobotCalibration{}, FieldDimensions{}, MotionInfo{}, OdometryData{},
                                Previous<LandmarksPercept>{percepts_.landmarks}, matrix_, body_,
                                psd_);
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

}  // namespace

Experiment calibrationExperiment() {
  return {"vision.calibration",
          "Opening angles and body offsets that robots find with a checkerboard",
          {profileParameter()},
          calibrateCamera};
}

}  // namespace gt
