#pragma once
#include <map>
#include <string>
#include <vector>

#include "match/MatchRobot.h"
#include "match/MatchSummary.h"
#include "match/PlayWatch.h"
#include "simulation/Simulation.h"

namespace gt {

/// Compares the beliefs of the robots of a match with the truth, image by image, while the game
/// runs (ready, set, playing), and measures how they play.
class MatchStatistics {
 public:
  /// `kicks` are each robot's special actions that are kicks.
  MatchStatistics(const Simulation& simulation, const std::vector<MatchRobot*>& robots,
                  std::vector<std::vector<std::string>> kicks, const FieldDimensions& field = {});

  /// Looks at the world and the robots after a tick.
  void update();
  /// Fills in the summary's part about the robots, the ball and the play.
  void summarize(MatchSummary& summary) const;
  /// The distances between believed and true positions (mm), of all robots and images.
  std::vector<double> localizationErrors() const;
  /// Whether a robot performs a kick.
  bool kicks(std::size_t robot) const { return records_[robot].kicking; }
  /// The longest time (s) for which a robot's believed position was wrong by more than a meter.
  double longestLost() const;

 private:
  struct RobotRecord {
    std::vector<double> localization, rotation, ball;
    double lostFor = 0, longestLost = 0;  ///< In images.
    std::map<std::string, int> kicks;
    std::string lastAction;
    bool kicking = false;
    BodyState lastState = BodyState::standing;
    int falls = 0;
    std::vector<RobotSample> samples;
  };

  void watchPlay();
  void compare(std::size_t robot);
  void countActions(std::size_t robot);

  const Simulation& simulation_;
  const std::vector<MatchRobot*>& robots_;
  std::vector<std::vector<std::string>> kicks_;
  std::vector<RobotRecord> records_;
  std::vector<Vector2d> ball_;
  PlayWatch play_;
  PlayMoment moment_;            ///< to be seen
  std::size_t notedEvents_ = 0;  ///< of the referee
};

/// Mean, median, 95th percentile and maximum; all 0 of nothing.
ErrorStatistics statisticsOf(const std::vector<double>& errors);

}  // namespace gt
