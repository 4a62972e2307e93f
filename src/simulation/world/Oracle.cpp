#include "simulation/world/Oracle.h"

namespace gt {

void askOracle(const World& world, const std::vector<Player>& players, std::size_t robot,
               OracledWorldState& state) {
  const TeamColor team = players[robot].teamColor;
  state.time = world.time();
  state.robotPose = toTeam(team, world.robot(robot).pose);
  if (world.ballCount() > 0) {
    state.ballPosition = toTeam(team, world.ball(0).position);
    state.ballSpeed = toTeam(team, world.ball(0).speed);
  }
  state.others.resize(world.robotCount() - 1);
  std::size_t next = 0;
  for (std::size_t i = 0; i < world.robotCount(); ++i)
    if (i != robot)
      state.others[next++] = {players[i].teamColor, players[i].number(),
                              toTeam(team, world.robot(i).pose)};
}

}  // namespace gt
