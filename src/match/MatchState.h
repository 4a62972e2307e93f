#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "match/MatchSetup.h"
#include "streams/Reflection.h"

namespace gt {

/// The source of an intervention in a match.
enum class InterventionKind { console, gameController };

/// An intervention in a match from outside, between two ticks.
struct Intervention {
  Time time;
  InterventionKind kind = InterventionKind::console;
  std::string line;

  static constexpr auto fields() {
    return Fields{
        field<&Intervention::time>(Unit::ms, "time of the tick after which it was made"),
        field<&Intervention::kind>(),
        field<&Intervention::line>(
            "command line of the console, or a game controller's message as hexadecimal digits")};
  }
};

/// The state of a whole simulation at a moment, including the memory of the robots' programs: saved
/// by `Match::save`, continued by `Match::load`.
///
/// A match is determined by its files, its seed and the interventions. So these are its state;
/// loading plays the match again up to that moment, as fast as possible, and compares the
/// fingerprints. Saving the memory of the robots' programs instead would need code in every module,
/// and each field that a module's author forgets would be a silent error; this is right for every
/// module. The price is time: a minute of a match takes some seconds to load.
struct MatchState : MatchSetup {
  Time time;
  std::vector<Intervention> history;
  std::uint64_t fingerprint = 0;

  MatchState() = default;

  static constexpr auto fields() {
    return MatchSetup::fields() +
           Fields{field<&MatchState::time>(Unit::ms, "time of the match when it was saved"),
                  field<&MatchState::history>("interventions in the order of time"),
                  field<&MatchState::fingerprint>(
                      "fingerprint of world and robots; 0: unknown, so it is not compared")};
  }
};

/// Reads a state from a file. Fails if its times are not times of ticks in ascending order.
Result<MatchState> readMatchState(const std::string& path);

/// The bytes of a message as hexadecimal digits, and back. Anything that is no digit counts as 0.
std::string hexOf(std::span<const std::byte> bytes);
std::vector<std::byte> bytesOf(std::string_view hex);

}  // namespace gt
