#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

enum class GameState { initial, ready, set, playing, penalized, finished };  // facts, 2.2
enum class KickOff { invalid, own, opponent };
enum class Penalty {
  none,
  ballHolding,
  keeperCharge,
  fieldPlayerCharge,
  illegalDefender,
  illegalDefense,
  obstruction,
  requestForPickup
};

/// The data that the RoboCup game manager sends to one robot (facts, 2.2). Provided by the
/// platform.
struct GameControlData {
  GameState state = GameState::initial;
  KickOff kickOff = KickOff::invalid;
  Penalty penalty = Penalty::none;
  int ownScore = 0;
  int opponentScore = 0;
  Time timeOfLastChange;

  static constexpr auto fields() {
    return Fields{
        field<&GameControlData::state>(),
        field<&GameControlData::kickOff>(),
        field<&GameControlData::penalty>(),
        field<&GameControlData::ownScore>(),
        field<&GameControlData::opponentScore>(),
        field<&GameControlData::timeOfLastChange>(Unit::ms, "when the game state changed last")};
  }
};

}  // namespace gt
