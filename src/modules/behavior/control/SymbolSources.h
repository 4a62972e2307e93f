#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/skills/Movement.h"
#include "modules/behavior/skills/SpecialAction.h"
#include "modules/behavior/tactics/Tactics.h"
#include "modules/behavior/tactics/Tour.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/SoundRequest.h"

namespace gt {

/// The input symbols of the behavior, computed from the state of the world. The functions are those
/// declared in behavior/symbols/, with the units given there: mm, ms, and degrees for angles.
class SoccerInputs final : public soccer::Inputs {
 public:
  /// The tactics must outlive this.
  explicit SoccerInputs(const Tactics& tactics) : tactics_{tactics} {}

  soccer::GameState gameState() const override;
  bool gameOwnKickOff() const override { return tactics_.game().ownKickOff(); }
  double gameTimeSinceOwnGoal() const override { return ms(w().frame.time - tactics_.ownGoal()); }
  double gameTimeSinceOpponentGoal() const override {
    return ms(w().frame.time - tactics_.opponentGoal());
  }
  double gameOwnScore() const override { return w().game.ownScore; }
  double gameOpponentScore() const override { return w().game.opponentScore; }
  Penalty gamePenalty() const override { return w().game.penalty; }
  PlayerRole playerRole() const override { return w().player.role; }
  TeamColor playerTeamColor() const override { return w().player.teamColor; }
  DynamicRole teamRole() const override { return tactics_.role(); }
  double teamConnections() const override { return tactics_.connections(); }
  bool teamHasLearned() const override { return !w().values.empty(); }
  double teamPlaceX() const override { return place().x(); }
  double teamPlaceY() const override { return place().y(); }
  double fieldXGroundline() const override { return w().field.xGroundline; }

  double ballSeenX() const override { return w().ball.position.x(); }
  double ballSeenY() const override { return w().ball.position.y(); }
  double ballSeenDistance() const override { return w().ball.position.norm(); }
  double ballSeenAngle() const override { return toDegrees(angleOf(w().ball.position)); }
  double ballSeenSpeedX() const override { return w().ball.speed.x(); }
  double ballSeenSpeedY() const override { return w().ball.speed.y(); }
  double ballSeenSpeed() const override { return w().ball.speed.norm(); }
  double ballCrossingLeft() const override { return tactics_.crossing().left; }
  double ballCrossingTime() const override { return tactics_.crossing().time; }
  double ballTimeSinceLastSeen() const override { return ms(w().frame.time - w().ball.lastSeen); }
  double ballConsecutiveTimeSeen() const override { return ms(w().ball.consecutiveTimeSeen); }
  double ballKnownX() const override { return tactics_.knownBallOnField().x(); }
  double ballKnownY() const override { return tactics_.knownBallOnField().y(); }
  double ballKnownDistance() const override { return tactics_.knownBall().norm(); }
  double ballKnownAngle() const override { return toDegrees(angleOf(tactics_.knownBall())); }
  double ballKnownAhead() const override { return tactics_.knownBall().x(); }
  double ballKnownLeft() const override { return tactics_.knownBall().y(); }
  double ballTimeSinceLastKnown() const override { return ms(tactics_.knownBallAge()); }
  double ballAngleAround(double facing) const override;

  double ballGoalDirection() const override;
  double ballGoalAngle() const override;
  double ballOwnGoalDirection() const override { return angleTo(ballToOwnGoal()); }
  double ballOwnGoalDistance() const override { return ballToOwnGoal().norm(); }
  double ballOwnGoalBisector(double x, double most) const override;

  double robotPoseX() const override { return w().self.pose.translation.x(); }
  double robotPoseY() const override { return w().self.pose.translation.y(); }
  double robotPoseDistanceTo(double x, double y) const override {
    return (Vector2d{x, y} - w().self.pose.translation).norm();
  }
  double robotPoseValidity() const override { return w().self.validity; }
  double opponentGoalAngle() const override { return toDegrees(angleOf(opponentGoal())); }
  double opponentGoalDistance() const override { return opponentGoal().norm(); }
  double ownGoalAngle() const override { return angleTo(ownGoal()); }
  double ownGoalDistance() const override { return ownGoal().norm(); }
  double backSwitchPressedFor() const override { return ms(w().body.pressedFor[Switch::back]); }
  double chinSwitchPressedFor() const override { return ms(w().body.pressedFor[Switch::chin]); }
  double headSwitchPressedFor() const override {
    const auto& pressed = w().body.pressedFor;
    return ms(std::max(pressed[Switch::headFront], pressed[Switch::headBack]));
  }
  double tailAngle() const override { return toDegrees(w().body.tailPan); }
  double bodyTimeSinceCollision() const override {
    return ms(w().frame.time - w().collision.lastCollision);
  }
  double robotPoseAngle() const override { return toDegrees(w().self.pose.rotation); }
  bool bodyFallen() const override { return w().body.state == BodyState::fallen; }
  SpecialAction motionSpecialAction() const override;

  SpecialAction kickPlanned() const override { return SpecialAction{plan().motion}; }
  double kickFacing() const override { return toDegrees(plan().facing); }
  SpecialAction kickNow() const override { return SpecialAction{tactics_.kick().now()}; }
  double kickTimeSinceLast() const override {
    return ms(w().frame.time - tactics_.kick().lastKick());
  }
  double kickTargetX() const override { return kickTarget().x(); }
  double kickTargetY() const override { return kickTarget().y(); }
  double kickTargetAngle() const override { return toDegrees(angleOf(kickTarget())); }
  double kickX(SpecialAction id) const override { return motion(id).kick.x; }
  double kickY(SpecialAction id) const override { return motion(id).kick.y; }

  double obstaclesFreeAhead(double angle, double width) const override;
  double obstaclesFreeDirection(double angle, double width, double length) const override;
  double obstaclesGap(double angle, double range) const override;

  double teammateDistance() const override { return nearest(w().players.ownTeam).norm(); }
  double teammateAngle() const override { return angleTo(nearest(w().players.ownTeam)); }
  double opponentDistance() const override { return nearest(w().players.opponents).norm(); }
  double opponentAngle() const override { return angleTo(nearest(w().players.opponents)); }
  double opponentsWithin(double distance) const override;

  double targetCount() const override { return static_cast<double>(tour_.size()); }
  double targetX(double index) const override { return target(index).translation.x(); }
  double targetY(double index) const override { return target(index).translation.y(); }
  double targetAngle(double index) const override { return toDegrees(target(index).rotation); }
  double targetDistance(double index) const override { return towards(index).norm(); }
  double targetAhead(double index) const override { return towards(index).x(); }
  double targetLeft(double index) const override { return towards(index).y(); }
  double targetTurn(double index) const override {
    return toDegrees(normalize(target(index).rotation - w().self.pose.rotation));
  }

  double min(double a, double b) const override { return std::min(a, b); }
  double max(double a, double b) const override { return std::max(a, b); }
  double abs(double a) const override { return std::abs(a); }
  double sqrt(double a) const override { return std::sqrt(std::max(a, 0.)); }
  double sin(double angle) const override { return std::sin(fromDegrees(angle)); }
  double cos(double angle) const override { return std::cos(fromDegrees(angle)); }
  double atan2(double y, double x) const override { return toDegrees(std::atan2(y, x)); }

 private:
  static double ms(std::int64_t time) { return static_cast<double>(time); }

  static double angleTo(const Vector2d& point) { return toDegrees(angleOf(point)); }

  const WorldState& w() const { return tactics_.world(); }
  Vector2d kickTarget() const { return relative(w().self.pose, tactics_.kick().target()); }
  const KickChoice::Plan& plan() const { return tactics_.kick().plan(); }
  const MotionNet::Motion& motion(SpecialAction id) const { return motionOf(w().motions, id); }

  const Pose2D& target(double index) const;
  Vector2d towards(double index) const {
    return relative(w().self.pose, target(index).translation);
  }
  /// The place of the supporter according to the learned values of its team (mm, on the field); the
  /// middle of the field without values.
  Vector2d place() const;
  /// The nearest player, relative to the robot (mm); far away if there is none.
  Vector2d nearest(const std::vector<LocatedPlayer>& players) const;
  /// The middles of the goals, relative to the robot (mm).
  Vector2d opponentGoal() const { return relative(w().self.pose, {w().field.xGroundline, 0}); }
  Vector2d ownGoal() const { return relative(w().self.pose, {-w().field.xGroundline, 0}); }
  /// The vector from the known ball to the own goal, in the field's axes (mm).
  Vector2d ballToOwnGoal() const {
    return Vector2d{-w().field.xGroundline, 0} - tactics_.knownBallOnField();
  }

  const Tactics& tactics_;
  mutable Tour tour_;
  mutable SpecialAction action_{};  ///< The one being executed, looked up when its name changes.
};

/// The output symbols of the behavior, except motions of the body.
struct SoccerOutputs final : soccer::Outputs {
  HeadControlMode head;
  LedRequest leds;
  WalkManner manner;
  TailRequest tail = TailRequest::noTailWag;
  SoundRequest sound;

  void setHeadControlMode(HeadMode mode) override { head.mode = mode; }
  void setHeadPointX(double x) override { head.point.x() = x; }
  void setHeadPointY(double y) override { head.point.y() = y; }
  void setHeadPointZ(double z) override { head.point.z() = z; }
  void setHeadPixelX(double x) override { head.pixel.x() = x; }
  void setHeadPixelY(double y) override { head.pixel.y() = y; }
  void setHeadScanTilt(double tilt) override { head.scanTilt = fromDegrees(tilt); }
  void setHeadScanRange(double range) override { head.scanRange = fromDegrees(range); }
  void setMotionWalkType(WalkType type) override { manner.type = type; }
  void setMotionKeepOffOwnArea(bool keepOff) override { manner.keepOffOwnArea = keepOff; }
  void setMotionEndPushes(bool end) override { manner.endPushes = end; }
  void setMotionGiveWay(bool giveWay) override { manner.giveWay = giveWay; }
  void setLedLowerLeft(LedMode mode) override { leds.modes[Led::lowerLeft] = mode; }
  void setLedUpperLeft(LedMode mode) override { leds.modes[Led::upperLeft] = mode; }
  void setLedLowerRight(LedMode mode) override { leds.modes[Led::lowerRight] = mode; }
  void setLedUpperRight(LedMode mode) override { leds.modes[Led::upperRight] = mode; }
  void setLedMiddleLeft(LedMode mode) override { leds.modes[Led::middleLeft] = mode; }
  void setLedMiddleRight(LedMode mode) override { leds.modes[Led::middleRight] = mode; }
  void setLedTop(LedMode mode) override { leds.modes[Led::top] = mode; }
  void setLedTailBlue(LedMode mode) override { leds.modes[Led::tailBlue] = mode; }
  void setLedTailRed(LedMode mode) override { leds.modes[Led::tailRed] = mode; }
  void setTail(TailRequest request) override { tail = request; }
  void setSound(Sound name) override { sound.sound = name; }
};

}  // namespace gt
