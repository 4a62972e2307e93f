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

/// The output of a console. Provided by the program.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual void print(std::string_view line) = 0;
  virtual void clear() {}  ///< Report I.5.2: cls.
  /// Called after each step.
  virtual void stepped() {}
};

/// The speed of simulated time (report I.5.2: st).
struct Pace {
  double factor = 0;    ///< Greatest multiple of real time; 0: as fast as possible.
  double slowness = 0;  ///< How many times slower robots' computers are; 0: they take no time.
};

/// A simulation that a console works on: a scene with its robots, robots on logs, remote robots,
/// and the clock. Time passes while it runs: by `run`, or from `start` to `stop` by `update`.
/// Messages of remote robots are forwarded in both cases.
class Session {
 public:
  static Result<std::unique_ptr<Session>> make(const MatchOptions& options, Screen& screen);

  /// Starts again with other options, such as another scene or seed. Removes robots on logs and
  /// remote robots, and clears the history of interventions. After an error the session is
  /// unchanged, except that the match's logs are closed.
  Result<void> restart(const MatchOptions& options);
  const MatchOptions& options() const { return options_; }
  /// Resumes a match from where it was saved (Match::save): starts again and repeats the
  /// interventions by `perform`. After an error the session is unchanged, except that the match's
  /// logs are closed.
  Result<void> load(const std::string& file,
                    const std::function<Result<void>(const std::string& line)>& perform);

  Match& match() { return *state_.match; }
  Simulation& simulation() { return state_.match->simulation(); }
  /// All objects of the scene, by path.
  SceneTree& tree();
  Time time() const { return state_.match->time(); }
  /// Takes one step of 8 ms, at the session's pace. Returns false if the game is over.
  bool step();
  enum class RunEnd { done, gameOver, interrupted };
  /// Takes steps until `done`, which is called before each step, returns true.
  RunEnd run(const std::function<bool()>& done);

  /// From now on, lets time pass in `update`.
  void start();
  void stop() { started_ = false; }
  bool started() const { return started_; }
  /// To be called while a person types: takes steps if the session was started, and forwards
  /// messages. Returns after `atMost`, or as soon as there is nothing to do.
  void update(std::chrono::milliseconds atMost);
  /// Forwards messages of remote robots until `holds` returns true. Returns false if it did not
  /// within `patience`. Simulated time stands.
  bool waitFor(const std::function<bool()>& holds, std::chrono::milliseconds patience);
  /// Ends a run after its current step. Safe in signal handlers and from other threads.
  void interrupt() { interrupted_ = true; }
  /// Whether `interrupt` was called since the last call of this function.
  bool takeInterrupt() { return interrupted_.exchange(false); }

  /// Sets the function that is called before each step and in `update`, which reads devices that
  /// move robots by hand, such as a joystick.
  void setInput(std::function<void()> input) { input_ = std::move(input); }
  /// Calls `work` after each step, also of later matches, for as long as the handle exists.
  [[nodiscard]] std::shared_ptr<const void> afterSteps(std::function<void()> work);

  /// The robots of the scene first, then those on logs and remote ones.
  const std::vector<std::unique_ptr<ConsoleRobot>>& robots() const { return state_.robots; }
  ConsoleRobot* find(std::string_view robot) const;

  /// Adds a robot that runs on a log (report I.5.1: sl). A name that is in use is an error. Prints
  /// warnings about damaged parts of the log. Logs that have not been played yet begin in step with
  /// those that are running at that time. `colorTable` is for logs of real robots; see
  /// LogRobotOptions.
  Result<void> replay(const std::string& name, const std::string& file,
                      const std::string& colorTable = {});
  /// A time on a log, limited so that the log stays in step with the others: not before the
  /// beginning of the logs that run when this one begins.
  Time timeOnLog(const LogPlayer& log, Time time) const;
  /// The options from this session for logs that hold no setup of their own.
  LogRobotOptions logOptions(const std::string& colorTable = {}) const {
    return {options_.root, state_.match->sharedConfiguration(), colorTable};
  }
  /// Connects to remote robots (report I.5.1: sc). An error if they are connected already.
  Result<void> connect(const std::vector<std::string>& robots, bool gameManager);

  /// Serves all robots to viewers such as Foxglove and Lichtblick from now on (docs/foxglove.md).
  Result<void> serveFoxglove(const FoxgloveAccess& access);

  /// State of the connection to each remote robot; empty without `sc`.
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

  /// The state that belongs to one match.
  struct State {
    // Both must outlive the robots.
    std::unique_ptr<Match> owned;
    std::unique_ptr<RobotConnection> connection;
    Match* match = nullptr;
    std::unique_ptr<SceneTree> tree;  ///< Null until it is requested.
    std::vector<std::unique_ptr<ConsoleRobot>> robots;
    std::size_t reportedEvents = 0, reportedFailures = 0;
  };

  explicit Session(Screen& screen) : screen_{screen} {}
  void work(Match& match);
  /// One step, without waiting for the clock.
  bool tick();
  /// Forwards and takes messages of remote robots while time stands.
  void listen();
  void reportNews();
  void updateFoxglove();
  /// When the next step is due; empty if steps are taken as fast as possible.
  std::optional<Clock::time_point> due();
  /// Measures the pace from now on.
  void beginPace();
  /// Reports once for each pace if time passes more slowly.
  void reportSlowness();

  Screen& screen_;
  MatchOptions options_;
  State state_;
  Pace pace_;
  Clock::time_point paceBegin_ = Clock::now();
  Time paceTime_;
  Clock::time_point paceSince_ = paceBegin_;  ///< The value of paceBegin_ before any late step.
  bool slownessReported_ = false;
  bool started_ = false;
  std::atomic<bool> interrupted_ = false;
  std::function<void()> input_;
  std::unique_ptr<FoxgloveServer> foxglove_;  ///< Null if there is none.
  std::vector<std::weak_ptr<const std::function<void()>>> listeners_;
};

}  // namespace gt
