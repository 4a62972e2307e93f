#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"
#include "streams/Reflection.h"

namespace gt {

/// How a set of errors is distributed.
struct ErrorStatistics {
  std::int64_t count = 0;
  double mean = 0, median = 0, percentile95 = 0, maximum = 0;

  static constexpr auto fields() {
    return Fields{field<&ErrorStatistics::count>(), field<&ErrorStatistics::mean>(),
                  field<&ErrorStatistics::median>(), field<&ErrorStatistics::percentile95>(),
                  field<&ErrorStatistics::maximum>()};
  }
};

/// An event of a match, as the referee saw it.
struct MatchEvent {
  Time time;
  std::string kind;
  std::string text;
  TeamColor team = TeamColor::red;
  int player = 0;
  bool ownGoal = false;
  int redScore = 0, blueScore = 0;

  static constexpr auto fields() {
    return Fields{
        field<&MatchEvent::time>(Unit::ms),
        field<&MatchEvent::kind>(
            "goal, kickOff, halfTime, stuckBall, kick, end, ...; failure: of a robot's program"),
        field<&MatchEvent::text>("description in one line"),
        field<&MatchEvent::team>("team that the event is about"),
        field<&MatchEvent::player>("number of the player concerned, 1 to 4; 0: none"),
        field<&MatchEvent::ownGoal>(),
        field<&MatchEvent::redScore>("goals of the red team after the event"),
        field<&MatchEvent::blueScore>()};
  }
};

/// A time during which an invariant did not hold (Invariants.h).
struct BrokenInvariant {
  Time time, until;
  Severity severity = Severity::error;
  std::string invariant;
  std::string who;
  std::string text;

  static constexpr auto fields() {
    return Fields{field<&BrokenInvariant::time>(Unit::ms, "time at which the violation began"),
                  field<&BrokenInvariant::until>(Unit::ms),
                  field<&BrokenInvariant::severity>(),
                  field<&BrokenInvariant::invariant>(),
                  field<&BrokenInvariant::who>("robots, process, ball, or the world"),
                  field<&BrokenInvariant::text>("description of the violation at its worst")};
  }
};

/// One moment of a robot, sampled once a second.
struct RobotSample {
  Pose2D pose;
  double localizationError = 0;

  static constexpr auto fields() {
    return Fields{field<&RobotSample::pose>(Unit::mmRad, "true pose in the field's coordinates"),
                  field<&RobotSample::localizationError>(Unit::mm)};
  }
};

/// How often a robot performed a kick.
struct KickCount {
  std::string kick;
  int count = 0;

  static constexpr auto fields() {
    return Fields{field<&KickCount::kick>(), field<&KickCount::count>()};
  }
};

/// The part of a match's summary about one robot.
struct RobotSummary {
  std::string name;
  TeamColor team = TeamColor::red;
  int player = 0;
  PlayerRole role = PlayerRole::goalie;
  ErrorStatistics localizationError;
  ErrorStatistics rotationError;
  ErrorStatistics ballError;
  double distanceWalked = 0;
  int falls = 0;
  int goals = 0;
  int ownGoals = 0;
  std::vector<KickCount> kicks;
  std::string log;
  std::vector<RobotSample> samples;

  static constexpr auto fields() {
    return Fields{
        field<&RobotSummary::name>(),
        field<&RobotSummary::team>(),
        field<&RobotSummary::player>("number of the player, 1 to 4"),
        field<&RobotSummary::role>(),
        field<&RobotSummary::localizationError>(
            Unit::mm, "error of the believed position while the game runs"),
        field<&RobotSummary::rotationError>(Unit::rad,
                                            "error of the believed rotation while the game runs"),
        field<&RobotSummary::ballError>(Unit::mm,
                                        "error of the own ball's position while the ball is seen"),
        field<&RobotSummary::distanceWalked>(
            Unit::mm, "distance walked, summed from second to second, without being carried"),
        field<&RobotSummary::falls>(),
        field<&RobotSummary::goals>(),
        field<&RobotSummary::ownGoals>(),
        field<&RobotSummary::kicks>(),
        field<&RobotSummary::log>("log file, in the folder of this file"),
        field<&RobotSummary::samples>("poses of the robot, one a second")};
  }
};

/// A measure of how a match was played.
struct PlayFigure {
  std::string name;
  std::string unit;
  double value = 0;

  static constexpr auto fields() {
    return Fields{
        field<&PlayFigure::name>(
            "name as in the experiment play.match; a team's figure begins with its color"),
        field<&PlayFigure::unit>(), field<&PlayFigure::value>()};
  }
};

/// The end of a shot: in the goal, at the goalie, at another robot, or off the course to the goal.
enum class ShotEnd { goal, saved, stopped, missed };

/// A ball that rolled to a goal, and the goalie's reaction.
struct ShotSummary {
  Time time;
  TeamColor team = TeamColor::red;
  int robot = -1;
  Vector2d origin = Vector2d::Zero();
  double speed = 0;
  double goalieMoved = 0;
  std::string goalieAction;
  ShotEnd end = ShotEnd::missed;

  static constexpr auto fields() {
    return Fields{
        field<&ShotSummary::time>(Unit::ms),
        field<&ShotSummary::team>("team that shoots"),
        field<&ShotSummary::robot>("index of the robot that touched the ball last; -1: none"),
        field<&ShotSummary::origin>(Unit::mm, "position of the ball at the beginning"),
        field<&ShotSummary::speed>(Unit::mmPerS, "speed of the ball at the beginning"),
        field<&ShotSummary::goalieMoved>(
            Unit::mm, "greatest distance of the goalie from where it stood at the beginning"),
        field<&ShotSummary::goalieAction>("special action that the goalie began; empty: none"),
        field<&ShotSummary::end>()};
  }
};

/// The summary of a match: match.json. The same scene and seed give the same bytes; therefore times
/// measured by the machine's clock are not part of it (MatchTimes).
struct MatchSummary {
  std::string scene;
  std::uint64_t seed = 0;
  Time duration;
  bool interrupted = false;
  int redScore = 0, blueScore = 0;
  std::vector<std::string> truth;
  std::vector<MatchEvent> events;
  std::vector<BrokenInvariant> broken;
  std::vector<PlayFigure> play;
  std::vector<ShotSummary> shots;
  std::vector<RobotSummary> robots;
  std::vector<Vector2d> ball;

  static constexpr auto fields() {
    return Fields{
        field<&MatchSummary::scene>(),
        field<&MatchSummary::seed>(),
        field<&MatchSummary::duration>(Unit::ms, "simulated time"),
        field<&MatchSummary::interrupted>(
            "whether it was ended before its end: by a signal, an error of its script, or a "
            "program that failed"),
        field<&MatchSummary::redScore>(),
        field<&MatchSummary::blueScore>(),
        field<&MatchSummary::truth>("robots that were given the truth; none in a fair match"),
        field<&MatchSummary::events>(),
        field<&MatchSummary::broken>("invariants that did not hold; empty if none was checked"),
        field<&MatchSummary::play>("figures of how both teams played while the game ran"),
        field<&MatchSummary::shots>(),
        field<&MatchSummary::robots>(),
        field<&MatchSummary::ball>(Unit::mm, "true positions of the ball, one a second")};
  }
};

/// The computing time of a part of the system, by the machine's clock.
struct PartTime {
  std::string part;
  std::int64_t count = 0;
  double totalMs = 0;

  static constexpr auto fields() {
    return Fields{field<&PartTime::part>("a task, or a part of the simulator"),
                  field<&PartTime::count>(), field<&PartTime::totalMs>(Unit::ms)};
  }
};

/// The computing times of a match: times.json.
struct MatchTimes {
  double seconds = 0;
  double realTimeFactor = 0;
  int threads = 1;
  std::vector<PartTime> parts;

  static constexpr auto fields() {
    return Fields{field<&MatchTimes::seconds>(Unit::s, "time from the first to the last step"),
                  field<&MatchTimes::realTimeFactor>("simulated time divided by real time"),
                  field<&MatchTimes::threads>(),
                  field<&MatchTimes::parts>("computing times of the parts, over all robots")};
  }
};

/// A camera image with the robot's percepts painted on it, for the report page.
struct ReportPicture {
  std::string title;
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace gt
