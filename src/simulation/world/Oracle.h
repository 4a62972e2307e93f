#pragma once
#include <vector>

#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/Player.h"
#include "simulation/world/World.h"

namespace gt {

/// A point, speed or pose of the field in a team's coordinates, and back: the blue team sees the
/// field turned by 180 degrees.
inline Vector2d toTeam(TeamColor team, const Vector2d& v) {
  return team == TeamColor::red ? v : Vector2d{-v};
}
inline Pose2D toTeam(TeamColor team, const Pose2D& pose) {
  return team == TeamColor::red ? pose : Pose2D{normalize(pose.rotation + pi), -pose.translation};
}

/// Provides a robot with the truth (report 5.1). `players` holds all robots of the world in their
/// order. Without a ball its position stays the field's center; with several it is the first.
void askOracle(const World& world, const std::vector<Player>& players, std::size_t robot,
               OracledWorldState& state);

}  // namespace gt
