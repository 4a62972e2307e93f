#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"

namespace gt {

/// What the behavior may ask, computed from the state of the world. The functions are those that
/// behavior/symbols/ declares, with the units given there: angles in degrees, as people write them.
class SoccerInputs final : public soccer::Inputs {
 public:
  SoccerInputs(const WorldState& world, const DynamicRole& role) : w_{world}, role_{role} {}

  soccer::GameState gameState() const override;
  bool gameOwnKickOff() const override { return w_.game.kickOff == KickOff::own; }
  PlayerRole playerRole() const override { return w_.player.role; }
  DynamicRole teamRole() const override { return role_; }
  double fieldXGroundline() const override { return w_.field.xGroundline; }

  double ballSeenX() const override { return w_.ball.position.x(); }
  double ballSeenY() const override { return w_.ball.position.y(); }
  double ballSeenDistance() const override { return w_.ball.position.norm(); }
  double ballSeenAngle() const override { return toDegrees(angleOf(w_.ball.position)); }
  double ballTimeSinceLastSeen() const override { return ms(w_.now - w_.ball.lastSeen); }
  double ballConsecutiveTimeSeen() const override { return ms(w_.ball.consecutiveTimeSeen); }
  double ballKnownX() const override { return w_.knownBallOnField().x(); }
  double ballKnownY() const override { return w_.knownBallOnField().y(); }
  double ballKnownDistance() const override { return w_.knownBall().norm(); }
  double ballKnownAngle() const override { return toDegrees(angleOf(w_.knownBall())); }
  double ballTimeSinceLastKnown() const override { return ms(w_.knownBallAge()); }
  double ballKickDirection() const override { return toDegrees(gt::kickDirection(w_)); }
  double ballKickAngle() const override;
  double ballKickTolerance() const override { return toDegrees(kickTolerance(w_)); }
  double ballAngleAround(double facing) const override;

  double robotPoseAngle() const override { return toDegrees(w_.self.pose.rotation); }
  bool bodyFallen() const override { return w_.body.state == BodyState::fallen; }
  SpecialAction motionSpecialAction() const override;

  double kickX(SpecialAction id) const override { return w_.specialAction(id).kick.x; }
  double kickY(SpecialAction id) const override { return w_.specialAction(id).kick.y; }
  double kickDirection(SpecialAction id) const override {
    return w_.specialAction(id).kick.direction;
  }
  bool kickReaches(SpecialAction id, double astray, double margin) const override;

  double min(double a, double b) const override { return std::min(a, b); }
  double max(double a, double b) const override { return std::max(a, b); }
  double abs(double a) const override { return std::abs(a); }

 private:
  static double ms(std::int64_t time) { return static_cast<double>(time); }

  const WorldState& w_;
  const DynamicRole& role_;
  mutable SpecialAction action_{};  ///< The one being executed, looked up when its name changes.
};

/// What the behavior sets besides motions.
struct SoccerOutputs final : soccer::Outputs {
  HeadControlMode head;
  LedRequest leds;

  void setHeadControlMode(HeadMode mode) override { head.mode = mode; }
  void setLedLowerLeft(LedMode mode) override { leds.modes[Led::lowerLeft] = mode; }
  void setLedUpperLeft(LedMode mode) override { leds.modes[Led::upperLeft] = mode; }
  void setLedLowerRight(LedMode mode) override { leds.modes[Led::lowerRight] = mode; }
  void setLedUpperRight(LedMode mode) override { leds.modes[Led::upperRight] = mode; }
  void setLedMiddleLeft(LedMode mode) override { leds.modes[Led::middleLeft] = mode; }
  void setLedMiddleRight(LedMode mode) override { leds.modes[Led::middleRight] = mode; }
};

}  // namespace gt
