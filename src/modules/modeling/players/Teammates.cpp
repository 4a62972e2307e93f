#include "modules/modeling/players/Teammates.h"

namespace gt {
namespace {

const DebugKey playersKey{"PlayersLocator/players"};

}  // namespace

bool MessageRule::accepts(const TeamMessages::Received& received, const Player& player,
                          Time now) const {
  const TeamMessage& message = received.message;
  return message.playerNumber != 0 && message.playerNumber != player.number() &&
         now - received.timeReceived <= silence && message.robotPoseValidity >= leastValidity;
}

void addMates(const TeamMessages& messages, const MessageRule& rule, const Player& player, Time now,
              std::vector<LocatedPlayer>& players) {
  for (const TeamMessages::Received& received : messages.byPlayer) {
    const TeamMessage& message = received.message;
    if (rule.accepts(received, player, now))
      players.push_back({message.robotPose.translation, received.timeReceived,
                         message.robotPoseValidity, message.playerNumber});
  }
}

void drawPlayers(const PlayersCollection& players, TeamColor own, Debug& debug) {
  if (auto canvas = debug.onField(playersKey))
    for (const bool mates : {true, false})
      for (const LocatedPlayer& p : mates ? players.ownTeam : players.opponents)
        canvas.circle(p.position, 150, colorOf(mates ? own : opponent(own)), p.number > 0 ? 3 : 1);
}

}  // namespace gt
