#include "simulation/rules/GameEvent.h"

#include <cctype>

namespace gt {
namespace {

/// A penalty as people say it: ball holding.
std::string penaltyText(Penalty penalty) {
  std::string text;
  for (const char c : enumName(penalty)) {
    if (std::isupper(c)) text += ' ';
    text += static_cast<char>(std::tolower(c));
  }
  return text;
}

}  // namespace

std::string describe(const GameEvent& event) {
  const std::string team{enumName(event.team)};
  const std::string score = std::to_string(event.scoreRed) + ":" + std::to_string(event.scoreBlue);
  const std::string player = event.number > 0 ? " " + std::to_string(event.number) : "";
  switch (event.type) {
    case GameEventType::kickOff:
      return "Kick-off for " + team;
    case GameEventType::goal:
      return "Goal for " + team +
             (event.ownGoal
                  ? ", an own goal by " + std::string{enumName(opponent(event.team))} + player
                  : (player.empty() ? "" : " by player" + player)) +
             ": " + score;
    case GameEventType::halfTime:
      return "Half time, " + score;
    case GameEventType::stuckBall:
      return "The ball is stuck and put elsewhere";
    case GameEventType::ballOut:
      return "The ball is out and put back";
    case GameEventType::placedRobot:
      return "The referee puts " + team + player + " in its place";
    case GameEventType::penalty:
      return "The referee takes " + team + player + " off the field: " + penaltyText(event.penalty);
    case GameEventType::returnedRobot:
      return team + player + " comes back";
    case GameEventType::shotGoal:
      return "Penalty shot of " + team + player + ": goal, " + score;
    case GameEventType::shotMissed:
      return "Penalty shot of " + team + player + ": missed, " + score;
    case GameEventType::gameOver:
      return "The game is over, " + score;
  }
  return "";
}

std::string clockText(Time time) {
  const std::int64_t seconds = time.ms / 1000;
  const std::string s = std::to_string(seconds % 60);
  return std::to_string(seconds / 60) + (s.size() < 2 ? ":0" : ":") + s;
}

}  // namespace gt
