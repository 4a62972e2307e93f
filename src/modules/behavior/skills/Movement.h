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
          field<&Parameters::maxForward>(
              Unit::mmPerS, "fastest walk ahead, of which a walk type does what it can", {10, 400}),
          field<&Parameters::nearForward>(Unit::mmPerS, "fastest walk ahead to a near ball",
                                          {10, 400}),
          field<&Parameters::maxSideways>(Unit::mmPerS, "fastest walk sideways and back",
                                          {10, 400}),
          field<&Parameters::maxTurn>(Unit::degPerS, "fastest turn", {10, 200}),
          field<&Parameters::fastSideways>(
              Unit::mmPerS, "fastest walk sideways and back with the walk type fast", {10, 400}),
          field<&Parameters::fastTurn>(Unit::degPerS, "fastest turn with the walk type fast",
                                       {10, 200}),
          field<&Parameters::slowest>(Unit::mmPerS, "speed at which the robot arrives at a place",
                                      {0, 400}),
          field<&Parameters::braking>(
              Unit::perS, "share of the distance to a place that it walks in a second, beside that",
              {0, 10}),
          field<&Parameters::turning>(
              Unit::perS, "share of the angle to its direction that it turns in a second", {0, 10}),
          field<&Parameters::aroundBall>(Unit::mm, "radius of the path round the ball",
                                         {100, 1000}),
          field<&Parameters::clearance>(
              Unit::mm, "width of a corridor through which the robot walks", {100, 1000}),
          field<&Parameters::freeWay>(
              Unit::mm, "obstacles that are farther away in the walking direction do not count",
              {100, 2000}),
          field<&Parameters::keepOff>(
              Unit::mm, "least distance from the robot's middle to that of another robot",
              {0, 1000}),
          field<&Parameters::giveWay>(
              Unit::mm,
              "least distance to another robot while it gives way: it steps back from who is nearer",
              {0, 1000}),
          field<&Parameters::pushTime>(
              Unit::ms,
              "for how long something holds its legs up until it steps back, if it ends pushes",
              {0, 10'000}),
          field<&Parameters::backTime>(Unit::ms, "for how long it steps back", {0, 10'000}),
          field<&Parameters::backSpeed>(Unit::mmPerS, "how fast it steps back", {0, 400}),
          field<&Parameters::stopBefore>(
              Unit::mm, "distance from the robot's middle to an obstacle at which it stops",
              {0, 1000}),
          field<&Parameters::faceTarget>(
              Unit::mm,
              "nearer to the target of a potential field the robot turns as it shall stand there",
              {0, 1e4}),
          field<&Parameters::offOwnArea>(
              Unit::mm,
              "least distance from the robot's middle to the own penalty area, if it keeps off "
              "that",
              {0, 500}),
          field<&Parameters::pastOwnArea>(
              Unit::mm, "further distance at which it walks past the area", {0, 500}),
          field<&Parameters::leaveOwnArea>(Unit::mmPerS, "least speed at which it leaves the area",
                                           {0, 400}),
          field<&Parameters::pilot>()};
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
