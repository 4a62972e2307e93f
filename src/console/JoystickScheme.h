#pragma once
#include <optional>
#include <string>
#include <vector>

#include "console/Joystick.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {

/// How a joystick moves a robot (report J.5.5).
enum class JoystickSchemeKind {
  commands,         ///< By the commands of its buttons, and the axes of `Joystick` (report I.5.2).
  stickSpeed,       ///< The three axes walk; the accelerator lever chooses the head control mode.
  acceleratorSpeed  ///< The lever walks ahead, the axes sideways and turning.
};

/// The schemes StickSpeed and AcceleratorSpeed (report J.5.5): from axes and buttons to what is
/// asked of the robot. In both, buttons 1 to 4 kick, 7 gets up, and while 5 is held the stick moves
/// the head and the robot stands. Button 8 (StickSpeed) or 6 (AcceleratorSpeed) changes the walk
/// type. In StickSpeed the lever chooses among all special actions while 6 is held.
class JoystickScheme {
 public:
  static constexpr int headButton = 5, getupButton = 7;

  /// `kicks` are those of the buttons 1 to 4, `actions` all special actions.
  JoystickScheme(JoystickSchemeKind kind, std::vector<std::string> kicks,
                 std::vector<std::string> actions)
      : kind_{kind}, kicks_{std::move(kicks)}, actions_{std::move(actions)} {}

  void move(Joystick::Axis axis, double value);
  void press(int button, bool down);

  /// What is asked of the robot otherwise than when this was called last. At first it stands.
  struct Changes {
    std::optional<MotionRequest> motion;
    std::optional<HeadMode> headMode;
    std::optional<HeadMotionRequest> head;
  };
  Changes takeChanges();

  /// What is asked of the robot now.
  const MotionRequest& motion() const { return motion_; }
  HeadMode headMode() const { return isDown(headButton) ? HeadMode::none : headMode_; }
  /// Followed in the head control mode none, so only while the stick moves the head.
  const HeadMotionRequest& head() const { return head_; }
  bool movesHead() const { return isDown(headButton); }

 private:
  static constexpr int actionButton = 6;

  bool isDown(int button) const { return down_[static_cast<std::size_t>(button)]; }
  int walkTypeButton() const { return kind_ == JoystickSchemeKind::stickSpeed ? 8 : 6; }
  /// The element of a list of some length that the lever stands at: the first when it is pulled.
  std::size_t atLever(std::size_t count) const;
  void update();
  /// The special action that a button asks for; empty if none does.
  std::string action() const;
  Pose2D walk() const;

  JoystickSchemeKind kind_;
  std::vector<std::string> kicks_, actions_;
  EnumArray<Joystick::Axis, double> axes_;
  std::array<bool, Joystick::buttons + 1> down_{};
  bool leverMoved_ = false;    ///< Ever: until then it asks for nothing.
  bool actionChosen_ = false;  ///< The lever was moved while the button for actions is held.
  WalkType walkType_ = WalkType::normal;
  HeadMode headMode_ = HeadMode::searchAuto;
  HeadMotionRequest head_;
  MotionRequest motion_;
  // As it was taken last.
  MotionRequest takenMotion_;
  HeadMode takenMode_ = headMode_;
  HeadMotionRequest takenHead_;
};

}  // namespace gt
