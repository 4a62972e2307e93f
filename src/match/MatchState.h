#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// Where something that was done to a match came from.
enum class InterventionKind { console, gameController };

/// Something that was done to a match from outside, between two ticks.
struct Intervention {
  Time time;
  InterventionKind kind = InterventionKind::console;
  std::string line;

  static constexpr auto fields() {
    return Fields{
        field("time", &Intervention::time, "ms", "the tick after which it was done"),
        field("kind", &Intervention::kind),
        field(
            "line", &Intervention::line, "",
            "console: a command line; gameController: the message's bytes as hexadecimal digits")};
  }
};

/// A whole simulation at a moment, with all that the robots' programs remember: saved by
/// `Match::save`, continued by `Match::load`.
///
/// All that a match does follows from its files, its seed and what was done to it. So these are its
/// state; loading lives through them again, without waiting for anybody, and compares what comes
/// out with the fingerprint. Writing down the memory of the robots' programs instead would need
/// code in every module, forget what a module's author forgot, and be wrong with each change of a
/// module; this is right for modules that nobody has written yet. The price is time: a minute of a
/// match takes some seconds to load.
struct MatchState {
  std::string scene, layout, behavior, motions;
  double minutes = 0;
  std::uint64_t seed = 0;
  Time time;
  std::vector<Intervention> history;
  std::uint64_t fingerprint = 0;

  static constexpr auto fields() {
    return Fields{
        field("scene", &MatchState::scene, "", "file"),
        field("layout", &MatchState::layout, "", "of all robots, if not empty"),
        field("behavior", &MatchState::behavior, "", "agents file"),
        field("motions", &MatchState::motions, "", "folder"),
        field("minutes", &MatchState::minutes, "min", "both halves together", {0.01, 1e4}),
        field("seed", &MatchState::seed),
        field("time", &MatchState::time, "ms", "how far it has come"),
        field("history", &MatchState::history, "", "in the order of time"),
        field("fingerprint", &MatchState::fingerprint, "", "of world and robots")};
  }
};

}  // namespace gt
