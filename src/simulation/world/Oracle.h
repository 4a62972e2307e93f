#pragma once
#include <vector>

#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/Player.h"
#include "simulation/world/World.h"

namespace gt {

/// Converts a point, speed or pose from the field's coordinates to a team's, or back. The blue team
/// sees the field turned by 180 degrees.
inline Vector2d toTeam(TeamColor team, const Vector2d& v) {
  return team == TeamColor::red ? v : Vector2d{-v};
}
inline Pose2D toTeam(TeamColor team, const Pose2D& pose) {
  return team == TeamColor::red ? pose : Pose2D{normalize(pose.rotation + pi), -pose.translation};
}

/// Fills `state` with the truth for a robot, in its team's coordinates (report 5.1). `players`
/// holds all robots of the world in their order. The ball is the first of several; without one, its
/// position stays the field's center.
void askOracle(const World& world, const std::vector<Player>& players, std::size_t robot,
               OracledWorldState& state);

}  // namespace gt
