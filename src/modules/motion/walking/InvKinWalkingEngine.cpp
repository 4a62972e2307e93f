#include "modules/motion/walking/InvKinWalkingEngine.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

constexpr double frameTime = 0.008;  // s
constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

/// Where a body is after it has moved at a constant speed, along a line or an arc.
Pose2D motionDuring(const Pose2D& speed, double seconds) {
  const double angle = speed.rotation * seconds;
  const Vector2d way = speed.translation * seconds;
  if (std::abs(angle) < 1e-9) return {angle, way};
  const double along = std::sin(angle) / angle, across = (1 - std::cos(angle)) / angle;
  return {angle, along * way.x() - across * way.y(), across * way.x() + along * way.y()};
}

bool isZero(const Pose2D& speed) {
  return speed.rotation == 0 && speed.translation == Vector2d::Zero();
}

double approach(double value, double target, double maxChange) {
  return value + std::clamp(target - value, -maxChange, maxChange);
}

/// The part of the parameters that times one foot (report, figure 3.22).
struct Step {
  double inAir, lift, lowering, height;

  Step(const WalkParameters& p, Leg leg)
      : inAir(1 - (isFore(leg) ? p.foreGroundPhase : p.hindGroundPhase)),
        lift(isFore(leg) ? p.foreLiftPhase : p.hindLiftPhase),
        lowering(isFore(leg) ? p.foreLoweringPhase : p.hindLoweringPhase),
        height(isFore(leg) ? p.foreFootLift : p.hindFootLift) {}
};

/// How far a foot in the air has come on its path, 0 to 1, and its height.
struct Flight {
  double way, height;
};

Flight flightAt(FootMode mode, const Step& step, double phase) {
  if (mode == FootMode::rectangle) {
    const double across = std::max(step.inAir - step.lift - step.lowering, 1e-3);
    return {std::clamp((phase - step.lift) / across, 0.0, 1.0),
            step.height * std::min({1.0, phase / step.lift, (step.inAir - phase) / step.lowering})};
  }
  const double angle = pi * phase / step.inAir;
  return {(1 - std::cos(angle)) / 2, step.height * std::sin(angle)};
}

}  // namespace

void InvKinWalkingEngine::update(const FrameInfo& frame, const MotionRequest& motionRequest,
                                 const RobotDimensions& robot, Previous<MotionInfo> motion,
                                 WalkingEngineOutput& output) {
  const auto executed = motion->executed.type;
  const bool active = executed == MotionType::walk || executed == MotionType::stand;
  const MotionRequest& request = motionRequest.validAt(frame.time);
  output.odometryStep = {};
  if (!active || frame_ < 0) {
    reset(robot);
  } else {
    accelerate(request.type == MotionType::walk ? allowed(request.walk) : Pose2D{});
    if (!isZero(speed_) || !standing()) {
      frame_ = (frame_ + 1) % parameters.stepLen;
      for (const auto leg : legs) moveFoot(leg);
      output.odometryStep = motionDuring(measured(speed_), frameTime);
    }
  }
  output.speed = measured(speed_);
  output.positionInWalkCycle = static_cast<double>(frame_) / parameters.stepLen;
  output.mayLeave = true;
  output.joints = {};
  for (const auto leg : legs) {
    if (footOf(leg).lift > 0.5) output.mayLeave = false;
    setLeg(output.joints.angles, leg, legAngles(robot, leg, target(robot, leg)).angles);
  }
}

void InvKinWalkingEngine::reset(const RobotDimensions& robot) {
  frame_ = 0;
  speed_ = {};
  for (const auto leg : legs) {
    const bool fore = isFore(leg);
    const double width = fore ? parameters.foreWidth : parameters.hindWidth;
    Foot& foot = footOf(leg);
    foot.center = {
        shoulderOf(robot, leg).x() + (fore ? parameters.foreCenterX : parameters.hindCenterX),
        isLeft(leg) ? width : -width};
    foot.position = foot.liftedAt = foot.center;
    foot.lift = 0;
    foot.inAir = phaseOf(leg) < Step{parameters, leg}.inAir;
  }
}

Pose2D InvKinWalkingEngine::measured(const Pose2D& ofFeet) const {
  return {(ofFeet.rotation - parameters.counterRotation * ofFeet.translation.y()) *
              parameters.correctionR,
          ofFeet.translation.x() * parameters.correctionX,
          ofFeet.translation.y() * parameters.correctionY};
}

Pose2D InvKinWalkingEngine::allowed(const Pose2D& request) const {
  const double y = request.translation.y() / parameters.correctionY;
  Pose2D speed{request.rotation / parameters.correctionR + parameters.counterRotation * y,
               request.translation.x() / parameters.correctionX, y};
  // The farthest any foot would go, in units of the ellipse: all are shortened alike, so that the
  // robot moves in the direction requested.
  double farthest = 1;
  for (const auto leg : legs) {
    const Pose2D ofLeg = speedOf(leg, speed);
    const Vector2d center = footOf(leg).center;
    const double halfTime = timeOnGround(leg) / 2;
    const double x = (ofLeg.translation.x() - ofLeg.rotation * center.y()) * halfTime;
    const double across = (ofLeg.translation.y() + ofLeg.rotation * center.x()) * halfTime;
    farthest = std::max(farthest,
                        std::hypot(x / parameters.maxStepSizeX, across / parameters.maxStepSizeY));
  }
  return {speed.rotation / farthest, speed.translation / farthest};
}

void InvKinWalkingEngine::accelerate(const Pose2D& target) {
  const auto& p = parameters;
  speed_.translation = {
      approach(speed_.translation.x(), target.translation.x(), p.maxSpeedXChange * frameTime),
      approach(speed_.translation.y(), target.translation.y(), p.maxSpeedYChange * frameTime)};
  speed_.rotation = approach(speed_.rotation, target.rotation, p.maxRotationChange * frameTime);
}

void InvKinWalkingEngine::moveFoot(Leg leg) {
  const Step step{parameters, leg};
  const double phase = phaseOf(leg);
  const Pose2D speed = speedOf(leg, speed_);
  Foot& foot = footOf(leg);
  const bool wasInAir = foot.inAir;
  foot.inAir = phase < step.inAir;
  const Vector2d landing = motionDuring(speed, timeOnGround(leg) / 2) * foot.center;
  if (!wasInAir) {  // on the ground it stays where it is while the body moves on
    foot.position = motionDuring(speed, frameTime).inverse() * foot.position;
    foot.liftedAt = foot.position;
  } else if (!foot.inAir) {
    foot.position = landing;
  }
  foot.lift = 0;
  if (foot.inAir) {
    const auto flight = flightAt(parameters.footMode, step, phase);
    foot.position = foot.liftedAt + flight.way * (landing - foot.liftedAt);
    foot.lift = flight.height;
  }
}

bool InvKinWalkingEngine::standing() const {
  return std::all_of(feet_.begin(), feet_.end(), [](const Foot& foot) {
    return foot.lift < 0.5 && (foot.position - foot.center).norm() < 0.5;
  });
}

Pose2D InvKinWalkingEngine::speedOf(Leg leg, const Pose2D& speed) const {
  if (isFore(leg)) return speed;
  const auto& p = parameters;
  return {speed.rotation * p.legSpeedFactorR, speed.translation.x() * p.legSpeedFactorX,
          speed.translation.y() * p.legSpeedFactorY};
}

double InvKinWalkingEngine::timeOnGround(Leg leg) const {
  return (1 - Step{parameters, leg}.inAir) * parameters.stepLen * frameTime;
}

double InvKinWalkingEngine::phaseOf(Leg leg) const {
  constexpr double rounding = 1e-9;  // a foot lands in its frame, not in the next
  const double phase =
      static_cast<double>(frame_) / parameters.stepLen - parameters.legPhase[leg] + rounding;
  return phase - std::floor(phase);
}

Vector3d InvKinWalkingEngine::target(const RobotDimensions& robot, Leg leg) const {
  const auto& p = parameters;
  const Foot& foot = footOf(leg);
  const double height = isFore(leg) ? p.foreHeight : p.hindHeight;
  const double tilt = std::tan(isFore(leg) ? p.foreFootTilt : p.hindFootTilt);
  const double z = (foot.position.x() - foot.center.x()) * tilt - height + foot.lift;
  return {foot.position.x(), foot.position.y(), shoulderOf(robot, leg).z() + z};
}

}  // namespace gt
