#include "modules/motion/head/GT2003HeadControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modules/kinematics/BodyPosture.h"

namespace gt {
namespace {

/// A robot that stands, whose head follows what is requested, and a ball that it sees or not.
struct Head {
  GT2003HeadControl control;
  HeadControlMode mode;
  BallModel ball;
  SensorDataBuffer sensors;
  RobotDimensions robot;
  RobotCalibration calibration;
  FrameInfo frame{{10000}};
  HeadMotionRequest request;
  double fastest = 0;
  double tiltSpeed = 2.1;  ///< rad/s

  explicit Head(HeadMode headMode) { mode.mode = headMode; }

  JointAngles& joints() { return sensors.frames.back().joints; }
  Pose3D camera() {
    return cameraPose(robot, bodyPose(bodyPosture(robot, joints())),
                      {request.tilt, request.pan, request.roll});
  }
  /// Where a point of the robot's system is seen; far outside if it is behind the camera.
  Vector2d seen(const Vector3d& point) {
    const Vector3d inCamera = camera().inverse() * point;
    return inCamera.x() > 1 ? CameraInfo{}.project(inCamera) : Vector2d{-1000, -1000};
  }
  void frameWith(std::optional<Vector2d> visibleBall) {
    frame.time.ms += 8;
    if (visibleBall) {
      const auto at = seen({visibleBall->x(), visibleBall->y(), 43});
      if (CameraInfo{}.contains(at.x(), at.y())) {
        ball.consecutiveTimeSeen += 8;
        ball.lastSeen = frame.time;
        ball.position = *visibleBall;
      } else {
        ball.consecutiveTimeSeen = 0;
      }
    } else {
      ball.consecutiveTimeSeen = 0;
    }
    const double tilt = request.tilt, pan = request.pan;
    control.update(mode, ball, sensors, robot, calibration, frame, request);
    // What MotionControl lets through.
    request.tilt = std::clamp(request.tilt, tilt - tiltSpeed * 0.008, tilt + tiltSpeed * 0.008);
    request.pan = std::clamp(request.pan, pan - 3 * 0.008, pan + 3 * 0.008);
    fastest = std::max(fastest, std::hypot(request.tilt - tilt, request.pan - pan) / 0.008);
    joints()[Joint::headTilt] = request.tilt;
    joints()[Joint::headPan] = request.pan;
  }
  void frames(int n, const std::optional<Vector2d>& visibleBall = std::nullopt) {
    for (int i = 0; i < n; ++i) frameWith(visibleBall);
  }
};

const CameraInfo camera;

TEST(GT2003HeadControl, LooksAtAPoint) {
  for (const Vector3d& point : {Vector3d{800, 300, 43}, Vector3d{2000, -500, 300}}) {
    Head head{HeadMode::lookAtPoint};
    head.mode.point = point;
    head.frames(150);
    EXPECT_LT((head.seen(point) - Vector2d{camera.centerX, camera.centerY}).norm(), 0.5);
  }
}

TEST(GT2003HeadControl, SeesAPointAtAPixel) {
  for (const Vector2d& pixel : {Vector2d{20, 120}, Vector2d{160, 110}, Vector2d{100, 30}}) {
    Head head{HeadMode::lookAtPoint};
    head.mode.point = {1000, 200, 43};
    head.mode.pixel = pixel;
    head.frames(150);
    EXPECT_LT((head.seen(head.mode.point) - pixel).norm(), 0.5) << pixel.transpose();
  }
}

TEST(GT2003HeadControl, ScansFromLeftToRightAndBackWithTheTiltThatIsWanted) {
  Head head{HeadMode::scanLeftRight};
  head.mode.scanTilt = -0.5;
  head.mode.scanRange = 0.8;
  head.frames(100);
  double leftmost = 0, rightmost = 0;
  int turns = 0, side = 0;
  head.fastest = 0;
  for (int i = 0; i < 1000; ++i) {
    head.frameWith(std::nullopt);
    leftmost = std::max(leftmost, head.request.pan);
    rightmost = std::min(rightmost, head.request.pan);
    EXPECT_NEAR(head.request.tilt, -0.5, 1e-9);
    const int now = head.request.pan > 0.79 ? 1 : head.request.pan < -0.79 ? -1 : 0;
    if (now != 0 && now != side) ++turns;
    if (now != 0) side = now;
  }
  EXPECT_NEAR(leftmost, 0.8, 0.001);
  EXPECT_NEAR(rightmost, -0.8, 0.001);
  EXPECT_NEAR(turns, 10, 1);  // 8 s, of which each way takes 0.8 s
  EXPECT_NEAR(head.fastest, head.control.parameters.scanSpeed, 0.05);
  head.mode.scanTilt = 0;
  head.frames(100);
  EXPECT_NEAR(head.request.tilt, 0, 1e-9);
}

TEST(GT2003HeadControl, StaysWhereItIsTurnedByHand) {
  Head head{HeadMode::lookAtPoint};
  head.mode.point = {800, 300, 43};
  head.frames(150);
  head.mode.mode = HeadMode::stayAsForced;
  const double before = head.request.pan;
  // What a weight does to the joint is no wish: the motor keeps its target.
  head.joints()[Joint::headPan] = before - 0.04;
  head.control.update(head.mode, head.ball, head.sensors, head.robot, head.calibration, head.frame,
                      head.request);
  EXPECT_NEAR(head.request.pan, before, 1e-9);
  for (const double turned : {before - 0.5, before + 0.7}) {
    head.joints()[Joint::headPan] = turned;
    head.joints()[Joint::headRoll] = 0.3;
    head.control.update(head.mode, head.ball, head.sensors, head.robot, head.calibration,
                        head.frame, head.request);
    EXPECT_NEAR(head.request.pan, turned, 0.051);
    EXPECT_NEAR(head.request.roll, 0.3, 0.051);
  }
  head.joints()[Joint::headPan] = head.request.pan;
  const auto left = head.request;
  head.frames(50);
  EXPECT_EQ(head.request.pan, left.pan);
  EXPECT_EQ(head.request.tilt, left.tilt);
}

TEST(GT2003HeadControl, LooksToTheSides) {
  Head head{HeadMode::lookLeft};
  head.frames(150);
  EXPECT_GT(head.request.pan, 1.4);
  head.mode.mode = HeadMode::lookRight;
  head.frames(150);
  EXPECT_LT(head.request.pan, -1.4);
  head.mode.mode = HeadMode::lookStraightAhead;
  head.frames(150);
  EXPECT_NEAR(head.request.pan, 0, 1e-9);
  head.mode.mode = HeadMode::none;
  const auto before = head.request;
  head.frames(50);
  EXPECT_EQ(head.request.pan, before.pan);
}

TEST(GT2003HeadControl, SearchForBallFindsItWhereverItLies) {
  for (const Vector2d& ball : {Vector2d{300, 0}, Vector2d{250, 150}, Vector2d{600, -500},
                               Vector2d{200, 900}, Vector2d{2500, 600}, Vector2d{230, -100}}) {
    Head head{HeadMode::searchForBall};
    int frames = 0;
    while (head.ball.consecutiveTimeSeen < 200 && frames < 700) {
      head.frameWith(ball);
      ++frames;
    }
    EXPECT_LT(frames, 600) << ball.x() << " " << ball.y();
    head.frames(200, ball);
    EXPECT_EQ(head.ball.lastSeen, head.frame.time);
    EXPECT_LT((head.seen({ball.x(), ball.y(), 43}) - Vector2d{88, 72}).norm(), 12);
  }
}

TEST(GT2003HeadControl, SearchesABallThatWasNearAmongNearPlacesFirst) {
  const auto tiltInSearchOf = [](const Vector2d& ball) {
    Head head{HeadMode::searchForBall};
    head.frames(500, ball);
    head.frames(100);  // it is gone, and lost after 400 ms
    return head.request.tilt;
  };
  EXPECT_LT(tiltInSearchOf({450, 100}), -0.7);
  EXPECT_GT(tiltInSearchOf({550, 100}), -0.4);
}

TEST(GT2003HeadControl, FindsABallThatWasNearAtItsChestAtItsPawsAndFarAway) {
  const auto framesUntilFound = [](const Vector2d& ball) {
    Head head{HeadMode::searchForBall};
    head.frames(500, Vector2d{300, 150});
    head.frames(50);  // it is gone, and lost after 400 ms
    int frames = 0;
    while (head.ball.consecutiveTimeSeen == 0 && frames < 1000) {
      head.frameWith(ball);
      ++frames;
    }
    return frames;
  };
  EXPECT_LT(framesUntilFound({150, 0}), 150);
  EXPECT_LT(framesUntilFound({150, 120}), 150);
  EXPECT_LT(framesUntilFound({180, -130}), 250);
  EXPECT_LT(framesUntilFound({900, -300}), 500);
  EXPECT_LT(framesUntilFound({1500, 1000}), 600);
}

TEST(GT2003HeadControl, SearchAutoScansBesideTheBallToBothSidesInTurn) {
  Head head{HeadMode::searchAuto};
  const Vector2d ball{700, 50};
  head.frames(300, ball);
  double leftmost = 0, rightmost = 0;
  int away = 0, longestAway = 0;
  std::vector<int> sides;
  for (int i = 0; i < 800; ++i) {
    head.frameWith(ball);
    const double offset = head.request.pan - std::atan2(50, 600);
    leftmost = std::max(leftmost, offset);
    rightmost = std::min(rightmost, offset);
    const bool off = std::abs(offset) > 0.15;
    away = off ? away + 1 : 0;
    longestAway = std::max(longestAway, away);
    if (away == 20) sides.push_back(offset > 0 ? 1 : -1);
  }
  EXPECT_GT(leftmost, 0.6);
  EXPECT_LT(rightmost, -0.6);
  EXPECT_LE(longestAway * 8, 880);
  ASSERT_GE(sides.size(), 4u);
  for (std::size_t i = 1; i < sides.size(); ++i) EXPECT_NE(sides[i], sides[i - 1]);
  EXPECT_LT(head.frame.time - head.ball.lastSeen, 900);
}

TEST(GT2003HeadControl, SearchAutoKeepsItsEyesOnABallThatRollsNear) {
  const auto widest = [](const Vector2d& ball, double speed) {
    Head head{HeadMode::searchAuto};
    head.ball.speed = {-speed, 0};
    head.frames(300, ball);
    double most = 0;
    for (int i = 0; i < 400; ++i) {
      head.frameWith(ball);
      most = std::max(most, std::abs(head.request.pan - std::atan2(ball.y(), ball.x())));
    }
    return most;
  };
  EXPECT_LT(widest({700, 50}, 600), 0.1);
  EXPECT_GT(widest({700, 50}, 60), 0.5) << "it hardly rolls";
  EXPECT_GT(widest({2000, 50}, 600), 0.5) << "it is far away";
}

TEST(GT2003HeadControl, IsBackInTimeFromAScanBesideABallRightBeforeTheRobot) {
  Head head{HeadMode::searchAuto};
  head.tiltSpeed = 1.7;  // a weak servo
  const Vector2d ball{200, 0};
  head.frames(300, ball);
  int away = 0, longestAway = 0;
  for (int i = 0; i < 800; ++i) {
    head.frameWith(ball);
    const bool off = (head.seen({ball.x(), ball.y(), 43}) - Vector2d{88, 72}).norm() > 5;
    away = off ? away + 1 : 0;
    longestAway = std::max(longestAway, away);
  }
  EXPECT_LE(longestAway * 8, 880);
  EXPECT_GT(longestAway * 8, 700);
}

TEST(GT2003HeadControl, SearchAutoLooksAtTheBallBeforeItScansAndSearchesALostBall) {
  Head head{HeadMode::searchAuto};
  const Vector2d ball{700, 0};
  head.frames(500, ball);
  head.mode.mode = HeadMode::lookAtPoint;
  head.mode.point = {700, 0, 43};
  head.frames(100, ball);
  head.mode.mode = HeadMode::searchAuto;
  head.frames(37, ball);  // 296 ms
  EXPECT_NEAR(head.request.pan, 0, 0.05);
  head.frames(400);  // the ball is gone
  double widest = 0;
  for (int i = 0; i < 400; ++i) {
    head.frameWith(std::nullopt);
    widest = std::max(widest, std::abs(head.request.pan));
  }
  EXPECT_GT(widest, 1.3);
}

TEST(GT2003HeadControl, ScansSlowlyEnoughForImages) {
  for (const auto mode : {HeadMode::searchForLandmarks, HeadMode::searchForBall}) {
    Head head{mode};
    head.frames(1500);
    EXPECT_LT(head.fastest, 2.2) << enumName(mode);
    EXPECT_GT(head.fastest, 1.0) << enumName(mode);
  }
}

TEST(GT2003HeadControl, SearchForLandmarksSweepsTheHorizon) {
  Head head{HeadMode::searchForLandmarks};
  double leftmost = 0, rightmost = 0;
  for (int i = 0; i < 1000; ++i) {
    head.frameWith(std::nullopt);
    leftmost = std::max(leftmost, head.request.pan);
    rightmost = std::min(rightmost, head.request.pan);
    EXPECT_GT(head.request.tilt, -0.5);
  }
  EXPECT_GT(leftmost, 1.4);
  EXPECT_LT(rightmost, -1.4);
}

}  // namespace
}  // namespace gt
