#include "modules/motion/head/ActiveVisionHeadControl.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/BodyPosture.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {
namespace {

constexpr double usable = 0.8;  ///< Share of the image in which a whole landmark is seen.

double halfWidth() {
  return usable * CameraInfo{}.openingAngleX() / 2;
}

double seconds(std::int64_t ms) {
  return static_cast<double>(ms) / 1000;
}

std::array<Vector2d, 10> landmarksOf(const FieldDimensions& field) {
  std::array<Vector2d, 10> landmarks;
  std::size_t count = 0;
  for (std::size_t i = 0; i < enumCount<FlagType>; ++i)
    landmarks[count++] = positionOf(static_cast<FlagType>(i), TeamColor::red, field);
  for (const double x : {-field.xGroundline, field.xGroundline})
    for (const double y : {-field.yGoal, field.yGoal}) landmarks[count++] = {x, y};
  return landmarks;
}

/// The loss of information (nats) on a position in the plane if its standard deviation grows.
double lost(double deviation, double growth) {
  return 2 * std::log1p(growth / deviation);
}

}  // namespace

void ActiveVisionHeadControl::update(const HeadControlMode& mode, const BallModel& ball,
                                     const RobotPose& pose, const PlayersCollection& players,
                                     const SensorDataBuffer& sensors, const RobotDimensions& robot,
                                     const RobotCalibration& calibration,
                                     const FieldDimensions& field, const FrameInfo& frame,
                                     HeadMotionRequest& request) {
  robot_ = pose.pose;
  validity_ = pose.validity;
  players_ = &players;
  landmarks_ = landmarksOf(field);
  remember(sensors.newest(), bodyPosture(robot, calibration, sensors.newest().joints).tilt,
           frame.time);
  GT2003HeadControl::parameters = parameters.modes;
  GT2003HeadControl::update(mode, ball, sensors, robot, calibration, frame, request);
  players_ = nullptr;
}

/// Records the directions and landmarks that the camera looks at, as often as it takes images.
void ActiveVisionHeadControl::remember(const SensorData& sensors, double bodyTilt, Time now) {
  constexpr std::int64_t imagePeriod = 40;  // ms
  if (remembered_ == never()) looked_.fill(never());
  const std::int64_t passed = remembered_ == never() ? imagePeriod : now - remembered_;
  if (passed < imagePeriod) return;
  remembered_ = now;
  pose_.pass(seconds(passed), parameters.pose);

  const double pan = sensors.joints[Joint::headPan];
  const double aboveMiddle = usable * CameraInfo{}.openingAngleY() / 2;
  if (sensors.joints[Joint::headTilt] + bodyTilt + aboveMiddle < 0) return;  // sees the ground only
  const Sweep image{pan - halfWidth(), pan + halfWidth()};
  for (const Vector2d& landmark : landmarks_)
    if (image.contains(directionOf(landmark))) pose_.see(robot_, landmark, parameters.pose);
  for (std::size_t i = 0; i < sectors; ++i) {
    const double direction = 2 * pi * static_cast<double>(i) / sectors;
    if (image.contains(normalize(direction - robot_.rotation))) looked_[i] = now;
  }
}

std::optional<GT2003HeadControl::Glance> ActiveVisionHeadControl::chooseGlance(const Situation& s) {
  if (validity_ < parameters.leastValidity) return GT2003HeadControl::chooseGlance(s);
  constexpr int steps = 6;
  std::optional<Glance> best;
  double bestRate = 0;
  const double up = parameters.modes.horizonTilt - s.bodyTilt - s.ballAngles.tilt;
  for (int step = -steps; step <= steps; ++step) {
    if (step == 0) continue;
    const double aside = parameters.modes.scanWidth * step / steps;
    const double pan = std::clamp(s.ballAngles.pan + aside, -widestPan, widestPan);
    const double there = std::max(std::hypot(pan - s.ballAngles.pan, up) / parameters.glanceSpeed,
                                  std::abs(up) / tiltSpeed);  // s
    const double duration = std::min(2000 * there, static_cast<double>(parameters.modes.scanTime));
    const Sweep sweep{std::min(pan, s.ballAngles.pan) - halfWidth(),
                      std::max(pan, s.ballAngles.pan) + halfWidth()};
    const double gain = worth(sweep, s.now) - ballLoss(s.ball, duration / 1000);
    // After each glance the ball has to be watched for a while.
    const double rate = gain / (duration + parameters.modes.ballSeenBeforeScan);
    if (rate <= bestRate) continue;
    bestRate = rate;
    best = Glance{pan, duration};
  }
  return best;
}

double ActiveVisionHeadControl::worth(const Sweep& sweep, Time now) const {
  return parameters.landmarkWeight * landmarkGain(sweep) +
         parameters.opponentWeight * opponentGain(sweep, now);
}

double ActiveVisionHeadControl::landmarkGain(const Sweep& sweep) const {
  std::array<Vector2d, std::tuple_size_v<decltype(landmarks_)>> seen;
  std::size_t count = 0;
  for (const Vector2d& landmark : landmarks_)
    if (sweep.contains(directionOf(landmark))) seen[count++] = landmark;
  return pose_.gain(robot_, {seen.data(), count}, parameters.pose);
}

double ActiveVisionHeadControl::opponentGain(const Sweep& sweep, Time now) const {
  constexpr double precision = 150;  // mm, of an opponent that was just seen
  constexpr double nearby = 1000;    // mm: farther ones matter less
  double gain = 0;
  for (const LocatedPlayer& opponent : players_->opponents) {
    if (!sweep.contains(directionOf(opponent.position))) continue;
    const double distance = (opponent.position - robot_.translation).norm();
    gain += nearby / std::max(distance, nearby) *
            lost(precision, parameters.opponentSpeed * seconds(now - opponent.lastSeen));
  }
  // Four opponents may be in any direction.
  constexpr double anywhere = 1000;  // mm
  for (std::size_t i = 0; i < sectors; ++i) {
    const double direction = 2 * pi * static_cast<double>(i) / sectors;
    if (!sweep.contains(normalize(direction - robot_.rotation))) continue;
    const double unseen = looked_[i] == never()
                              ? 1
                              : 1 - std::exp(-seconds(now - looked_[i]) / parameters.unseenAfter);
    gain += 4. / sectors * unseen * lost(precision, anywhere - precision);
  }
  return gain;
}

double ActiveVisionHeadControl::ballLoss(const BallModel& ball, double seconds) const {
  constexpr double least = 30, share = 0.1;  // mm: precision of a ball that is seen
  return parameters.ballWeight * lost(least + share * ball.position.norm(),
                                      seconds * (parameters.ballSpeed + ball.speed.norm()));
}

}  // namespace gt
