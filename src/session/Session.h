#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foxglove/FoxgloveServer.h"
#include "match/Match.h"
#include "session/ConsoleRobot.h"
#include "session/RobotConnection.h"
#include "simulation/objects/SceneTree.h"

namespace gt {

/// Where a console prints. Provided by the program.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual void print(std::string_view line) = 0;
  virtual void clear() {}  ///< Report I.5.2: cls.
  /// Called after each step.
  virtual void stepped() {}
};

/// How simulated time goes by (report I.5.2: st).
struct Pace {
  double factor = 0;    ///< Times real time at most; 0 as fast as it goes.
  double slowness = 0;  ///< Of the robots' computers against this one; 0: they take no time.
};

/// A simulation that a console works on: a scene with its robots, robots on logs, robots elsewhere,
/// and the clock. Time passes while it runs: by `run`, or from `start` to `stop` by `update`.
/// Messages of robots elsewhere are passed on in both cases.
class Session {
 public:
  static Result<std::unique_ptr<Session>> make(const MatchOptions& options, Screen& screen);

  /// Starts again with another scene, seed, or whatever is different. Robots on logs and elsewhere
  /// are gone, and nothing has been done yet. An error leaves all as it was, but that the match's
  /// logs are closed.
  Result<void> restart(const MatchOptions& options);
  const MatchOptions& options() const { return options_; }
  /// Resumes a match from where it was saved (Match::save): starts again and repeats what was done
  /// to it, by `perform`. An error leaves all as it was, but that the match's logs are closed.
  Result<void> load(const std::string& file,
                    const std::function<Result<void>(const std::string& line)>& perform);

  Match& match() { return *state_.match; }
  Simulation& simulation() { return state_.match->simulation(); }
  /// All objects of the scene, by path.
  SceneTree& tree();
  Time time() const { return state_.match->time(); }
  /// One step of 8 ms, at the session's pace; false if the game is over.
  bool step();
  enum class RunEnd { done, gameOver, interrupted };
  /// Takes steps until `done` returns true, which is asked before each of them.
  RunEnd run(const std::function<bool()>& done);

  /// Lets time pass in `update` from now on.
  void start();
  void stop() { started_ = false; }
  bool started() const { return started_; }
  /// What happens while a person types: takes steps if the session was started, and passes messages
  /// on. Returns after `atMost`, or as soon as there is nothing to do.
  void update(std::chrono::milliseconds atMost);
  /// Passes messages of robots elsewhere on until `holds` returns true; false if it did not within
  /// `patience`. Simulated time stands.
  bool waitFor(const std::function<bool()>& holds, std::chrono::milliseconds patience);
  /// Ends a run after its current step. Safe in signal handlers and from other threads.
  void interrupt() { interrupted_ = true; }
  /// Whether `interrupt` was called since this was asked last.
  bool takeInterrupt() { return interrupted_.exchange(false); }

  /// Called before each step and in `update`: reads what moves the robots by hand, such as a
  /// joystick.
  void setInput(std::function<void()> input) { input_ = std::move(input); }
  /// Calls `work` after each step, also of later matches, for as long as the handle exists.
  [[nodiscard]] std::shared_ptr<const void> afterSteps(std::function<void()> work);

  /// A robot of the scene first, then those on logs and elsewhere.
  const std::vector<std::unique_ptr<ConsoleRobot>>& robots() const { return state_.robots; }
  ConsoleRobot* find(std::string_view robot) const;

  /// Report I.5.1: sl. A name that is in use is an error. Prints what of the log is damaged. Logs
  /// that have not been played yet begin in step with those that run when they begin.
  /// `colorTable` is for logs of real robots; see LogRobotOptions.
  Result<void> replay(const std::string& name, const std::string& file,
                      const std::string& colorTable = {});
  /// A time to go to on a log, in step with the other logs: not before all those begin that run
  /// when this one begins.
  Time timeOnLog(const LogPlayer& log, Time time) const;
  /// What logs have from this session that hold no setup of their own.
  LogRobotOptions logOptions(const std::string& colorTable = {}) const {
    return {options_.root, state_.match->sharedConfiguration(), colorTable};
  }
  /// Report I.5.1: sc; only once.
  Result<void> connect(const std::vector<std::string>& robots, bool gameManager);

  /// Shows all robots to viewers such as Foxglove and Lichtblick from now on (docs/foxglove.md).
  Result<void> serveFoxglove(const FoxgloveAccess& access);

  /// State of the connection to each robot elsewhere; empty without `sc`.
  std::vector<Router::Statistics> connections() const {
    return state_.connection ? state_.connection->statistics() : std::vector<Router::Statistics>{};
  }

  void setPace(const Pace& pace);
  const Pace& pace() const { return pace_; }

  Screen& screen() { return screen_; }
  std::string behavior = {};  ///< Agents file that `xlb` loaded last; empty: that of the options.

 private:
  using Clock = std::chrono::steady_clock;

  void alignLogs();

  /// What belongs to one match.
  struct State {
    // Both must outlive the robots.
    std::unique_ptr<Match> owned;
    std::unique_ptr<RobotConnection> connection;
    Match* match = nullptr;
    std::unique_ptr<SceneTree> tree;  ///< Once it was asked for.
    std::vector<std::unique_ptr<ConsoleRobot>> robots;
    std::size_t reportedEvents = 0, reportedFailures = 0;
  };

  explicit Session(Screen& screen) : screen_{screen} {}
  void work(Match& match);
  /// One step, without waiting for the clock.
  bool tick();
  /// Passes on and takes what robots elsewhere send while time stands.
  void listen();
  void reportNews();
  void updateFoxglove();
  /// When the next step is due; empty if steps are taken as fast as possible.
  std::optional<Clock::time_point> due();
  /// Begins to measure from now on.
  void beginPace();
  /// Reports once for each pace if time passes more slowly.
  void reportSlowness();

  Screen& screen_;
  MatchOptions options_;
  State state_;
  Pace pace_;
  Clock::time_point paceBegin_ = Clock::now();
  Time paceTime_;
  Clock::time_point paceSince_ = paceBegin_;  ///< Where paceBegin_ was before steps came too late.
  bool slownessReported_ = false;
  bool started_ = false;
  std::atomic<bool> interrupted_ = false;
  std::function<void()> input_;
  std::unique_ptr<FoxgloveServer> foxglove_;  ///< Null if there is none.
  std::vector<std::weak_ptr<const std::function<void()>>> listeners_;
};

}  // namespace gt
