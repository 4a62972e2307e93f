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

/// Where something that was done to a match came from.
enum class InterventionKind { console, gameController };

/// Something that was done to a match from outside, between two ticks.
struct Intervention {
  Time time;
  InterventionKind kind = InterventionKind::console;
  std::string line;

  static constexpr auto fields() {
    return Fields{
        field<&Intervention::time>(Unit::ms, "the tick after which it was done"),
        field<&Intervention::kind>(),
        field<&Intervention::line>(
            "console: a command line; gameController: the message's bytes as hexadecimal digits")};
  }
};

/// A whole simulation at a moment, with all that the robots' programs remember: saved by
/// `Match::save`, continued by `Match::load`.
///
/// All that a match does follows from its files, its seed and what was done to it. So these are its
/// state; loading plays the match again up to that moment, as fast as it goes, and compares the
/// fingerprints. Writing down the memory of the robots' programs instead would need code in every
/// module, and each field that a module's author forgets would be a silent error; this is right for
/// every module. The price is time: a minute of a match takes some seconds to load.
struct MatchState : MatchSetup {
  Time time;
  std::vector<Intervention> history;
  std::uint64_t fingerprint = 0;

  MatchState() = default;

  static constexpr auto fields() {
    return MatchSetup::fields() +
           Fields{field<&MatchState::time>(Unit::ms, "how far it has come"),
                  field<&MatchState::history>("in the order of time"),
                  field<&MatchState::fingerprint>(
                      "of world and robots; 0: unknown, so it is not compared")};
  }
};

/// Reads a state from a file. Fails if its times are not those of ticks in their order.
Result<MatchState> readMatchState(const std::string& path);

/// The bytes of a message as hexadecimal digits, and back. Anything that is no digit counts as 0.
std::string hexOf(std::span<const std::byte> bytes);
std::vector<std::byte> bytesOf(std::string_view hex);

}  // namespace gt
