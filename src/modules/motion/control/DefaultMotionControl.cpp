#include "modules/motion/control/DefaultMotionControl.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"

namespace gt {
namespace {

constexpr double frameTime = 0.008;  // s
constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

/// Carries out a tail request: swings, or jumps from end to end (wagLeftRight).
void setTail(JointAngles& angles, TailRequest request, Time now) {
  constexpr double widest = 0.38;  // rad
  const auto swing = [&](double seconds) {
    return widest * std::sin(2 * pi * static_cast<double>(now.ms) / 1000 / seconds);
  };
  double& pan = angles[Joint::tailPan];
  double& tilt = angles[Joint::tailTilt];
  pan = tilt = 0;
  switch (request) {
    case TailRequest::noTailWag:
      break;
    case TailRequest::wagHorizontal:
      pan = swing(1);
      break;
    case TailRequest::wagVertical:
      tilt = swing(1);
      break;
    case TailRequest::wagLeftRightHorizontal:
      pan = swing(2) < 0 ? -widest : widest;
      break;
    case TailRequest::wagLeftRightVertical:
      tilt = swing(2) < 0 ? -widest : widest;
      break;
    case TailRequest::wagHorizontalFast:
      pan = swing(0.4);
      break;
    case TailRequest::wagVerticalFast:
      tilt = swing(0.4);
      break;
    case TailRequest::tailFollowsHead:
      pan = std::clamp(angles[Joint::headPan], -widest, widest);
      break;
  }
}

double approach(double from, double to, double speed) {
  return from + std::clamp(to - from, -speed * frameTime, speed * frameTime);
}

void setHead(JointAngles& angles, const HeadMotionRequest& head) {
  angles[Joint::headTilt] = head.tilt;
  angles[Joint::headPan] = head.pan;
  angles[Joint::headRoll] = head.roll;
  angles[Joint::mouth] = head.mouth;
}

HeadMotionRequest headOf(const JointAngles& angles) {
  return {angles[Joint::headTilt], angles[Joint::headPan], angles[Joint::headRoll],
          angles[Joint::mouth]};
}

/// Angles that the motors can take: within their limits, and with the legs beside the body.
void keepWithinLimits(JointAngles& angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto limits = limitsOf(static_cast<Joint>(i));
    angles.values[i] = std::clamp(angles.values[i], limits.low, limits.high);
  }
  for (const auto leg : legs)
    angles[legJoint(leg, 2)] =
        std::max(angles[legJoint(leg, 2)], leastElevator(leg, angles[legJoint(leg, 1)]));
}

}  // namespace

void DefaultMotionControl::update(const FrameInfo& frame, const MotionRequest& request,
                                  const WalkingEngineOutput& walking,
                                  const SpecialActionsOutput& special,
                                  const HeadMotionRequest& head, JointData& joints,
                                  OdometryData& odometry, MotionInfo& info) {
  const MotionRequest& wanted = request.validAt(frame.time);
  choose(wanted, walking, special);

  JointAngles target = angles_;
  setHead(target, head);
  Pose2D step;
  if (special_) {
    for (std::size_t i = 0; i < target.size(); ++i)
      if (!special.dontCare.values[i]) target.values[i] = special.joints.angles.values[i];
    step = special.odometryStep;
  } else {
    for (const auto leg : legs) setLeg(target, leg, legOf(walking.joints.angles, leg));
    if (walking.holdsHead) setHead(target, headOf(walking.joints.angles));
    setTail(target, wanted.tail, frame.time);
    step = walking.odometryStep;
  }
  keepWithinLimits(target);
  protect(target);
  odometry_ = odometry_ * step;

  joints.angles = angles_;
  odometry.pose = odometry_;
  report(wanted, walking, special, info);
}

void DefaultMotionControl::choose(const MotionRequest& wanted, const WalkingEngineOutput& walking,
                                  const SpecialActionsOutput& special) {
  const bool wantsSpecial = !specialActionOf(wanted).empty();
  const bool mayLeave = special_ ? special.mayLeave : walking.mayLeave;
  if (wantsSpecial == special_ || !mayLeave) return;
  special_ = wantsSpecial;
  changing_ = !special_;  // special actions come from where the joints are by themselves
}

void DefaultMotionControl::protect(const JointAngles& target) {
  const JointAngles before = angles_;
  angles_ = target;
  const auto slow = [&](Joint joint, double speed) {
    angles_[joint] = approach(before[joint], target[joint], speed);
  };
  slow(Joint::headTilt, parameters.headTiltSpeed);
  slow(Joint::headPan, parameters.headPanSpeed);
  slow(Joint::headRoll, parameters.headRollSpeed);
  if (!changing_) return;
  changing_ = false;
  for (const auto leg : legs)
    for (int number = 1; number <= 3; ++number) {
      const Joint joint = legJoint(leg, number);
      slow(joint, parameters.changeSpeed);
      if (angles_[joint] != target[joint]) changing_ = true;
    }
  if (!changing_ && settling_ > 0) {
    --settling_;
    changing_ = true;
  }
}

void DefaultMotionControl::report(const MotionRequest& wanted, const WalkingEngineOutput& walking,
                                  const SpecialActionsOutput& special, MotionInfo& info) const {
  static const MotionRequest nothing;
  info.executed = nothing;
  if (special_) {
    // In the first frame there is no action yet: the net begins with the next one.
    const auto& action = special.action;
    info.executed.type = action == getupAction ? MotionType::getup : MotionType::specialAction;
    info.executed.specialAction = action;
    info.stable = action == standAction;
  } else {
    const bool stands = wanted.type != MotionType::walk && walking.speed.rotation == 0 &&
                        walking.speed.translation == Vector2d::Zero();
    info.executed.type = stands ? MotionType::stand : MotionType::walk;
    info.executed.walkType = walking.walkType;
    info.executed.walk = walking.speed;
    info.stable = true;
  }
  info.positionInWalkCycle = walking.positionInWalkCycle;
  info.arriving = changing_;
}

}  // namespace gt
