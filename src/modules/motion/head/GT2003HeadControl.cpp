#include "modules/motion/head/GT2003HeadControl.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/BodyPosture.h"

namespace gt {
namespace {

constexpr double ballRadius = 43;

/// The requested angle, or the measured one if the joint was turned away from it by more than the
/// tolerance.
double forced(double requested, double measured, double tolerance) {
  return std::clamp(requested, measured - tolerance, measured + tolerance);
}

}  // namespace

void GT2003HeadControl::update(const HeadControlMode& mode, const BallModel& ball,
                               const SensorDataBuffer& sensors, const RobotDimensions& robot,
                               const RobotCalibration& calibration, const FrameInfo& frame,
                               HeadMotionRequest& request) {
  const auto& joints = sensors.newest().joints;
  const auto posture = bodyPosture(robot, calibration, joints);
  const auto body = bodyPose(posture);
  const CameraInfo camera;
  const Vector3d ballPoint{ball.position.x(), ball.position.y(), ballRadius};
  const Situation situation{
      ball,
      frame.time,
      body,
      posture.tilt,
      lookAt(robot, body, ballPoint, camera, {camera.centerX, camera.centerY}),
      {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]}};
  const double ahead = parameters.aheadTilt - posture.tilt;
  switch (mode.mode) {
    case HeadMode::none:  // as it is, or as a person wants it (report I.5.3: hmr)
      enter(State::idle, frame.time);
      head_ = {request.tilt, request.pan, request.roll};
      return;
    case HeadMode::stayAsForced:
      enter(State::idle, frame.time);
      stayAsForced(joints, request);
      head_ = {request.tilt, request.pan, request.roll};
      return;
    case HeadMode::lookAtPoint:
      enter(State::idle, frame.time);
      head_ = lookAt(robot, body, mode.point, camera, mode.pixel);
      break;
    case HeadMode::lookStraightAhead:
    case HeadMode::lookLeft:
    case HeadMode::lookRight:
      enter(State::idle, frame.time);
      head_ = {ahead, 0, 0};
      if (mode.mode == HeadMode::lookLeft) head_.pan = widestPan;
      if (mode.mode == HeadMode::lookRight) head_.pan = -widestPan;
      break;
    case HeadMode::searchForLandmarks:
      head_ = searchForLandmarks(situation);
      break;
    case HeadMode::scanLeftRight:
      head_ = scanLeftRight(mode, situation);
      break;
    case HeadMode::searchForBall:
    case HeadMode::searchAuto:
      head_ = lookForBall(situation, mode.mode == HeadMode::searchAuto);
      break;
  }
  request = {head_.tilt, head_.pan, head_.roll, 0};
}

void GT2003HeadControl::enter(State state, Time now) {
  if (state == state_) return;
  state_ = state;
  entered_ = now;
}

bool GT2003HeadControl::ballSeen(const Situation& s) const {
  return s.now - s.ball.lastSeen < parameters.ballLostAfter;
}

HeadAngles GT2003HeadControl::lookForBall(const Situation& s, bool scanBesides) {
  switch (state_) {
    case State::lookAtBall:
      return lookAtBall(s, scanBesides);
    case State::scanBesideBall:
      // Out and back within the scan's time; then the ball must be there again.
      if (!path_.finished() && scanBesides) return path_.next();
      enter(State::lookAtBall, s.now);
      return s.ballAngles;
    case State::searchForBall:
      return searchForBall(s);
    default:
      if (!ballSeen(s)) return searchForBall(s);
      enter(State::lookAtBall, s.now);
      return s.ballAngles;
  }
}

HeadAngles GT2003HeadControl::lookAtBall(const Situation& s, bool scanBesides) {
  // A scan has kept the eyes off the ball: it gets the time to be seen again.
  const bool lookedLongEnough = s.now - entered_ >= parameters.ballLostAfter;
  if (!ballSeen(s) && lookedLongEnough) return searchForBall(s);
  const bool sure = ballSeen(s) && s.now - entered_ >= parameters.ballSeenBeforeScan &&
                    s.ball.consecutiveTimeSeen >= parameters.ballSeenBeforeScan;
  const bool rolls = s.ball.speed.norm() > parameters.rollingSpeed &&
                     s.ball.position.norm() < parameters.rollingNear;
  const auto glance = scanBesides && sure && !rolls ? chooseGlance(s) : std::nullopt;
  if (!glance) return s.ballAngles;
  enter(State::scanBesideBall, s.now);
  planScanBesideBall(s, *glance);
  return path_.next();
}

HeadAngles GT2003HeadControl::searchForBall(const Situation& s) {
  if (state_ == State::searchForBall && ballSeen(s)) {
    enter(State::lookAtBall, s.now);
    return s.ballAngles;
  }
  if (state_ != State::searchForBall) searchesNear_ = false;
  if (state_ != State::searchForBall || path_.finished()) planBallSearch(s);
  enter(State::searchForBall, s.now);
  return path_.next();
}

HeadAngles GT2003HeadControl::searchForLandmarks(const Situation& s) {
  if (state_ != State::searchForLandmarks || path_.finished()) planLandmarkSearch(s);
  enter(State::searchForLandmarks, s.now);
  return path_.next();
}

HeadAngles GT2003HeadControl::scanLeftRight(const HeadControlMode& mode, const Situation& s) {
  const bool begins =
      state_ != State::scanLeftRight || mode.scanTilt != scanTilt_ || mode.scanRange != scanRange_;
  if (begins || path_.finished()) {
    scanTilt_ = mode.scanTilt;
    scanRange_ = mode.scanRange;
    scanLeft_ = begins ? s.measured.pan > 0 : !scanLeft_;
    // The tilt is reached first and kept from there on (report 4.2.2).
    const HeadAngles start = begins ? s.measured : head_;
    const HeadAngles turned{scanTilt_, start.pan, 0},
        end{scanTilt_, scanLeft_ ? scanRange_ : -scanRange_, 0};
    const double way = std::abs(scanTilt_ - start.tilt) + std::abs(end.pan - start.pan);  // rad
    path_.plan(start, {turned, end}, 1000 * way / parameters.scanSpeed);
  }
  enter(State::scanLeftRight, s.now);
  return path_.next();
}

/// Controls the joints with feedback from the sensors, so that a head turned by hand stays there
/// (report J.5.4).
void GT2003HeadControl::stayAsForced(const JointAngles& measured,
                                     HeadMotionRequest& request) const {
  const double tolerance = parameters.forcedTolerance;
  request = {forced(request.tilt, measured[Joint::headTilt], tolerance),
             forced(request.pan, measured[Joint::headPan], tolerance),
             forced(request.roll, measured[Joint::headRoll], tolerance),
             forced(request.mouth, measured[Joint::mouth], tolerance)};
}

std::optional<GT2003HeadControl::Glance> GT2003HeadControl::chooseGlance(const Situation& s) {
  const double side = scanLeft_ ? 1 : -1;
  scanLeft_ = !scanLeft_;
  const double pan =
      std::clamp(s.ballAngles.pan + side * parameters.scanWidth, -widestPan, widestPan);
  return Glance{pan, static_cast<double>(parameters.scanTime)};
}

void GT2003HeadControl::planScanBesideBall(const Situation& s, const Glance& glance) {
  // From a ball right before the robot there is no time to get up to the horizon and back.
  const double rise = tiltSpeed * glance.duration / 2000;
  const double tilt = std::min(parameters.horizonTilt - s.bodyTilt, s.ballAngles.tilt + rise);
  const HeadAngles corner{(tilt + s.ballAngles.tilt) / 2,
                          s.ballAngles.pan + 0.3 * (glance.pan - s.ballAngles.pan), 0};
  path_.plan(s.measured, {corner, {tilt, glance.pan, 0}, s.ballAngles}, glance.duration);
}

void GT2003HeadControl::planBallSearch(const Situation& s) {
  // First on the side on which the ball was last.
  const double side = s.ball.position.y() < 0 ? -1 : 1;
  const double far = -0.2 - s.bodyTilt, near = -0.85 - s.bodyTilt;
  const bool wasNear = s.ball.lastSeen != never() && s.ball.position.norm() < parameters.searchNear;
  searchesNear_ = wasNear && !searchesNear_;
  if (searchesNear_) {
    // At the chest and the paws, then around them; if it is gone, the next round is for all.
    const double low = -1.2 - s.bodyTilt, around = -0.6 - s.bodyTilt;
    path_.plan(s.measured,
               {{low, 0.4 * side, 0},
                {low, 1.2 * side, 0},
                {low, -1.2 * side, 0},
                {around, -widestPan * side, 0},
                {around, widestPan * side, 0}},
               parameters.nearSearchTime);
  } else {
    path_.plan(s.measured,
               {{far, 0.4 * side, 0},
                {far, widestPan * side, 0},
                {near, 1.0 * side, 0},
                {near, -1.0 * side, 0},
                {far, -widestPan * side, 0},
                {far, 0, 0}},
               parameters.ballSearchTime);
  }
}

void GT2003HeadControl::planLandmarkSearch(const Situation& s) {
  const double side = s.measured.pan < 0 ? -1 : 1;
  const double tilt = parameters.horizonTilt - s.bodyTilt;
  path_.plan(s.measured,
             {{tilt, widestPan * side, 0},
              {tilt, -widestPan * side, 0},
              {tilt - 0.2, -0.9 * side, 0},
              {tilt - 0.2, 0.9 * side, 0}},
             parameters.landmarkSearchTime);
}

}  // namespace gt
