#include "modules/perception/processors/ImageDelay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/Random.h"

namespace gt {
namespace {

/// A robot that walks in a circle and looks from side to side, past a flag.
class LookingAround {
 public:
  /// How old its images are beyond their time stamp (s).
  double delay = 0.01;
  double noise = 0.02;  ///< rad
  ImageDelay learned;
  Pose2D odometry{0, 0, 0};

  void look(int images) {
    constexpr double widest = 0.6, speed = 1.5, interval = 0.04;  // rad, rad/s, s
    for (int i = 0; i < images; ++i) {
      odometry = odometry * Pose2D{0.01, 4, 0};
      matrix_.time = landmarks_.time = landmarks_.time + 40;
      matrix_.valid = true;
      const double phase = std::fmod(speed * interval * i / (4 * widest), 1.);
      matrix_.turning.z() = (phase < 0.5 ? speed : -speed) + 0.25;
      const Vector2d flag = relative(odometry, Vector2d{1500, 300});
      const double known = learned.milliseconds() / 1000;
      landmarks_.numberOfFlags = 1;
      landmarks_.flags[0].angle =
          angleOf(flag) + matrix_.turning.z() * (delay - known) + noise * random_.gaussian();
      landmarks_.flags[0].distance = flag.norm();
      learned.learn(landmarks_, matrix_, odometry, field_, 60000);
    }
  }

 private:
  LandmarksPercept landmarks_;
  CameraMatrix matrix_;
  FieldDimensions field_;
  Random random_{3};
};

// A camera that nods at 1 rad/s, up and down in turn, sees a flag's middle too high or too low.
TEST(ImageDelay, IsLearnedFromTheHeightOfAFlagWhileTheHeadNods) {
  const FieldDimensions field;
  for (const double delay : {0., 0.01, 0.02}) {
    ImageDelay learned;
    LandmarksPercept landmarks;
    CameraMatrix matrix;
    Random random{3};
    matrix.valid = true;
    matrix.pose.translation.z() = 190;
    for (int i = 0; i < 1000; ++i) {
      matrix.time = landmarks.time = landmarks.time + 200;
      const double upwards = i % 2 == 0 ? 1 : -1, distance = 1500;
      matrix.turning.y() = -upwards;
      const double known = learned.milliseconds() / 1000;
      const double off = upwards * (delay - known) + 0.02 * random.gaussian();
      landmarks.numberOfFlags = 1;
      FlagPercept& flag = landmarks.flags[0];
      flag.distance = distance;
      flag.boundary.top = std::atan2(field.flagTop - 190, distance) + off;
      flag.boundary.bottom = std::atan2(field.flagBottom - 190, distance) + off;
      flag.boundary.leftOnBorder = flag.boundary.rightOnBorder = false;
      flag.boundary.topOnBorder = flag.boundary.bottomOnBorder = false;
      learned.learn(landmarks, matrix, {}, field, 60000);
    }
    EXPECT_NEAR(learned.milliseconds(), 1000 * delay, 2.5);
  }
}

TEST(ImageDelay, IsLearnedFromFlagsWhileTheHeadTurns) {
  for (const double delay : {0., 0.01, 0.02}) {
    LookingAround robot;
    robot.delay = delay;
    robot.look(60 * 25);
    EXPECT_NEAR(robot.learned.milliseconds(), 1000 * delay, 2.5);
  }
}

TEST(ImageDelay, ChangesWithTheCamera) {
  LookingAround robot;
  robot.look(60 * 25);
  robot.delay = 0.03;
  robot.look(240 * 25);
  EXPECT_NEAR(robot.learned.milliseconds(), 30, 3);
}

TEST(ImageDelay, IsNotLearnedFromTheSameImageTwice) {
  ImageDelay delay;
  LandmarksPercept landmarks;
  CameraMatrix matrix;
  matrix.valid = true;
  landmarks.numberOfFlags = 1;
  landmarks.flags[0].distance = 1000;
  for (int i = 0; i < 100; ++i) {
    matrix.turning.z() = i;
    landmarks.flags[0].angle = 0.05 * i;
    delay.learn(landmarks, matrix, {}, {}, 60000);
  }
  EXPECT_EQ(delay.milliseconds(), 0);
}

}  // namespace
}  // namespace gt
