#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "streams/Reflection.h"

namespace gt {

/// Which match is played: all that it follows from, besides its files and what is done to it
/// meanwhile. The same setup gives the same match, however it is run.
struct MatchSetup {
  std::string scene{}, layout{}, profile{}, fidelity{}, behavior{}, motions{};
  /// Teams with files of their own (TeamFolder.h), as `teamFolder` takes them, or with programs of
  /// their own (TeamProgram.h).
  std::string red{}, blue{};
  /// Robots that are given the truth (OracledWorldState), or teams: red1, blue. A team's own files
  /// cannot ask for it: a solution in its modules.cfg that reads the truth is an error otherwise.
  std::vector<std::string> truth{};
  bool randomChallenge = false;
  double minutes = 0;
  std::uint64_t seed = 1;

  /// The scene `match` with the files of a root: behavior and motions.
  static MatchSetup in(const DataRoot& root) {
    return {.scene = root.path("scenes/match.scene"),
            .behavior = root.path("behavior/GT2003.xabsl"),
            .motions = root.path("motions")};
  }

  static constexpr auto fields() {
    return Fields{
        field<&MatchSetup::scene>("file"),
        field<&MatchSetup::layout>("of all robots, instead of the scene's, if not empty"),
        field<&MatchSetup::profile>(
            "instead of the scene's and of what it says in elements, if not empty"),
        field<&MatchSetup::fidelity>("instead of the scene's, if not empty"),
        field<&MatchSetup::behavior>("agents file"),
        field<&MatchSetup::motions>("folder"),
        field<&MatchSetup::red>("team, if it has files of its own"),
        field<&MatchSetup::blue>("team, if it has files of its own"),
        field<&MatchSetup::truth>("robots and teams that are given the truth"),
        field<&MatchSetup::randomChallenge>(
            "a challenge's start is random, whatever the scene says"),
        field<&MatchSetup::minutes>(Unit::min, "both halves together; 0: the scene's", {0, 1e4}),
        field<&MatchSetup::seed>("matches of one seed are equal")};
  }
};
static_assert(complete<MatchSetup>);

}  // namespace gt
