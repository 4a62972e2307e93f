#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "match/MatchRobot.h"
#include "match/MatchSummary.h"
#include "simulation/Simulation.h"

namespace gt {

/// What always holds in a match: what does not is a fault of the simulator, or of a robot's program,
/// and no matter of how well it plays.
struct Invariant {
  std::string_view name;
  Severity severity = Severity::error;
  std::int64_t patience = 0;  ///< ms, for which it may not hold.
  std::string_view holds;     ///< In one sentence.
};
inline constexpr std::array invariants{
    Invariant{"apart", Severity::error, 0, "no robot is inside another one"},
    Invariant{"carpet", Severity::error, 0, "balls and robots are between the outer walls"},
    Invariant{"finite", Severity::error, 0,
              "where things are, what robots command and what they believe are numbers"},
    Invariant{"believed", Severity::warning, 20'000,
              "a robot that plays believes to be within 1 m of where it is"},
    Invariant{"radio", Severity::error, 0,
              "a teammate's message is as old as the radio's delay and its maker's cycle"},
    Invariant{"running", Severity::error, 0, "each process of a robot ran in the last 0.5 s"},
    Invariant{"solved", Severity::warning, 0,
              "somebody provides what a robot commands and believes"}};

/// Checks a match after each tick, and notes when what did not hold.
class Invariants {
 public:
  /// The robots are those of the simulation, in its order; both must outlive it.
  Invariants(const Simulation& simulation, const std::vector<MatchRobot*>& robots);

  /// To be called after each tick.
  void update();
  /// In the order in which they began; those that were over before their invariant's patience was
  /// are left out.
  std::vector<BrokenInvariant> broken() const;

 private:
  /// A time during which one did not hold.
  struct Break {
    std::size_t invariant = 0;
    BrokenInvariant what;
    double worst = 0;
  };

  /// It does not hold now, by so much, which `text` tells.
  void note(std::string_view invariant, const std::string& who, double amount, std::string text);
  void checkApart();
  /// Whose a geom of the world's model is; empty if it is no robot's.
  std::optional<std::size_t> robotOf(int geom) const;
  void checkCarpet();
  void checkFinite();
  void checkBelieved();
  void checkRadio();
  void checkPrograms();

  const Simulation& simulation_;
  const std::vector<MatchRobot*>& robots_;
  Vector2d walls_ = Vector2d::Zero();  ///< Of the outer walls, from the middle (mm).
  std::int64_t divergences_ = 0;
  std::vector<Break> breaks_;
};

}  // namespace gt
