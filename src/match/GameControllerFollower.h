#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "match/GameControllerChoice.h"
#include "match/GameControllerLink.h"
#include "match/MatchRobot.h"

namespace gt {

/// Lets a game controller lead a match: passes its messages to the referee, and answers them for
/// the robots that are on.
class GameControllerFollower {
 public:
  /// Both must outlive the follower. `robots` are the simulation's active ones, in its order.
  GameControllerFollower(Simulation& simulation, const std::vector<MatchRobot*>& robots)
      : simulation_{simulation}, robots_{robots} {}

  /// Listens on a UDP port; 0 takes a free one.
  Result<void> listen(const Endpoint& endpoint);
  /// The port on which it listens; empty if it does not.
  std::optional<int> port() const { return link_ ? std::optional{link_->port()} : std::nullopt; }

  /// Called with each message that changed the game.
  using Note = std::function<void(std::span<const std::byte> message)>;
  /// Applies and answers the messages that have arrived since the last call. Does not block.
  void hear(const Note& note);
  /// Lines for the user about who leads and who is not followed, that were not taken yet.
  std::vector<std::string> takeNews() { return choice_.takeNews(); }
  /// Applies a message, whoever sent it. Returns whether it contained anything new, or an error if
  /// it is no message of a game controller.
  Result<bool> follow(std::span<const std::byte> message);

 private:
  bool follow(const GameControllerMessage& message);
  void answer() const;

  Simulation& simulation_;
  const std::vector<MatchRobot*>& robots_;
  std::unique_ptr<GameControllerLink> link_;
  GameControllerChoice choice_;
  std::optional<GameControllerMessage> last_;
};

}  // namespace gt
