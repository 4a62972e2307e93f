#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "match/MatchSummary.h"

namespace gt {

/// Counts how often a condition was true.
struct PlayShare {
  int hits = 0, all = 0;

  void count(bool hit) {
    hits += hit ? 1 : 0;
    ++all;
  }
};

/// Collects the figures of how a match was played. Quantities that were never counted or measured
/// have no figure.
class PlayFigures {
 public:
  void add(std::string name, std::string unit, double value) {
    figures_.push_back({std::move(name), std::move(unit), value});
  }
  /// Adds a share in percent.
  void share(std::string name, const PlayShare& share) {
    if (share.all > 0) add(std::move(name), "%", 100.0 * share.hits / share.all);
  }
  /// Adds mean, median, 95th percentile and worst value.
  void spread(const std::string& name, const std::string& unit, const std::vector<double>& values);

  std::vector<PlayFigure> take() { return std::move(figures_); }

 private:
  std::vector<PlayFigure> figures_;
};

/// A value for each team.
template <typename T>
using PerTeam = std::array<T, 2>;

constexpr std::array<TeamColor, 2> teamColors{TeamColor::red, TeamColor::blue};

constexpr std::size_t indexOf(TeamColor team) {
  return static_cast<std::size_t>(team);
}

/// The name of a team's figure: red.kicks.
inline std::string teamFigure(TeamColor team, const std::string& figure) {
  return std::string{enumName(team)} + '.' + figure;
}

}  // namespace gt
