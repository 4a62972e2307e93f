#include "match/GameControllerFollower.h"

#include <tuple>

namespace gt {

Result<void> GameControllerFollower::listen(int port) {
  auto link = GameControllerLink::listen(port);
  if (!link) return link.error();
  link_ = std::move(*link);
  return {};
}

void GameControllerFollower::hear(const Note& note) {
  constexpr int mostInATick = 10;  // the rest of a flood waits
  for (int i = 0; link_ && i < mostInATick; ++i) {
    const auto message = link_->receive();
    if (!message) return;
    const auto changed = follow(*message);
    if (!changed) continue;
    if (*changed) note(*message);
    answer();
  }
}

Result<bool> GameControllerFollower::follow(std::span<const std::byte> bytes) {
  auto message = parseGameController(bytes);
  if (!message) return message.error();
  // Most messages differ from the last one in the time only, which passes by itself.
  const auto meaning = [](const GameControllerMessage& m) {
    return std::tie(m.state, m.firstHalf, m.kickOff, m.teams.values);
  };
  const bool changed =
      !last_ || meaning(*last_) != meaning(*message) || !simulation_.referee().led();
  last_ = *message;
  if (changed) simulation_.referee().follow(*message, simulation_.world());
  return changed;
}

void GameControllerFollower::answer() const {
  const std::vector<Player>& players = simulation_.players();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    GameControllerAnswer answer;
    answer.team = last_->teams[players[i].teamColor].number;
    answer.player = players[i].number();
    answer.fallen = simulation_.world().robot(i).posture != Posture::standing;
    const MatchRobot& robot = *robots_[i];
    if (robot.pose()) answer.pose = robot.pose()->pose;
    if (robot.ball() && robot.ball()->lastSeen != never()) {
      answer.ballAge = static_cast<double>(simulation_.time() - robot.ball()->lastSeen) / 1000;
      answer.ball = robot.ball()->position;
    }
    link_->answer(answerBytes(answer, last_->version), gameControllerAnswerPort(last_->version));
  }
}

}  // namespace gt
