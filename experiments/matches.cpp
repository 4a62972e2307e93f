// Plays matches on several seeds and tells what the issue of a whole match asks for: goals, own
// goals, and how well the robots knew where they were.
#include <vector>

#include "Experiments.h"
#include "InParallel.h"
#include "match/Match.h"

namespace gt {
namespace {

/// What one match says.
struct Row {
  std::uint64_t seed = 0;
  int red = 0, blue = 0, ownGoals = 0, kicks = 0, stuckBalls = 0, penalties = 0;
  double distance = 0;
  ErrorStatistics localization;
  double longestLost = 0;
};

Result<Row> playMatch(std::uint64_t seed, double minutes) {
  MatchOptions options;
  options.seed = seed;
  options.minutes = minutes;
  auto match = Match::make(options);
  if (!match) return match.error();
  Row row;
  row.seed = seed;
  while (!(*match)->finished()) (*match)->step();
  const MatchSummary summary = (*match)->summary();
  row.red = summary.redScore;
  row.blue = summary.blueScore;
  for (const MatchEvent& event : summary.events) {
    row.ownGoals += event.kind == "goal" && event.ownGoal;
    row.stuckBalls += event.kind == "stuckBall";
    row.penalties += event.kind == "penalty";
  }
  for (const RobotSummary& robot : summary.robots) {
    row.distance += robot.distanceWalked / 1000;
    for (const KickCount& kick : robot.kicks) row.kicks += kick.count;
  }
  row.localization = statisticsOf((*match)->statistics().localizationErrors());
  row.longestLost = (*match)->statistics().longestLost();
  return row;
}

/// One match in a thread, as many at once as there are cores; the order of the rows is that of the
/// seeds.
Result<std::vector<Row>> playMatches(const std::vector<std::uint64_t>& seeds, double minutes) {
  std::vector<Result<Row>> results(seeds.size(), Row{});
  inParallel(seeds.size(), [&](std::size_t i) { results[i] = playMatch(seeds[i], minutes); });
  std::vector<Row> rows;
  for (Result<Row>& result : results) {
    if (!result) return result.error();
    rows.push_back(*std::move(result));
  }
  return rows;
}

template <typename Get>
std::vector<double> column(const std::vector<Row>& rows, Get&& get) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(static_cast<double>(get(row)));
  return values;
}

}  // namespace

Result<void> measureMatches(Figures& figures, const ExperimentOptions& options) {
  const auto played = playMatches(options.seeds, options.minutes);
  if (!played) return played.error();
  const std::vector<Row>& rows = *played;
  fmt::print("{:>6} {:>7} {:>4} {:>6} {:>6} {:>9} {:>9} {:>8} {:>8} {:>8} {:>7}\n", "seed", "score",
             "own", "kicks", "stuck", "penalties", "walked m", "median", "p95 mm", "max mm",
             "lost s");
  for (const Row& r : rows)
    fmt::print("{:>6} {:>7} {:>4} {:>6} {:>6} {:>9} {:>9.0f} {:>8.0f} {:>8.0f} {:>8.0f} {:>7.1f}\n",
               r.seed, fmt::format("{}:{}", r.red, r.blue), r.ownGoals, r.kicks, r.stuckBalls,
               r.penalties, r.distance, r.localization.median, r.localization.percentile95,
               r.localization.maximum, r.longestLost);

  const auto goals = column(rows, [](const Row& r) { return r.red + r.blue - r.ownGoals; });
  figures.add("match.goals", "goals", column(rows, [](const Row& r) { return r.red + r.blue; }),
              Aim::atLeast(3));
  figures.add("match.goals.regular", "goals", goals);
  figures.add("match.goals.own", "goals", column(rows, [](const Row& r) { return r.ownGoals; }));
  figures.add("match.kicks", "kicks", column(rows, [](const Row& r) { return r.kicks; }));
  figures.add("match.stuckBalls", "balls", column(rows, [](const Row& r) { return r.stuckBalls; }));
  figures.add("match.penalties", "robots", column(rows, [](const Row& r) { return r.penalties; }));
  figures.add("match.localization.error.median", "mm",
              column(rows, [](const Row& r) { return r.localization.median; }), Aim::atMost(150));
  figures.add("match.localization.error.p95", "mm",
              column(rows, [](const Row& r) { return r.localization.percentile95; }),
              Aim::atMost(600));
  figures.add("match.localization.lost.longest", "s",
              column(rows, [](const Row& r) { return r.longestLost; }));
  return {};
}

}  // namespace gt
