#include "match/GameControllerFollower.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace gt {
namespace {

/// Greatest difference between the clocks of game controller and referee that is not a change of
/// the time left: a message states whole seconds, and takes some time itself.
constexpr std::int64_t clockTolerance = 1500;  // ms

}  // namespace

Result<void> GameControllerFollower::listen(const Endpoint& endpoint) {
  auto link = GameControllerLink::listen(endpoint);
  if (!link) return link.error();
  link_ = std::move(*link);
  return {};
}

void GameControllerFollower::hear(const Note& note) {
  constexpr int mostInATick = 10;  // the rest of a flood waits
  for (int i = 0; link_ && i < mostInATick; ++i) {
    const auto datagram = link_->receive();
    if (!datagram) return;
    const auto message = choice_.take(*datagram);
    if (!message) continue;
    if (follow(*message)) note(datagram->bytes);
    answer();
  }
}

Result<bool> GameControllerFollower::follow(std::span<const std::byte> bytes) {
  const auto message = parseGameController(bytes);
  if (!message) return message.error();
  return follow(*message);
}

bool GameControllerFollower::follow(const GameControllerMessage& message) {
  Referee& referee = simulation_.referee();
  // Most messages differ from the last one in the time only, which passes by itself.
  const auto meaning = [](const GameControllerMessage& m) {
    return std::tie(m.state, m.firstHalf, m.kickOff, m.teams.values);
  };
  const std::int64_t left = 1000 * std::max<std::int64_t>(message.secondsLeft, 0);
  const bool changed = !last_ || meaning(*last_) != meaning(message) || !referee.led() ||
                       std::abs(left - referee.timeLeft(simulation_.time())) > clockTolerance;
  last_ = message;
  if (changed) referee.follow(message, simulation_.world());
  return changed;
}

void GameControllerFollower::answer() const {
  const std::vector<Player>& players = simulation_.players();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!robots_[i]->isOn() || !simulation_.failure(i).empty()) continue;
    GameControllerAnswer answer;
    answer.team = last_->teams[players[i].teamColor].number;
    answer.player = players[i].number();
    answer.fallen = simulation_.world().robot(i).posture != Posture::standing;
    const MatchRobot& robot = *robots_[i];
    if (robot.belief().pose) answer.pose = robot.belief().pose->pose;
    if (robot.belief().ball && robot.belief().ball->lastSeen != never()) {
      answer.ballAge =
          static_cast<double>(simulation_.time() - robot.belief().ball->lastSeen) / 1000;
      answer.ball = robot.belief().ball->position;
    }
    link_->answer(answerBytes(answer, last_->version), gameControllerAnswerPort(last_->version));
  }
}

}  // namespace gt
