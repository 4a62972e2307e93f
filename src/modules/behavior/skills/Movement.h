#pragma once
#include "modules/behavior/potentialfields/FieldPilot.h"
#include "modules/behavior/skills/SpecialAction.h"
#include "modules/behavior/tactics/Tactics.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// Options of walking for all skills, set by the behavior's outputs.
struct WalkManner {
  WalkType type = WalkType::normal;
  bool keepOffOwnArea = false;
  bool giveWay = false;    ///< Step back from near robots.
  bool endPushes = false;  ///< Step back if the legs are held up for long.
};

/// Converts the targets of basic behaviors to motion requests within the robot's limits.
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
              Unit::mmPerS, "greatest requested speed ahead, which a walk type may limit further",
              {10, 400}),
          field<&Parameters::nearForward>(Unit::mmPerS, "greatest speed ahead to a near ball",
                                          {10, 400}),
          field<&Parameters::maxSideways>(Unit::mmPerS, "greatest speed sideways and back",
                                          {10, 400}),
          field<&Parameters::maxTurn>(Unit::degPerS, "greatest turning speed", {10, 200}),
          field<&Parameters::fastSideways>(
              Unit::mmPerS, "greatest speed sideways and back with the walk type fast", {10, 400}),
          field<&Parameters::fastTurn>(Unit::degPerS,
                                       "greatest turning speed with the walk type fast", {10, 200}),
          field<&Parameters::slowest>(Unit::mmPerS, "speed at which the robot arrives at a place",
                                      {0, 400}),
          field<&Parameters::braking>(
              Unit::perS,
              "increase of the speed with the distance from the target place, in addition to "
              "`slowest`",
              {0, 10}),
          field<&Parameters::turning>(
              Unit::perS, "turning speed for each unit of the angle to the target direction",
              {0, 10}),
          field<&Parameters::aroundBall>(Unit::mm, "radius of the path around the ball",
                                         {100, 1000}),
          field<&Parameters::clearance>(
              Unit::mm, "width of a corridor through which the robot walks", {100, 1000}),
          field<&Parameters::freeWay>(
              Unit::mm, "distance in the walking direction beyond which obstacles do not count",
              {100, 2000}),
          field<&Parameters::keepOff>(
              Unit::mm, "least distance from the robot's middle to that of another robot",
              {0, 1000}),
          field<&Parameters::giveWay>(
              Unit::mm, "distance to another robot below which a robot that gives way steps back",
              {0, 1000}),
          field<&Parameters::pushTime>(
              Unit::ms,
              "time for which the legs are held up until the robot steps back, if `endPushes`",
              {0, 10'000}),
          field<&Parameters::backTime>(Unit::ms, "time of stepping back after a push", {0, 10'000}),
          field<&Parameters::backSpeed>(Unit::mmPerS, "speed of stepping back after a push",
                                        {0, 400}),
          field<&Parameters::stopBefore>(
              Unit::mm, "distance from the robot's middle to an obstacle at which the robot stops",
              {0, 1000}),
          field<&Parameters::faceTarget>(
              Unit::mm,
              "distance from the target of a potential field below which the robot turns to its "
              "final direction",
              {0, 1e4}),
          field<&Parameters::offOwnArea>(
              Unit::mm,
              "least distance from the robot's middle to the own penalty area, if `keepOffOwnArea`",
              {0, 500}),
          field<&Parameters::pastOwnArea>(
              Unit::mm,
              "distance added to `offOwnArea` while the robot walks around the own penalty area",
              {0, 500}),
          field<&Parameters::leaveOwnArea>(
              Unit::mmPerS, "least speed at which the robot leaves the own penalty area", {0, 400}),
          field<&Parameters::pilot>()};
    }
  };

  /// All arguments must outlive this. The walk type in `manner` is the one that will be requested:
  /// it limits the speed.
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
  /// Walks with a speed relative to the robot (mm/s, rad/s). If `keepOffOwnArea`, the robot does
  /// not enter the own penalty area, and leaves it if it is there.
  void walk(const Vector2d& speed, double turn);
  /// Walks to an offset (mm) and turns by an angle (rad), relative to the robot, and slows down on
  /// arrival. `maxSpeed` in mm/s. If `keepOffOwnArea`, it walks around the own penalty area, or to
  /// the area's border if the place lies inside.
  void approach(const Vector2d& offset, double turn, double maxSpeed);
  /// Like approach, from far away: past obstacles on the path, for which the robot faces the
  /// direction in which it walks (report 4.3).
  void approachAvoiding(const Vector2d& offset, double turn, double maxSpeed);
  /// Walks to a pose on the field by a potential field (report 3.8.3). The robot faces the walking
  /// direction until it is near. `maxSpeed` in mm/s; 0: as fast as possible.
  void followField(const PotentialField& field, const Pose2D& target, double maxSpeed);

  /// Begins a cycle.
  void begin() {
    piloted_ = false;
    stand();
  }
  /// The pilot that followed a potential field in this cycle; null if none was followed.
  const FieldPilot* pilot() const { return piloted_ ? &pilot_ : nullptr; }

 private:
  /// The limits of the walk type, in mm/s and rad/s.
  double maxSideways() const;
  double maxTurn() const;
  /// Changes a speed (mm/s, relative to the robot) so that it does not lead into another robot, or,
  /// if the robot gives way, leads away from near ones.
  Vector2d keptFromPlayers(Vector2d speed) const;
  /// Replaces a speed (mm/s) while the robot steps back, after its legs were held up for long:
  /// opposite to the mean speed requested during the push.
  Vector2d keptFromPushing(const Vector2d& speed);
  /// Changes a speed (mm/s, relative to the robot) so that it does not lead into the own penalty
  /// area, and leads out of it.
  Vector2d keptFromOwnArea(const Vector2d& speed) const;
  /// The offset (mm, relative to the robot) to a place, or to the point that must be passed before
  /// it on the path around the own penalty area.
  Vector2d pastOwnArea(const Vector2d& offset) const;

  /// Requests a type of motion and resets all else; keeps the memory allocated for the name.
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
  // ms: duration of the push, remaining time of stepping back
  double pushed_ = 0, back_ = 0;
  Vector2d pushing_ = Vector2d::Zero();  // mm/s: the mean speed wanted during the push
};
static_assert(complete<Movement::Parameters>);

}  // namespace gt
