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

/// A condition that always holds in a match. If it does not, the simulator or a robot's program is
/// faulty; this is independent of how well the robot plays.
struct Invariant {
  std::string_view name;
  Severity severity = Severity::error;
  std::int64_t patience = 0;  ///< ms; violations that last less are not reported.
  std::string_view holds;     ///< The condition, in one sentence.
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

/// Checks a match after each tick, and notes when an invariant did not hold.
class Invariants {
 public:
  /// The robots are those of the simulation, in its order; both must outlive it.
  Invariants(const Simulation& simulation, const std::vector<MatchRobot*>& robots);

  /// To be called after each tick.
  void update();
  /// The violations in the order in which they began, without those that lasted less than their
  /// invariant's patience.
  std::vector<BrokenInvariant> broken() const;

 private:
  /// A time during which an invariant did not hold.
  struct Break {
    std::size_t invariant = 0;
    BrokenInvariant what;
    double worst = 0;
  };

  /// The index of an invariant, from its name; another name does not compile.
  struct Name {
    // NOLINTNEXTLINE(google-explicit-constructor): a text is meant to become a name.
    consteval Name(const char* name) {
      while (invariants[index].name != name) ++index;
    }

    std::size_t index = 0;
  };

  /// Notes that an invariant does not hold now. `amount` measures by how much, 0 if that cannot be
  /// measured; `text` describes it.
  void note(Name invariant, const std::string& who, double amount, std::string text);
  void checkApart();
  /// The robot that a geom of the world's model belongs to; empty if there is none.
  std::optional<std::size_t> robotOf(int geom) const;
  void checkCarpet();
  void checkFinite();
  void checkBelieved();
  void checkRadio();
  void checkPrograms();

  const Simulation& simulation_;
  const std::vector<MatchRobot*>& robots_;
  Vector2d walls_;  ///< Distances of the outer walls from the middle (mm).
  std::int64_t divergences_ = 0;
  std::vector<Break> breaks_;
};

}  // namespace gt
