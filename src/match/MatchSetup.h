#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "streams/Reflection.h"

namespace gt {

/// All that determines a match, besides its files and the interventions in it. The same setup gives
/// the same match, however it is run.
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
        field<&MatchSetup::scene>("scene file"),
        field<&MatchSetup::layout>("layout of all robots; empty: the scene's layouts"),
        field<&MatchSetup::profile>(
            "profile that replaces the scene's profile and its elements; empty: the scene's"),
        field<&MatchSetup::fidelity>("fidelity of the bodies' motion; empty: the scene's"),
        field<&MatchSetup::behavior>("agents file of the behavior"),
        field<&MatchSetup::motions>("folder of the motions"),
        field<&MatchSetup::red>("team that plays red; empty: the scene's team"),
        field<&MatchSetup::blue>("team that plays blue; empty: the scene's team"),
        field<&MatchSetup::truth>("robots and teams that are given the truth"),
        field<&MatchSetup::randomChallenge>(
            "whether a challenge's start is random even if the scene does not state that"),
        field<&MatchSetup::minutes>(Unit::min, "duration of both halves together; 0: the scene's",
                                    {0, 1e4}),
        field<&MatchSetup::seed>("seed of all random numbers; the same seed gives the same match")};
  }
};
static_assert(complete<MatchSetup>);

}  // namespace gt
