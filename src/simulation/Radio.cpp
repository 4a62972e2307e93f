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
      random_(random),
      breakdowns_(random.fork("breakdowns")) {
  for (auto& messages : underway_) messages.reserve(mostUnderway);
}

bool Radio::isDown(Time now) {
  if (parameters_.bursts == 0) return false;
  const auto lasts = [&](double meanSeconds) {
    return std::llround(-1000 * meanSeconds * std::log(1 - breakdowns_.uniform()));
  };
  const double works = 60 / parameters_.bursts;
  if (changesAt_ == never()) changesAt_ = now + lasts(works);
  while (now >= changesAt_) {
    down_ = !down_;
    changesAt_ = changesAt_ + 1 + lasts(down_ ? parameters_.burstTime : works);
  }
  return down_;
}

void Radio::send(std::size_t sender, const TeamMessage& message, Time now) {
  const bool down = isDown(now);
  for (std::size_t i = 0; i < players_.size(); ++i) {
    if (i == sender || players_[i].teamColor != players_[sender].teamColor) continue;
    const double delay = random_.uniform(parameters_.delayMin, parameters_.delayMax);
    const bool cut = parameters_.out || off_[sender] || off_[i];
    if (random_.chance(parameters_.loss) || cut || underway_[i].size() == mostUnderway ||
        (down && breakdowns_.chance(parameters_.burstLoss))) {
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
