#include "modules/motion/walking/InvKinWalkingEngine.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/Tasks.h"

namespace gt {
namespace {

constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

/// The displacement of a body that moves at a constant speed (mm/s, rad/s) for a time (s), along a
/// line or an arc.
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

/// A phase as a share of the cycle, in [0, 1).
double wrapped(double phase) {
  return phase - std::floor(phase);
}

constexpr double still = 0.5;  // mm: what is nearer to where it stands counts as there

}  // namespace

void InvKinWalkingEngine::update(const FrameInfo& frame, const MotionRequest& motionRequest,
                                 const RobotDimensions& robot, const SensorDataBuffer& sensors,
                                 Previous<MotionInfo> motion, WalkingEngineOutput& output) {
  const auto executed = motion->executed.type;
  const bool active =
      !motion->arriving && (executed == MotionType::walk || executed == MotionType::stand);
  const MotionRequest& request = motionRequest.validAt(frame.time);
  output.odometryStep = {};
  if (!active || frame_ < 0) {
    type_ = request.walkType;  // of which the stand is that the legs come to
    reset(robot);
  } else {
    const bool walks = request.type == MotionType::walk;
    // Special actions begin with the stance of the type that their request names.
    const bool changes = request.type != MotionType::stand && request.walkType != type_;
    if (changes && allOnGround()) change(request.walkType, robot);
    // Of a walk whose feet are never all on the ground it has to stop before it can change.
    const bool stops = !walks || (request.walkType != type_ && flies());
    const Pose2D wanted{request.walk.rotation, request.walk.translation * parameters.gameSpeed};
    accelerate(stops ? Pose2D{} : allowed(wanted));
    if (!isZero(speed_) || !standing()) {
      frame_ = (frame_ + 1) % walk().stepLen;
      balance(sensors.newest(), output.joints.angles);
      for (const auto leg : legs) moveFoot(leg);
      shiftBody();
      output.odometryStep = motionDuring(measured(moving_), frameTime);
    } else {
      rest();
    }
  }
  adjustStance();
  output.speed = measured(speed_);
  output.walkType = type_;
  output.positionInWalkCycle = static_cast<double>(frame_) / walk().stepLen;
  output.mayLeave = isZero(speed_) && standing();
  output.joints = {};
  for (const auto leg : legs)
    setLeg(output.joints.angles, leg, legAngles(robot, leg, target(robot, leg)).angles);
  output.holdsHead = walk().holdsHead;
  if (!walk().holdsHead) return;
  output.joints.angles[Joint::headTilt] = walk().headTilt;
  output.joints.angles[Joint::headPan] = walk().headPan;
  output.joints.angles[Joint::headRoll] = walk().headRoll;
  output.joints.angles[Joint::mouth] = walk().mouth;
}

void InvKinWalkingEngine::rest() {
  frame_ = walk().stepLen - 1;  // the next walk begins with a new cycle
  for (const auto leg : legs) {
    footOf(leg).rests = true;
    footOf(leg).offset = offset(leg, FootPath{walk(), leg}.landing());
  }
  balance_.forget();
}

void InvKinWalkingEngine::reset(const RobotDimensions& robot) {
  speed_ = {};
  bodyShift_ = Vector2d::Zero();
  swing_ = 0;
  feet_ = {};
  setCenters(robot);
  for (Foot& foot : feet_) foot.position = foot.liftedAt = foot.center;
  stance_ = wantedStance();
  rest();
}

void InvKinWalkingEngine::change(WalkType type, const RobotDimensions& robot) {
  // The feet stay where they are, and step to their new places.
  for (Foot& foot : feet_) foot.inAir = false;
  type_ = type;
  setCenters(robot);
  rest();
}

void InvKinWalkingEngine::setCenters(const RobotDimensions& robot) {
  for (const auto leg : legs) {
    const bool fore = isFore(leg);
    const double width = fore ? walk().foreWidth : walk().hindWidth;
    footOf(leg).center = {
        shoulderOf(robot, leg).x() + (fore ? walk().foreCenterX : walk().hindCenterX),
        isLeft(leg) ? width : -width};
  }
}

InvKinWalkingEngine::Stance InvKinWalkingEngine::wantedStance() const {
  return {walk().foreHeight, walk().hindHeight, walk().foreFootTilt, walk().hindFootTilt};
}

void InvKinWalkingEngine::adjustStance() {
  constexpr double lifting = 100, tilting = 0.5;  // mm/s, rad/s
  const Stance wanted = wantedStance();
  const auto adjust = [](double& value, double target, double speed) {
    value = approach(value, target, speed * frameTime);
  };
  adjust(stance_.foreHeight, wanted.foreHeight, lifting);
  adjust(stance_.hindHeight, wanted.hindHeight, lifting);
  adjust(stance_.foreTilt, wanted.foreTilt, tilting);
  adjust(stance_.hindTilt, wanted.hindTilt, tilting);
}

bool InvKinWalkingEngine::flies() const {
  return walk().foreGroundPhase < 0.5 || walk().hindGroundPhase < 0.5;
}

bool InvKinWalkingEngine::allOnGround() const {
  return std::none_of(feet_.begin(), feet_.end(), [](const Foot& foot) {
    return foot.inAir && std::abs(foot.offset.z()) > still;
  });
}

Pose2D InvKinWalkingEngine::measured(const Pose2D& ofFeet) const {
  return isZero(ofFeet) ? Pose2D{} : walk().speedOf(ofFeet);
}

Pose2D InvKinWalkingEngine::allowed(const Pose2D& request) const {
  if (isZero(request)) return {};
  const Pose2D speed = walk().feetFor(request);
  // The farthest any foot would go, in units of the ellipse: all are shortened alike, so that the
  // robot moves in the direction requested.
  double farthest = 1;
  for (const auto leg : legs) {
    const Pose2D ofLeg = speedOf(leg, speed);
    const Vector2d center = footOf(leg).center;
    const FootPath path{walk(), leg};
    const double time =
        unitTime(path) * std::max(std::abs(path.landing().along), std::abs(path.lifting().along));
    const double along = (ofLeg.translation.x() - ofLeg.rotation * center.y()) * time;
    const double across = (ofLeg.translation.y() + ofLeg.rotation * center.x()) * time;
    farthest =
        std::max(farthest, std::hypot(along / walk().maxStepSizeX, across / walk().maxStepSizeY));
  }
  return {speed.rotation / farthest, speed.translation / farthest};
}

void InvKinWalkingEngine::accelerate(const Pose2D& target) {
  const auto& p = walk();
  speed_.translation = {
      approach(speed_.translation.x(), target.translation.x(), p.maxSpeedXChange * frameTime),
      approach(speed_.translation.y(), target.translation.y(), p.maxSpeedYChange * frameTime)};
  speed_.rotation = approach(speed_.rotation, target.rotation, p.maxRotationChange * frameTime);
}

void InvKinWalkingEngine::balance(const SensorData& measured, const JointAngles& asked) {
  const BalanceParameters& p = parameters.balance;
  moving_ = speed_;
  placement_ = Vector2d::Zero();
  if (p.yield == 0 && p.placement == 0 && p.lift == 0) return;
  balance_.update(p, measured, asked, frame_, walk().stepLen);
  const Vector2d pushed = balance_.unexpectedSpeed();
  moving_.translation += p.yield * pushed;
  placement_ = p.placement * pushed;
  if (placement_.norm() > p.farthest) placement_ *= p.farthest / placement_.norm();
  for (const auto leg : legs) {
    constexpr double lifting = 300;  // mm/s
    Foot& foot = footOf(leg);
    const bool higher = foot.inAir && balance_.stumbles(leg);
    if (higher || !foot.inAir)
      foot.raised = approach(foot.raised, higher ? p.lift : 0, lifting * frameTime);
  }
}

void InvKinWalkingEngine::moveFoot(Leg leg) {
  const FootPath path{walk(), leg};
  const double phase = phaseOf(leg), before = phase - 1. / walk().stepLen;
  const Pose2D speed = speedOf(leg, moving_);
  const double seconds = unitTime(path);  // for each unit along the path
  const auto landing = path.landing(), lifting = path.lifting();
  const bool begins = before < 0;  // a new cycle
  Foot& foot = footOf(leg);
  const auto stand = [&](double from, double to) {  // while the body moves on
    const double moved = foot.rests ? frameTime : (from - to) * seconds;
    foot.position = motionDuring(speed, moved).inverse() * foot.position;
    foot.liftedAt = foot.position;
  };
  if (begins) {
    if (!foot.inAir) stand(path.at(wrapped(before)).along, lifting.along);
    foot.rests = isZero(speed_) && isCentered(foot);
    foot.inAir = !foot.rests;
  }
  const auto point = foot.rests ? landing : path.at(phase);
  const Vector2d landsAt = motionDuring(speed, seconds * landing.along) * foot.center + placement_;
  if (!begins && !foot.inAir) {
    stand(path.at(before).along, point.along);
  } else if (foot.inAir && !path.inAir(phase)) {
    foot.inAir = false;
    foot.position = landsAt;
    stand(landing.along, point.along);
  } else if (foot.inAir) {
    const double share = (point.along - lifting.along) / (landing.along - lifting.along);
    foot.position = foot.liftedAt + share * (landsAt - foot.liftedAt);
  }
  foot.offset = offset(leg, point);
  const Vector2d way = landsAt - foot.liftedAt;
  const double length = way.norm(), beyond = std::clamp(point.beyond, -length / 2, length / 2);
  if (foot.inAir && length > 0) foot.offset.head<2>() += beyond / length * way;
}

void InvKinWalkingEngine::shiftBody() {
  const double target = isZero(speed_) ? 0 : 1;
  swing_ = approach(swing_, target, 2. / walk().stepLen);
  bodyShift_ = Vector2d::Zero();
  for (const auto leg : legs) {
    const double phase = wrapped(phaseOf(leg) + walk().bodyShiftOffset);
    const FootPath path{walk(), leg};
    if (!path.inAir(phase)) continue;
    const double share = swing_ * std::sin(pi * phase / path.airPhase());
    bodyShift_ += share * Vector2d{isFore(leg) ? -walk().bodyShiftX : walk().bodyShiftX,
                                   isLeft(leg) ? -walk().bodyShiftY : walk().bodyShiftY};
  }
}

bool InvKinWalkingEngine::standing() const {
  return swing_ == 0 && std::all_of(legs.begin(), legs.end(), [&](Leg leg) {
           const Foot& foot = footOf(leg);
           const double landing = FootPath{walk(), leg}.landing().height;
           return !foot.inAir && isCentered(foot) && std::abs(foot.offset.z() - landing) < still;
         });
}

bool InvKinWalkingEngine::isCentered(const Foot& foot) {
  return (foot.position - foot.center).norm() < still;
}

Pose2D InvKinWalkingEngine::speedOf(Leg leg, const Pose2D& speed) const {
  if (isFore(leg)) return speed;
  const auto& p = walk();
  return {speed.rotation * p.legSpeedFactorR, speed.translation.x() * p.legSpeedFactorX,
          speed.translation.y() * p.legSpeedFactorY};
}

double InvKinWalkingEngine::unitTime(const FootPath& path) const {
  constexpr double shortest = 0.1;
  const double units = std::max(path.landing().along - path.lifting().along, shortest);
  return path.groundPhase() * walk().stepLen * frameTime / units;
}

double InvKinWalkingEngine::phaseOf(Leg leg) const {
  constexpr double rounding = 1e-9;  // a foot lands in its frame, not in the next
  return wrapped(static_cast<double>(frame_) / walk().stepLen - walk().legPhase[leg] + rounding);
}

Vector3d InvKinWalkingEngine::offset(Leg leg, const FootPath::Point& point) {
  return {0, isLeft(leg) ? point.aside : -point.aside, point.height};
}

Vector3d InvKinWalkingEngine::target(const RobotDimensions& robot, Leg leg) const {
  const Foot& foot = footOf(leg);
  const Vector2d position = foot.position + foot.offset.head<2>();
  const double height = isFore(leg) ? stance_.foreHeight : stance_.hindHeight;
  const double tilt = std::tan(isFore(leg) ? stance_.foreTilt : stance_.hindTilt);
  const double z = (position.x() - foot.center.x()) * tilt - height + foot.offset.z() + foot.raised;
  return {position.x() - bodyShift_.x(), position.y() - bodyShift_.y(),
          shoulderOf(robot, leg).z() + z};
}

}  // namespace gt
