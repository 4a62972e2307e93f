#include "match/GameControllerChoice.h"

#include <utility>

namespace gt {
namespace {

/// Time after which a silent game controller is taken for gone, as by robots of the league. A game
/// controller sends twice a second.
constexpr std::int64_t silence = 2000;  // ms
/// Greatest number of senders and reasons that are reported, since anybody may send.
constexpr std::size_t mostReported = 32;

/// Whether a message was sent before another one, by their numbers modulo 256.
bool isOlder(int packet, int than) {
  constexpr int numbers = 256;
  return (packet - than + numbers) % numbers > numbers / 2;
}

}  // namespace

std::optional<GameControllerMessage> GameControllerChoice::take(const Datagram& datagram) {
  auto message = parseGameController(datagram.bytes);
  if (!message) {
    const Error& error = message.error();
    refuse(datagram.sender, error.field, error.field + " " + error.what);
    return {};
  }
  const bool silent = leader_.empty() || datagram.time - heard_ >= silence;
  if (!silent && datagram.sender != leader_) {
    refuse(datagram.sender, leader_, leader_ + " leads");
    return {};
  }
  if (!silent && message->packet && packet_ && isOlder(*message->packet, *packet_)) return {};
  if (datagram.sender != leader_)
    news_.push_back("game controller " + datagram.sender + " leads the game" +
                    (leader_.empty() ? "" : ", since " + leader_ + " is silent"));
  leader_ = datagram.sender;
  heard_ = datagram.time;
  packet_ = message->packet;
  return *std::move(message);
}

void GameControllerChoice::refuse(const std::string& sender, const std::string& reason,
                                  const std::string& text) {
  if (reported_.size() >= mostReported || !reported_.insert(sender + " " + reason).second) return;
  news_.push_back("game controller " + sender + " is not followed: " + text);
  if (reported_.size() == mostReported)
    news_.push_back("further game controllers that are not followed are not reported");
}

}  // namespace gt
