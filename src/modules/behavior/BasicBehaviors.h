#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/WorldState.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// The skills that the behavior's options end in (report 3.8.2, 3.8.3); each sets the motion
/// request. Angles in degrees, as people write them in XABSL.
class BasicBehaviors final : public soccer::BasicBehaviors {
 public:
  struct Parameters {
    double maxForward = 225;
    double maxSideways = 165;
    double maxTurn = 100;
    double aroundBall = 240;

    static constexpr auto fields() {
      return std::tuple{
          field("maxForward", &Parameters::maxForward, "mm/s", "fastest walk ahead", {10, 400}),
          field("maxSideways", &Parameters::maxSideways, "mm/s", "fastest walk sideways and back",
                {10, 400}),
          field("maxTurn", &Parameters::maxTurn, "degree/s", "fastest turn", {10, 200}),
          field("aroundBall", &Parameters::aroundBall, "mm", "radius of the way round the ball",
                {100, 1000})};
    }
  };

  BasicBehaviors(const WorldState& world, MotionRequest& request, const Parameters& parameters)
      : world_{world}, request_{request}, parameters_{parameters} {}

  void stand() override;
  void getup() override;
  /// Speeds in mm/s and degrees/s.
  void walk(double x, double y, double turn) override;
  void performSpecialAction(SpecialAction action) override;
  /// Walks to a pose on the field, keeping clear of team mates. The nearer it comes the slower; far
  /// away it walks ahead.
  void goToPoint(double x, double y, double angle, double maxSpeed) override;
  /// Walks behind the ball so that it lies at (x, y) before the robot, which then faces a direction
  /// on the field; goes round the ball where it would else push it the wrong way.
  void goToBall(double direction, double x, double y) override;

 private:
  /// Sets the speed to walk by an offset and to turn by an angle, within the limits.
  void approach(const Vector2d& offset, double turn, double maxSpeed);
  Vector2d avoidMates(const Vector2d& offset) const;

  const WorldState& world_;
  MotionRequest& request_;
  const Parameters& parameters_;
};

}  // namespace gt
