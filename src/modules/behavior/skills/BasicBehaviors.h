#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// Where basic behaviors want to go, made a motion request within the robot's limits.
class Movement {
 public:
  struct Parameters {
    double maxForward = 225;
    double maxSideways = 165;
    double maxTurn = 100;
    double aroundBall = 240;
    double clearance = 250;
    double freeWay = 700;
    double keepOff = 260;
    double stopBefore = 230;

    static constexpr auto fields() {
      return Fields{
          field("maxForward", &Parameters::maxForward, "mm/s", "fastest walk ahead", {10, 400}),
          field("maxSideways", &Parameters::maxSideways, "mm/s", "fastest walk sideways and back",
                {10, 400}),
          field("maxTurn", &Parameters::maxTurn, "degree/s", "fastest turn", {10, 200}),
          field("aroundBall", &Parameters::aroundBall, "mm", "radius of the way round the ball",
                {100, 1000}),
          field("clearance", &Parameters::clearance, "mm",
                "width of a corridor through which the robot walks", {100, 1000}),
          field("freeWay", &Parameters::freeWay, "mm",
                "if the way is free so far, obstacles do not count", {100, 2000}),
          field("keepOff", &Parameters::keepOff, "mm",
                "from the robot's middle to that of another, which it does not come nearer to",
                {0, 1000}),
          field("stopBefore", &Parameters::stopBefore, "mm",
                "from the robot's middle to an obstacle that it does not walk towards any more",
                {0, 1000})};
    }
  };

  Movement(const WorldState& world, MotionRequest& request, const Parameters& parameters)
      : world_{world}, request_{request}, parameters_{parameters} {}

  const WorldState& world() const { return world_; }
  const Parameters& parameters() const { return parameters_; }

  void stand() { request(MotionType::stand); }
  void getup() { request(MotionType::getup); }
  void perform(SpecialAction action) {
    request(MotionType::specialAction);
    request_.specialAction = world_.specialAction(action).name;
  }
  /// Speeds in mm/s and rad/s.
  void walk(const Vector2d& speed, double turn);
  /// Walks by an offset in mm and turns by an angle, ever slower.
  void approach(const Vector2d& offset, double turn, double maxSpeed);
  /// The same from far away: past obstacles on the way, for which the robot faces the direction in
  /// which it walks (report 4.3).
  void approachAvoiding(const Vector2d& offset, double turn, double maxSpeed);

 private:
  /// A speed that does not lead into another robot.
  Vector2d keptFromPlayers(Vector2d speed) const;

  /// A request of a type and nothing else; keeps the memory of the name.
  void request(MotionType type) {
    static const MotionRequest nothing;
    request_ = nothing;
    request_.type = type;
  }

  const WorldState& world_;
  MotionRequest& request_;
  const Parameters& parameters_;
};

/// A skill that the behavior's options end in (report 3.8.2, 3.8.3); its parameters are members of
/// the class that is generated from behavior/skills/basic_behaviors.xabsl, angles in degrees, as
/// people write them in XABSL.
template <typename Declared>
class Skill : public Declared {
 public:
  explicit Skill(Movement& movement) : movement_{movement} {}

 protected:
  Movement& movement_;
};

struct Stand final : Skill<soccer::Stand> {
  using Skill::Skill;
  void execute() override { movement_.stand(); }
};

struct Getup final : Skill<soccer::Getup> {
  using Skill::Skill;
  void execute() override { movement_.getup(); }
};

struct Walk final : Skill<soccer::Walk> {
  using Skill::Skill;
  void execute() override { movement_.walk({x, y}, fromDegrees(turn)); }
};

struct PerformSpecialAction final : Skill<soccer::PerformSpecialAction> {
  using Skill::Skill;
  void execute() override { movement_.perform(id); }
};

/// Walks to a pose on the field, past obstacles. The nearer it comes the slower; far
/// away it walks ahead. Once it has arrived, a small drift of its pose does not set it going again.
class GoToPoint final : public Skill<soccer::GoToPoint> {
 public:
  using Skill::Skill;
  void execute() override;

 private:
  bool arrived_ = false;
};

/// Walks behind the ball so that it lies at (x, y) before the robot, which then faces a direction
/// on the field; goes round the ball where it would else push it the wrong way.
struct GoToBall final : Skill<soccer::GoToBall> {
  using Skill::Skill;
  void execute() override;
};

/// One of each.
struct BasicBehaviors {
  explicit BasicBehaviors(Movement& movement)
      : stand{movement},
        getup{movement},
        walk{movement},
        performSpecialAction{movement},
        goToPoint{movement},
        goToBall{movement} {}

  soccer::BasicBehaviors all() {
    return {stand, getup, walk, performSpecialAction, goToPoint, goToBall};
  }

  Stand stand;
  Getup getup;
  Walk walk;
  PerformSpecialAction performSpecialAction;
  GoToPoint goToPoint;
  GoToBall goToBall;
};

}  // namespace gt
