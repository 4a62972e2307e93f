#include "modules/motion/control/DefaultMotionControl.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/Tasks.h"
#include "modules/motion/control/MotorLimits.h"
#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"

namespace gt {
namespace {

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

void setAngles(JointAngles& angles, const JointAngles& wanted,
               const EnumArray<Joint, bool>& dontCare) {
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (!dontCare.values[i]) angles.values[i] = wanted.values[i];
}

}  // namespace

void DefaultMotionControl::update(const FrameInfo& frame, const MotionRequest& request,
                                  const WalkingEngineOutput& walking,
                                  const SpecialActionsOutput& special,
                                  const GetupEngineOutput& getup, const HeadMotionRequest& head,
                                  JointData& joints, JointGains& gains, OdometryData& odometry,
                                  MotionInfo& info) {
  if (!begun_) {
    angles_ = joints.angles;
    odometry_ = odometry.pose;
    begun_ = true;
  }
  const MotionRequest& wanted = request.validAt(frame.time);
  choose(moverFor(wanted), mover_ == Mover::walkingEngine    ? walking.mayLeave
                           : mover_ == Mover::specialActions ? special.mayLeave
                                                             : getup.mayLeave);

  JointAngles target = angles_;
  setHead(target, head);
  Pose2D step;
  gains = {};
  if (mover_ == Mover::specialActions) {
    setAngles(target, special.joints.angles, special.dontCare);
    step = special.odometryStep;
    gains = special.gains;
  } else if (mover_ == Mover::getupEngine) {
    setAngles(target, getup.joints.angles, getup.dontCare);
    gains = getup.gains;
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
  report(wanted, walking, special, getup, info);
}

DefaultMotionControl::Mover DefaultMotionControl::moverFor(const MotionRequest& wanted) {
  if (wanted.type == MotionType::getup) return Mover::getupEngine;
  return specialActionOf(wanted).empty() ? Mover::walkingEngine : Mover::specialActions;
}

void DefaultMotionControl::choose(Mover wanted, bool mayLeave) {
  // A fallen robot leaves the walk at once.
  const bool falls = wanted == Mover::getupEngine && mover_ == Mover::walkingEngine;
  if (wanted == mover_ || !(mayLeave || falls)) return;
  mover_ = wanted;
  // Special actions interpolate from the present angles by themselves.
  changing_ = mover_ == Mover::walkingEngine;
}

void DefaultMotionControl::protect(const JointAngles& target) {
  const JointAngles before = angles_;
  angles_ = target;
  const auto slow = [&](Joint joint, double speed) {
    angles_[joint] = approach(before[joint], target[joint], speed);
  };
  const bool acts = mover_ == Mover::specialActions;
  slow(Joint::headTilt, acts ? parameters.actionSpeed : parameters.headTiltSpeed);
  slow(Joint::headPan, acts ? parameters.actionSpeed : parameters.headPanSpeed);
  slow(Joint::headRoll, acts ? parameters.actionSpeed : parameters.headRollSpeed);
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
                                  const SpecialActionsOutput& special,
                                  const GetupEngineOutput& getup, MotionInfo& info) const {
  static const MotionRequest nothing;
  info.executed = nothing;
  if (mover_ == Mover::specialActions) {
    // In the first frame there is no action yet: the net begins with the next one.
    info.executed.type = MotionType::specialAction;
    info.executed.specialAction = special.action;
    info.stable = special.action == standAction;
  } else if (mover_ == Mover::getupEngine) {
    info.executed.type = MotionType::getup;
    info.executed.specialAction = getup.action;
    info.stable = false;
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
