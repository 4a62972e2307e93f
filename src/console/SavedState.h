#pragma once
#include <cstdint>
#include <string>

#include "console/Console.h"

namespace gt {

// The state of a whole simulation as a file: what led to it, that is scene, seed and the commands
// that changed something, with their times. A simulation is determined by these to the last bit, so
// living through them again gives the same state, of every module of every robot, whatever they
// remember; a fingerprint in the file proves it. Robots on logs and elsewhere cannot be saved.

Result<void> saveState(Session& session, const std::string& file);
/// Begins anew and lives through what the file says; an error if the file is wrong, or if this
/// program does not come to the same state.
Result<void> loadState(Console& console, const std::string& file);

/// Of all that a simulation consists of by now: bodies, balls, the game, and what the robots'
/// modules provide.
std::uint64_t fingerprint(Session& session);

/// Does again what was done to another simulation, at once (up to a time of 0) or when it is due.
Result<void> repeat(Console& console, const std::vector<Session::Deed>& deeds);

}  // namespace gt
