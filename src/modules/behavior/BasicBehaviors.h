#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/WorldState.h"
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

    static constexpr auto fields() {
      return Fields{
          field("maxForward", &Parameters::maxForward, "mm/s", "fastest walk ahead", {10, 400}),
          field("maxSideways", &Parameters::maxSideways, "mm/s", "fastest walk sideways and back",
                {10, 400}),
          field("maxTurn", &Parameters::maxTurn, "degree/s", "fastest turn", {10, 200}),
          field("aroundBall", &Parameters::aroundBall, "mm", "radius of the way round the ball",
                {100, 1000})};
    }
  };

  Movement(const WorldState& world, MotionRequest& request, const Parameters& parameters)
      : world_{world}, request_{request}, parameters_{parameters} {}

  const WorldState& world() const { return world_; }
  const Parameters& parameters() const { return parameters_; }

  void stand() { request_ = {MotionType::stand, WalkType::normal, {}, SpecialAction::none}; }
  void getup() { request_ = {MotionType::getup, WalkType::normal, {}, SpecialAction::none}; }
  void perform(SpecialAction action) {
    request_ = {MotionType::specialAction, WalkType::normal, {}, action};
  }
  /// Speeds in mm/s and rad/s.
  void walk(const Vector2d& speed, double turn);
  /// Walks by an offset in mm and turns by an angle, ever slower.
  void approach(const Vector2d& offset, double turn, double maxSpeed);
  /// An offset of the same length that leads past team mates on the way.
  Vector2d avoidMates(const Vector2d& offset) const;

 private:
  const WorldState& world_;
  MotionRequest& request_;
  const Parameters& parameters_;
};

/// A skill that the behavior's options end in (report 3.8.2, 3.8.3); its parameters are members of
/// the class that is generated from behavior/basic_behaviors.xabsl, angles in degrees, as people
/// write them in XABSL.
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

/// Walks to a pose on the field, keeping clear of team mates. The nearer it comes the slower; far
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
