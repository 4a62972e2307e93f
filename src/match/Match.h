#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "match/GameControllerFollower.h"
#include "match/Invariants.h"
#include "match/LockstepRobot.h"
#include "match/MatchState.h"
#include "match/MatchStatistics.h"
#include "match/MatchSummary.h"
#include "match/MatchTeams.h"
#include "match/RemoteRobot.h"
#include "match/ReportImages.h"
#include "match/SimulatedRobot.h"
#include "simulation/Challenge.h"
#include "simulation/Simulation.h"

namespace gt {

/// The setup of a match, and the options for running it.
struct MatchOptions : MatchSetup {
  MatchOptions() : MatchOptions{DataRoot{}} {}
  explicit MatchOptions(DataRoot from) : MatchSetup{in(from)}, root{std::move(from)} {}

  DataRoot root;            ///< Where the files of the setup lie by default.
  std::size_t threads = 1;  ///< Number of threads, which does not influence the results.
  std::string
      logs{};  ///< Folder for the robots' logs, which must exist; none are written if empty.
  bool inputs = false;  ///< Whether the logs hold all images without loss, for other vision.
  bool check = false;   ///< Whether the invariants are checked after each tick (Invariants.h).
  int images = 0;       ///< How many camera images to keep for the report page.
  /// Longest time that a team's program may take for an answer; one that takes longer ends the
  /// match.
  std::chrono::milliseconds patience = std::chrono::seconds{60};
  /// Robots whose processes are programs of their own and connect to the simulation: for each name
  /// the endpoint at which the simulation listens for them, such as tcp://10.0.1.5:5003; on this
  /// machine, if that is empty.
  std::map<std::string, std::string> remote{};
  std::string sockets{};       ///< Folder of the sockets for them; the user's default if empty.
  std::optional<Keys> keys{};  ///< For robots on other machines.
  /// Where the match listens for a game controller by UDP: PORT on the loopback device, or
  /// ADDRESS:PORT; port 0 takes a free one. The league's port is 3838. Empty: it does not listen.
  std::string gameController{};
};

/// A failure of a robot's program. The error's field names the robot.
struct RobotFailure {
  Time time;
  std::size_t robot = 0;  ///< Index in the simulation.
  Error error;
};

/// A simulated match of robots that run their own programs: the simulator, the robots in it, their
/// logs, and the results: a summary, times, images.
class Match {
 public:
  /// Loads scene, configuration, layouts, motions and behavior; the first error names file, line
  /// and field.
  static Result<std::unique_ptr<Match>> make(const MatchOptions& options);

  /// Simulates one tick of 8 ms.
  void step();
  /// Whether the referee has ended the game; in a scene without one, whether its time is over. Also
  /// if a team has failed.
  bool finished() const {
    const GameParameters& game = simulation_->referee().parameters();
    return simulation_->finished() || !teamFailure() || (challenge_ && challenge_->finished()) ||
           (!game.referee && static_cast<double>(time().ms) >= game.minutes * 60'000);
  }
  Time time() const { return simulation_->time(); }
  /// An error if a team's program died or did not answer, with which the match ends.
  Result<void> teamFailure() const;
  /// The failures of robots' programs, in the order of time: those that ended the match, and those
  /// by an exception of a module, after which the robot stands while the others play.
  const std::vector<RobotFailure>& failures() const { return failures_; }
  /// The first failure as an error: the results of such a match are meaningless.
  Result<void> soundness() const;

  /// Executes a recorded console command.
  using Perform = std::function<Result<void>(Match& match, const std::string& line)>;
  /// Writes the state to a file. Fails if the match cannot be repeated (`markIrreproducible`).
  Result<void> save(const std::string& path) const;
  /// Loads a match in the state of a file, which continues with the same bits as the one that was
  /// saved. `options` provides threads, logs, images; the rest comes from the file. Fails if the
  /// result is another match, because files or programs have changed since.
  static Result<std::unique_ptr<Match>> load(const std::string& path, MatchOptions options,
                                             const Perform& perform);
  /// Applies a game controller's message. Fails if the bytes are no such message.
  Result<void> control(std::span<const std::byte> message);
  /// The UDP port on which the match listens for a game controller; empty if it does not.
  std::optional<int> gameControllerPort() const { return gameController_->port(); }
  /// Lines for the user about which game controller leads and which ones are not followed, that
  /// were not taken yet.
  std::vector<std::string> takeGameControllerNews() { return gameController_->takeNews(); }
  /// Records an intervention that was just made, for `save`.
  void note(InterventionKind kind, std::string line);
  const std::vector<Intervention>& history() const { return history_; }
  /// Plays a new match up to a time and repeats the interventions in another one up to then, each
  /// at its time. Fails if the match is over before, or if `interrupted` returns true.
  Result<void> repeat(
      std::span<const Intervention> history, Time until, const Perform& perform,
      const std::function<bool()>& interrupted = [] { return false; });
  /// Marks the match irreproducible from now on, with a reason. The first reason counts.
  void markIrreproducible(const std::string& why);

  /// Closes the logs. Returns the first error that happened while one was written.
  Result<void> close();
  /// Returns once the first error of each log that can no longer be written. The match continues
  /// without these logs.
  std::vector<Error> takeLogErrors();

  const MatchOptions& options() const { return options_; }
  Simulation& simulation() { return *simulation_; }
  /// Null if the scene is none of the challenges.
  const Challenge* challenge() const { return challenge_; }
  /// The robots whose processes run in this program.
  const std::vector<SimulatedRobot*>& robots() const { return robots_; }
  /// The index in the simulation of an element of `robots`.
  std::size_t robotIndex(std::size_t robot) const;
  /// The project's own configuration, which also applies to the field.
  const Configuration& configuration() const { return *teams_.configuration(); }
  const std::shared_ptr<const Configuration>& sharedConfiguration() const {
    return teams_.configuration();
  }
  /// Calls visit(index in the simulation, robot) for each robot of a kind.
  template <typename Kind, typename Visit>
  void forEachRobot(const Visit& visit) const {
    for (std::size_t i = 0; i < allRobots_.size(); ++i)
      if (auto* robot = dynamic_cast<Kind*>(allRobots_[i])) visit(i, *robot);
  }
  /// The robots whose processes are programs of their own.
  std::vector<const RemoteRobot*> remoteRobots() const;
  const MatchStatistics& statistics() const { return *statistics_; }
  MatchSummary summary() const;
  /// The computing time of each task so far, over all robots, and of the simulator's parts.
  std::vector<PartTime> times() const;
  /// The robots' images that were kept.
  const std::vector<ReportImage>& images() const { return images_->all(); }

 private:
  explicit Match(const MatchOptions& options) : options_{options} {}
  const MatchTeam& teamOf(const SceneRobot& robot) const { return teams_.of(robot.team); }
  /// Sets the kicks of each robot in the world from its team's motions.
  Result<void> setKicks();
  std::vector<std::vector<std::string>> kicks() const;  ///< Of each robot.
  Result<void> addRobots();
  Result<void> addRobot(std::size_t index, const Layout& layout);
  std::uint64_t seedOf(const SceneRobot& robot) const;
  SetupFiles setupOf(const SceneRobot& robot) const;
  void attach(std::unique_ptr<MatchRobot> robot);
  Result<void> beginLogs();
  Result<void> addRemoteRobot(std::size_t index, const Layout& layout);
  Result<void> addLockstepRobot(std::size_t index);
  Result<void> greetLockstepRobots();
  Result<void> checkNames() const;
  /// Whether a robot gets the truth.
  bool getsTruth(const SceneRobot& robot) const;
  bool isRemote(const std::string& robot) const { return options_.remote.contains(robot); }
  std::string layoutFile(const SceneRobot& robot) const;
  std::uint64_t fingerprint() const;
  void noteFailures();
  void addFailures(MatchSummary& summary) const;

  MatchOptions options_;
  std::vector<Intervention> history_;
  std::vector<RobotFailure> failures_;
  std::string irreproducible_;  ///< Why the match cannot be repeated; empty if it can.
  MatchTeams teams_;
  std::unique_ptr<Simulation> simulation_;
  const Challenge* challenge_ = nullptr;  ///< Owned by the simulation.
  // All robots are owned by the simulation, and here in the order of its active ones.
  std::vector<MatchRobot*> allRobots_;
  std::vector<SimulatedRobot*> robots_;  ///< Those whose processes run in this program.
  std::unique_ptr<GameControllerFollower> gameController_;
  std::unique_ptr<MatchStatistics> statistics_;
  std::unique_ptr<Invariants> invariants_;  ///< Null if they are not checked.
  std::unique_ptr<ReportImages> images_;
  std::optional<McapWriter> ceilingLog_;  ///< Log of the ceiling camera's percepts.
};

}  // namespace gt
