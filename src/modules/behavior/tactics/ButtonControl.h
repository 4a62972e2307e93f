#pragma once
#include "modules/behavior/tactics/WorldState.h"
#include "streams/Reflection.h"

namespace gt {

/// The state of the game: what the game manager sends, or without one what a hand says by the
/// robot's buttons and tail (report B.2.3). The game manager leads from the first state other than
/// initial on.
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
              "pressing the back switch longer stops the game; shorter begins what is next",
              {0, 10000}),
          field<&P::tailPush>(Unit::deg, "so far aside the tail is pushed by hand", {1, 22})};
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
