#pragma once
#include <vector>

#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/PlayersCollection.h"

namespace gt {

/// The condition under which messages of teammates are used.
struct MessageRule {
  std::int64_t silence;  ///< Time (ms) after which a message is too old.
  double leastValidity;  ///< Least validity of the sender's pose.

  bool accepts(const TeamMessages::Received& received, const Player& player, Time now) const;
};

/// Appends the teammates whose messages are used, at the positions that they sent (report 3.7.2).
void addMates(const TeamMessages& messages, const MessageRule& rule, const Player& player, Time now,
              std::vector<LocatedPlayer>& players);

/// The point on the field that is nearest to a point (mm).
inline Vector2d nearestOnField(const Vector2d& place, const FieldDimensions& field) {
  const Vector2d half{field.xGroundline, field.ySideline};
  return place.cwiseMax(-half).cwiseMin(half);
}

/// Draws the players on the field, thick if they sent their pose.
void drawPlayers(const PlayersCollection& players, TeamColor own, Debug& debug);
inline Color colorOf(TeamColor team) {
  return team == TeamColor::red ? colors::red : colors::blue;
}

}  // namespace gt
