#pragma once
#include "modules/behavior/potentialfields/FieldPilot.h"
#include "modules/behavior/skills/SpecialAction.h"
#include "modules/behavior/tactics/Tactics.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// How all skills walk, as the behavior's outputs say.
struct WalkManner {
  WalkType type = WalkType::normal;
  bool keepOffOwnArea = false;
  bool giveWay = false;    ///< Step back from whoever is near.
  bool endPushes = false;  ///< Step back from what holds the legs up for long.
};

/// Where basic behaviors want to go, made a motion request within the robot's limits.
class Movement {
 public:
  struct Parameters {
    double maxForward = 320;
    double nearForward = 300;
    double maxSideways = 165;
    double maxTurn = 100;
    double fastSideways = 250;
    double fastTurn = 180;
    double slowest = 40;
    double braking = 1.5;
    double turning = 1.5;
    double aroundBall = 240;
    double clearance = 250;
    double freeWay = 700;
    double keepOff = 260;
    double giveWay = 500;
    double pushTime = 1500;
    double backTime = 700;
    double backSpeed = 200;
    double stopBefore = 230;
    double faceTarget = 500;
    double offOwnArea = 80;
    double pastOwnArea = 60;
    double leaveOwnArea = 150;
    FieldPilot::Parameters pilot;

    static constexpr auto fields() {
      return Fields{
          field("maxForward", &Parameters::maxForward, "mm/s",
                "fastest walk ahead, of which a walk type does what it can", {10, 400}),
          field("nearForward", &Parameters::nearForward, "mm/s",
                "fastest walk ahead to a near ball", {10, 400}),
          field("maxSideways", &Parameters::maxSideways, "mm/s", "fastest walk sideways and back",
                {10, 400}),
          field("maxTurn", &Parameters::maxTurn, "degree/s", "fastest turn", {10, 200}),
          field("fastSideways", &Parameters::fastSideways, "mm/s",
                "fastest walk sideways and back with the walk type fast", {10, 400}),
          field("fastTurn", &Parameters::fastTurn, "degree/s",
                "fastest turn with the walk type fast", {10, 200}),
          field("slowest", &Parameters::slowest, "mm/s",
                "speed at which the robot arrives at a place", {0, 400}),
          field("braking", &Parameters::braking, "1/s",
                "share of the distance to a place that it walks in a second, beside that", {0, 10}),
          field("turning", &Parameters::turning, "1/s",
                "share of the angle to its direction that it turns in a second", {0, 10}),
          field("aroundBall", &Parameters::aroundBall, "mm", "radius of the path round the ball",
                {100, 1000}),
          field("clearance", &Parameters::clearance, "mm",
                "width of a corridor through which the robot walks", {100, 1000}),
          field("freeWay", &Parameters::freeWay, "mm",
                "obstacles that are farther away in the walking direction do not count",
                {100, 2000}),
          field("keepOff", &Parameters::keepOff, "mm",
                "least distance from the robot's middle to that of another robot", {0, 1000}),
          field("giveWay", &Parameters::giveWay, "mm",
                "the same if it gives way: it steps back from who is nearer", {0, 1000}),
          field("pushTime", &Parameters::pushTime, "ms",
                "for how long something holds its legs up until it steps back, if it ends pushes",
                {0, 10'000}),
          field("backTime", &Parameters::backTime, "ms", "for how long it steps back", {0, 10'000}),
          field("backSpeed", &Parameters::backSpeed, "mm/s", "how fast it steps back", {0, 400}),
          field("stopBefore", &Parameters::stopBefore, "mm",
                "distance from the robot's middle to an obstacle at which it stops", {0, 1000}),
          field("faceTarget", &Parameters::faceTarget, "mm",
                "nearer to the target of a potential field the robot turns as it shall stand there",
                {0, 1e4}),
          field("offOwnArea", &Parameters::offOwnArea, "mm",
                "least distance from the robot's middle to the own penalty area, if it keeps off "
                "that",
                {0, 500}),
          field("pastOwnArea", &Parameters::pastOwnArea, "mm",
                "further distance at which it walks past the area", {0, 500}),
          field("leaveOwnArea", &Parameters::leaveOwnArea, "mm/s",
                "least speed at which it leaves the area", {0, 400}),
          field("pilot", &Parameters::pilot)};
    }
  };

  /// All must outlive this. The walk type is the one that will be requested: it limits the speed.
  Movement(const Tactics& tactics, MotionRequest& request, const WalkManner& manner,
           const Parameters& parameters)
      : tactics_{tactics}, request_{request}, manner_{manner}, parameters_{parameters} {}

  const Tactics& tactics() const { return tactics_; }
  const Parameters& parameters() const { return parameters_; }

  void stand() { request(MotionType::stand); }
  void getup() { request(MotionType::getup); }
  void perform(SpecialAction action) {
    request(MotionType::specialAction);
    request_.specialAction = motionOf(tactics_.world().motions, action).name;
  }
  /// Speeds in mm/s and rad/s. Not into the own penalty area, if the robot keeps off that, and out
  /// of it if it is there.
  void walk(const Vector2d& speed, double turn);
  /// Walks by an offset in mm and turns by an angle, ever slower. Around the own penalty area, if
  /// it keeps off that; if the place lies there, to the area's border.
  void approach(const Vector2d& offset, double turn, double maxSpeed);
  /// The same from far away: past obstacles on the way, for which the robot faces the direction in
  /// which it walks (report 4.3).
  void approachAvoiding(const Vector2d& offset, double turn, double maxSpeed);
  /// Walks to a pose on the field by a potential field (report 3.8.3), where it walks where it
  /// looks until it is near. As fast as it can with a speed of 0.
  void followField(const PotentialField& field, const Pose2D& target, double maxSpeed);

  /// A cycle begins.
  void begin() {
    piloted_ = false;
    stand();
  }
  /// Who followed a potential field in this cycle; null if nobody did.
  const FieldPilot* pilot() const { return piloted_ ? &pilot_ : nullptr; }

 private:
  /// The limits of the walk type, in mm/s and rad/s.
  double maxSideways() const;
  double maxTurn() const;
  /// A speed that does not lead into another robot, or leads away from who is near if this one
  /// gives way.
  Vector2d keptFromPlayers(Vector2d speed) const;
  /// A speed that leads back from what has held the legs up for long: against where the robot
  /// wanted to go meanwhile.
  Vector2d keptFromPushing(const Vector2d& speed);
  /// A speed that does not lead into the own penalty area, and leads out of it.
  Vector2d keptFromOwnArea(const Vector2d& speed) const;
  /// The offset to a place, or to what has to be passed before it on the way around the own penalty
  /// area.
  Vector2d pastOwnArea(const Vector2d& offset) const;

  /// A request of a type and nothing else; keeps the memory of the name.
  void request(MotionType type) {
    static const MotionRequest nothing;
    request_ = nothing;
    request_.type = type;
  }

  const Tactics& tactics_;
  MotionRequest& request_;
  const WalkManner& manner_;
  const Parameters& parameters_;
  FieldPilot pilot_;
  bool piloted_ = false;
  Time walked_ = never();
  double pushed_ = 0, back_ = 0;         // ms: of the push until now, of the steps back to come
  Vector2d pushing_ = Vector2d::Zero();  // mm/s: the mean speed wanted during the push
};
static_assert(complete<Movement::Parameters>);

}  // namespace gt
