#include "measure/worlds/GameViews.h"

#include <gmock/gmock.h>

#include "base/Hash.h"
#include "base/Statistics.h"
#include "measure/worlds/SimulatedWalker.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// By which angle a measured matrix tilts and rolls the camera wrongly (deg).
double leanError(const CameraMatrix& measured, const CameraMatrix& truth) {
  const Vector3d up = measured.pose.rotation.row(2), trueUp = truth.pose.rotation.row(2);
  return toDegrees(std::acos(std::clamp(up.dot(trueUp), -1., 1.)));
}

CameraMatrix measure(const GameView& view) {
  DefaultSensorDataProcessor processor;
  OdometryData odometry;
  BallPercept ball;
  LandmarksPercept landmarks;
  CameraMatrix matrix;
  LearnedCalibration learned;
  BodyPercept body;
  PsdPercept psd;
  for (const Time time : {view.image.time - tickMs, view.image.time}) {
    odometry.pose = odometry.pose * view.step;
    processor.update({time}, view.sensors, view.image, RobotDimensions{}, RobotCalibration{},
                     FieldDimensions{}, MotionInfo{}, odometry, Previous<BallPercept>{ball},
                     Previous<LandmarksPercept>{landmarks}, matrix, body, psd, learned);
  }
  return matrix;
}

bool headRests(const GameView& view) {
  const JointAngles &first = view.sensors.frames.front().joints,
                    &last = view.sensors.newest().joints;
  constexpr double moved = 0.03;  // rad, noise and play included
  return std::abs(first[Joint::headTilt] - last[Joint::headTilt]) < moved;
}

/// The speed that a robot believes to have, as it makes its body sway (mm/s).
double speedOf(const Pose2D& step) {
  return (step.translation.norm() + 100 * std::abs(step.rotation)) / tickSeconds;
}

/// The errors of robots that walk ahead, as a walker does most of the time.
std::vector<double> errorsOfViews(Profile profile) {
  std::vector<double> errors;
  SceneDescription scene = *loadScene(DataRoot{}.path("scenes/match.scene"));
  setProfile(scene, profile);
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    auto views = *GameViews::make(DataRoot{}, scene, seed);
    for (int i = 0; i < 60; ++i) {
      views.shuffle();
      for (std::size_t robot = 0; robot < views.world().activeRobots(); ++robot) {
        const GameView& view = views.look(robot, scene.camera);
        const double speed = speedOf(view.step);
        const bool ahead = view.step.translation.x() > 0.7 * view.step.translation.norm();
        if (ahead && speed > 120 && speed < 240 && headRests(view))
          errors.push_back(leanError(measure(view), view.camera));
      }
    }
  }
  return errors;
}

std::vector<double> errorsOfWalkers(Profile profile) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    auto walker = *SimulatedWalker::make(DataRoot{}, seed, {.profile = profile, .legsOnly = true});
    for (int i = 0; i < 10; ++i) walker->step();
    for (int i = 0; i < 60; ++i) {
      walker->step();
      errors.push_back(leanError(walker->camera, walker->trueCamera));
    }
  }
  return errors;
}

TEST(GameViews, CamerasErrAsMuchAsThoseOfRobotsThatWalkInASimulation) {
  for (const Profile profile : {Profile::benign, Profile::padova}) {
    const std::vector<double> views = errorsOfViews(profile);
    const std::vector<double> walkers = errorsOfWalkers(profile);
    ASSERT_GT(views.size(), 100u);
    EXPECT_NEAR(mean(views) / mean(walkers), 1, 0.15) << enumName(profile);
    EXPECT_NEAR(quantile(views, 0.95) / quantile(walkers, 0.95), 1, 0.2);
  }
}

TEST(GameViews, OdometryIsEachRobotsOwn) {
  constexpr double perfect = 1e-9;
  const SceneDescription scene = *loadScene(DataRoot{}.path("scenes/match.scene"));
  auto views = *GameViews::make(DataRoot{}, scene, 1);
  views.shuffle();
  const auto odometryOfAll = [&] {
    std::vector<Pose2D> odometry;
    for (std::size_t i = 0; i < views.world().activeRobots(); ++i)
      odometry.push_back(views.look(i, scene.camera).odometry);
    return odometry;
  };
  const std::vector<Pose2D> before = odometryOfAll();
  views.waitForImage();
  const std::vector<Pose2D> after = odometryOfAll();
  int walking = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Pose2D walked = after[i].relativeTo(before[i]);
    const Pose2D step = views.look(i, scene.camera).step;
    if (speedOf(step) == 0) {
      EXPECT_LT(walked.translation.norm(), perfect);
      continue;
    }
    ++walking;
    EXPECT_NEAR(walked.rotation, 5 * step.rotation, 0.01);
    EXPECT_LT((walked.translation - 5 * step.translation).norm(), 3);
  }
  EXPECT_GT(walking, 0);
}

/// All that some moments show to all robots.
std::uint64_t fingerprintOf(const SceneDescription& scene) {
  auto views = *GameViews::make(DataRoot{}, scene, 1);
  Fingerprint sum;
  for (int i = 0; i < 4; ++i) {
    views.shuffle();
    for (std::size_t robot = 0; robot < views.world().activeRobots(); ++robot) {
      const GameView& view = views.look(robot, scene.camera);
      sum.addBytes(view.image.pixels.data(), view.image.pixels.size() * sizeof(Pixel));
      const SensorData& sensors = view.sensors.newest();
      sum.add(sensors.joints.values.data(), enumCount<Joint>);
      sum.add(sensors.acceleration.data(), 3);
      for (const SensorData& frame : view.sensors.frames) sum.add(frame.psd);
    }
  }
  return sum.value();
}

TEST(GameViews, EachNumberOfAProfileThatRobotsNoticeActs) {
  SceneDescription benign = *loadScene(DataRoot{}.path("scenes/match.scene"));
  setProfile(benign, Profile::benign);
  benign.walking.bursts = 30;  // so that their numbers matter
  const std::uint64_t expected = fingerprintOf(benign);
  ASSERT_EQ(fingerprintOf(benign), expected);
  int numbers = 0;
  for (const ProfileNumber& number : profileTable()) {
    if (number.values[Profile::rough] == number.values[Profile::benign]) continue;
    SceneDescription scene = benign;
    bool noticed = false;
    forEachProfileElement(scene, [&](std::string_view element, auto& parameters) {
      if (element != number.element || element == "physics" || element == "radio") return;
      noticed = true;
      ASSERT_TRUE(setByPath(parameters, std::string{number.name},
                            std::to_string(number.values[Profile::rough])));
    });
    if (!noticed) continue;
    EXPECT_NE(fingerprintOf(scene), expected) << number.element << '/' << number.name;
    ++numbers;
  }
  EXPECT_GT(numbers, 30);
}

}  // namespace
}  // namespace gt
