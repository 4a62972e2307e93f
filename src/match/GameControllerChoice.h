#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "match/GameControllerLink.h"
#include "simulation/rules/GameController.h"

namespace gt {

/// Decides which of the received messages are followed. The first game controller leads until it
/// has been silent for some time. Messages that were overtaken by later ones are ignored. Senders
/// that are not followed are reported, once for each sender and reason.
class GameControllerChoice {
 public:
  /// The message, if it is to be followed.
  std::optional<GameControllerMessage> take(const Datagram& datagram);
  /// Lines for the user that were not taken yet.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  void refuse(const std::string& sender, const std::string& reason, const std::string& text);

  std::string leader_;      ///< Empty until there is one.
  std::int64_t heard_ = 0;  ///< When the leader's last message was received (ms).
  std::optional<int> packet_;
  std::set<std::string> reported_;
  std::vector<std::string> news_;
};

}  // namespace gt
