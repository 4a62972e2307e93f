#pragma once
#include <vector>

#include "base/Enum.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "simulation/parameters/RuleParameters.h"
#include "simulation/world/World.h"

namespace gt {

/// A robot that breaks a rule, and the penalty for it.
struct Foul {
  std::size_t robot;
  Penalty penalty;
};

/// Detects all fouls that the rules of 2003 penalize (facts, 2.2). An offense becomes a foul after
/// a time; the time of an offense that ends earlier is counted down twice as fast as it was counted
/// up.
class FoulWatch {
 public:
  FoulWatch(const RuleParameters& rules, const FieldDimensions& field,
            const std::vector<Player>& players);

  /// The fouls whose time was reached in this tick of play. `away` states which robots are not on
  /// the field; `kickOff` is the team that has to play the ball first, null once it has.
  const std::vector<Foul>& update(const World& world, const std::vector<bool>& away,
                                  const TeamColor* kickOff);
  /// Forgets all offenses: play begins anew.
  void reset();

  const RuleParameters& rules() const { return rules_; }
  void change(const RuleParameters& rules) { rules_ = rules; }

 private:
  /// The offenses of one robot.
  struct Record {
    EnumArray<Penalty, double> seconds;  ///< Since it began, for each penalty.
    /// Position of the ball relative to the robot (mm) when it began to hold the ball.
    Vector2d heldAt = Vector2d::Zero();
  };

  double limit(std::size_t robot, Penalty penalty, const World& world) const;
  void look(const World& world, std::size_t robot, const TeamColor* kickOff,
            EnumArray<Penalty, bool>& offends);
  bool holdsBall(const World& world, std::size_t robot);
  bool inOwnArea(const World& world, std::size_t robot) const;
  bool obstructs(const World& world, std::size_t robot, std::size_t pushed) const;

  RuleParameters rules_;
  FieldDimensions field_;
  std::vector<Player> players_;
  std::vector<Record> records_;
  std::vector<EnumArray<Penalty, bool>> offends_;
  std::vector<Foul> fouls_;
};

}  // namespace gt
