#pragma once
#include "modules/behavior/tactics/WorldState.h"
#include "streams/Reflection.h"

namespace gt {

/// The state of the game, sent by the game manager or, without one, set by hand with the robot's
/// buttons and tail (report B.2.3). The game manager takes over with the first state other than
/// initial.
class ButtonControl {
 public:
  struct Parameters {
    double longPress = 1000;
    double tailPush = 10;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::longPress>(
              Unit::ms,
              "time of pressing the back switch above which the game stops; less starts the next "
              "state",
              {0, 10000}),
          field<&P::tailPush>(Unit::deg, "angle of the tail above which it is pushed aside by hand",
                              {1, 22})};
    }
  };

  /// The parameters must outlive this.
  explicit ButtonControl(const Parameters& parameters) : p_{parameters} {}

  void update(const WorldState& world);

  GameState state() const { return state_; }
  bool ownKickOff() const { return ownKickOff_; }

 private:
  void pressBack(double pressedFor);

  const Parameters& p_;
  bool managed_ = false;
  GameState state_ = GameState::initial;
  bool ownKickOff_ = false;
  double backPressedFor_ = 0;  ///< In the last cycle, in ms.
};

}  // namespace gt
