#pragma once
#include "base/Enum.h"
#include "streams/Reflection.h"

namespace gt {

enum class TeamColor { red, blue };  ///< Red defends the yellow goal, blue the sky-blue one.
enum class PlayerRole {
  goalie,
  defender,
  striker1,
  striker2
};  ///< The roles of player.cfg (report B.4.4).

constexpr TeamColor opponent(TeamColor color) {
  return color == TeamColor::red ? TeamColor::blue : TeamColor::red;
}

/// Identity of this robot (player.cfg, report B.4.4). Configuration.
struct Player {
  TeamColor teamColor = TeamColor::blue;
  PlayerRole role = PlayerRole::goalie;

  int number() const {
    return static_cast<int>(role) + 1;
  }  ///< 1 to 4, as counted by the game manager.

  static constexpr auto fields() {
    return Fields{field<&Player::teamColor>(), field<&Player::role>().named("playerRole")};
  }
};

}  // namespace gt
