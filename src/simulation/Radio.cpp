#include "simulation/Radio.h"

#include <cmath>

namespace gt {
namespace {

/// More messages than this to one robot at a time jam the network.
constexpr std::size_t mostUnderway = 256;

}  // namespace

Radio::Radio(const RadioParameters& parameters, const std::vector<Player>& players,
             const Random& random)
    : parameters_(parameters),
      players_(players),
      underway_(players.size()),
      off_(players.size()),
      random_(random) {
  for (auto& messages : underway_) messages.reserve(mostUnderway);
}

void Radio::send(std::size_t sender, const TeamMessage& message, Time now) {
  for (std::size_t i = 0; i < players_.size(); ++i) {
    if (i == sender || players_[i].teamColor != players_[sender].teamColor) continue;
    const double delay = random_.uniform(parameters_.delayMin, parameters_.delayMax);
    const bool cut = parameters_.out || off_[sender] || off_[i];
    if (random_.chance(parameters_.loss) || cut || underway_[i].size() == mostUnderway) {
      ++lost_;
      continue;
    }
    underway_[i].push_back({now + std::llround(delay), message});
    underway_[i].back().message.playerNumber = players_[sender].number();
  }
}

void Radio::receive(std::size_t robot, Time now, TeamMessages& messages) {
  std::erase_if(underway_[robot], [&](const Underway& arriving) {
    if (arriving.due > now) return false;
    const auto index = static_cast<std::size_t>(arriving.message.playerNumber - 1);
    TeamMessages::Received& newest = messages.byPlayer[index];
    if (arriving.message.timeSent >= newest.message.timeSent) newest = {arriving.message, now};
    return true;
  });
}

}  // namespace gt
