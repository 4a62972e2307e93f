#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "match/GameControllerLink.h"
#include "match/MatchState.h"
#include "match/MatchStatistics.h"
#include "match/MatchSummary.h"
#include "match/RemoteRobot.h"
#include "match/SimulatedRobot.h"
#include "simulation/Simulation.h"

namespace gt {

/// How a match is to be played.
struct MatchOptions {
  DataRoot root{};  ///< Where the files below lie by default.
  std::string scene = root.path("scenes/match.scene");
  double minutes = 10;  ///< Both halves together.
  std::uint64_t seed = 1;
  std::size_t threads = 1;  ///< Do not change what happens.
  std::string
      logs{};  ///< Folder for the robots' logs, which must exist; none are written if empty.
  bool inputs = false;  ///< Whether the logs hold all images without loss, for other vision.
  bool trace = false;   ///< Whether the logs hold what the behavior decided, and why.
  int pictures = 0;     ///< How many camera pictures to keep for the report page.
  std::string behavior = root.path("behavior/GT2003.xabsl");
  std::string motions = root.path("motions");
  std::string layout{};  ///< Of all robots, instead of what the scene says, if not empty.
  /// Robots whose processes are programs of their own and connect to the simulation: for each name
  /// where it listens for them, such as tcp://10.0.1.5:5003; on this machine, if that is empty.
  std::map<std::string, std::string> remote{};
  std::string sockets{};       ///< Folder in which they find it; the user's default if empty.
  std::optional<Keys> keys{};  ///< For robots on other machines.
  /// UDP port on which a game controller may lead the game; 0 if none may. Its own is 3838.
  int gameControllerPort = 0;
};

/// A simulated match of robots that run their own programs: the simulator, the robots in it, their
/// logs, and what is to be known about it all afterwards.
class Match {
 public:
  /// Loads scene, configuration, layouts, motions and behavior; the first error tells file, line
  /// and field.
  static Result<std::unique_ptr<Match>> make(const MatchOptions& options);

  /// One tick of 8 ms.
  void step();
  /// The referee has ended the game; in a scene without one, its time is over.
  bool finished() const {
    const auto& game = simulation_->scene().game;
    return simulation_->finished() ||
           (!game.referee && static_cast<double>(time().ms) >= game.minutes * 60000);
  }
  Time time() const { return simulation_->time(); }

  /// Carries out again what was done by the console: a command line.
  using Perform = std::function<Result<void>(Match& match, const std::string& line)>;
  /// Writes the state to a file. Fails if what happened cannot be repeated (`spoil`).
  Result<void> save(const std::string& path) const;
  /// A match in the state of a file, from which it goes on with the same bits as the one that was
  /// saved. `options` tells threads, logs, pictures; the rest stands in the file. Fails if the
  /// match comes out as another one, because files or programs have changed since.
  static Result<std::unique_ptr<Match>> load(const std::string& path, MatchOptions options,
                                             const Perform& perform);
  /// Does what a game controller's message says; an error if it is none.
  Result<void> control(std::span<const std::byte> message);
  /// Where a game controller is heard, if one may lead.
  const GameControllerLink* gameController() const { return gameController_.get(); }
  /// Remembers what was just done to the match from outside, for `save`.
  void note(InterventionKind kind, std::string line);
  const std::vector<Intervention>& history() const { return history_; }
  /// Tells why nobody can repeat what happens from now on; the first reason counts.
  void spoil(const std::string& why);

  /// Closes the logs and tells the first error that happened in writing one.
  Result<void> close();

  const MatchOptions& options() const { return options_; }
  Simulation& simulation() { return *simulation_; }
  /// The robots whose processes run in here.
  const std::vector<SimulatedRobot*>& robots() const { return robots_; }
  /// The index in the simulation of each of them.
  std::size_t robotIndex(std::size_t robot) const { return indices_[robot]; }
  const Configuration& configuration() const { return *configuration_; }
  const std::shared_ptr<const Configuration>& sharedConfiguration() const { return configuration_; }
  /// Those whose processes run elsewhere.
  const std::vector<RemoteRobot*>& remoteRobots() const { return remoteRobots_; }
  const MatchStatistics& statistics() const { return *statistics_; }
  MatchSummary summary() const;
  /// The time that each task took so far, over all robots, and the parts of the simulator.
  std::vector<PartTime> times() const;
  struct Picture {
    std::string title;
    Image image;
    std::vector<Drawing> drawings;
  };
  const std::vector<Picture>& pictures() const { return pictures_; }

 private:
  explicit Match(const MatchOptions& options) : options_{options} {}
  Result<void> addRobots(const std::shared_ptr<const Configuration>& configuration);
  Result<void> addRobot(std::size_t index, const Layout& layout,
                        const std::shared_ptr<const Configuration>& configuration);
  Result<void> addRemoteRobot(std::size_t index, const Layout& layout);
  bool isRemote(const std::string& robot) const;
  std::uint64_t fingerprint() const;
  Result<void> repeat(const MatchState& state, const Perform& perform);
  void hearGameController();
  void answerGameController(int version) const;
  void keepPicture();

  MatchOptions options_;
  std::vector<Intervention> history_;
  std::string spoiled_;  ///< Why the match cannot be repeated; empty if it can.
  std::shared_ptr<const Configuration> configuration_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<GameControllerLink> gameController_;
  std::optional<GameControllerMessage> lastControl_;
  // All robots are owned by the simulation, and here in the order of its active ones.
  std::vector<MatchRobot*> allRobots_;
  std::vector<SimulatedRobot*> robots_;
  std::vector<std::size_t> indices_;  ///< In the simulation, of each of robots_.
  std::vector<RemoteRobot*> remoteRobots_;
  std::unique_ptr<MatchStatistics> statistics_;
  std::vector<Picture> pictures_;
  int requestedPicture_ = -1;  ///< The robot whose next picture is kept.
};

/// What happened, for people: one line.
std::string describe(const GameEvent& event);

}  // namespace gt
