#pragma once
#include <optional>
#include <string>
#include <vector>

#include "console/Joystick.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {

/// The schemes by which a joystick moves a robot (report J.5.5).
enum class JoystickSchemeKind {
  commands,         ///< By the commands of its buttons, and the axes of `Joystick` (report I.5.2).
  stickSpeed,       ///< The three axes walk; the accelerator lever chooses the head control mode.
  acceleratorSpeed  ///< The lever walks ahead, the axes sideways and turning.
};

/// The schemes StickSpeed and AcceleratorSpeed (report J.5.5), which map axes and buttons to
/// requests to the robot. In both, buttons 1 to 4 kick, 7 gets up, and while 5 is held the stick
/// moves the head and the robot stands. Button 8 (StickSpeed) or 6 (AcceleratorSpeed) changes the
/// walk type. In StickSpeed the lever chooses among all special actions while 6 is held.
class JoystickScheme {
 public:
  static constexpr int headButton = 5, getupButton = 7;

  /// `kicks` are the special actions of the buttons 1 to 4, `actions` all special actions.
  JoystickScheme(JoystickSchemeKind kind, std::vector<std::string> kicks,
                 std::vector<std::string> actions)
      : kind_{kind}, kicks_{std::move(kicks)}, actions_{std::move(actions)} {}

  void move(Joystick::Axis axis, double value);
  void press(int button, bool down);

  /// The requests that have changed since the last call of `takeChanges`. Initially the robot
  /// stands.
  struct Changes {
    std::optional<MotionRequest> motion;
    std::optional<HeadMode> headMode;
    std::optional<HeadMotionRequest> head;
  };
  Changes takeChanges();

  /// The present motion request.
  const MotionRequest& motion() const { return motion_; }
  HeadMode headMode() const { return isDown(headButton) ? HeadMode::none : headMode_; }
  /// The head motion request, which the robot follows only while the stick moves the head, because
  /// only then the head control mode is none.
  const HeadMotionRequest& head() const { return head_; }
  bool movesHead() const { return isDown(headButton); }

 private:
  static constexpr int actionButton = 6;

  bool isDown(int button) const { return down_[static_cast<std::size_t>(button)]; }
  int walkTypeButton() const { return kind_ == JoystickSchemeKind::stickSpeed ? 8 : 6; }
  /// The index in a list of `count` elements that the lever selects; 0 when it is pulled.
  std::size_t atLever(std::size_t count) const;
  void update();
  /// The special action that a button requests; empty if none does.
  std::string action() const;
  Pose2D walk() const;

  JoystickSchemeKind kind_;
  std::vector<std::string> kicks_, actions_;
  EnumArray<Joystick::Axis, double> axes_;
  std::array<bool, Joystick::buttons + 1> down_{};
  bool leverMoved_ = false;    ///< Whether it ever moved: until then it requests nothing.
  bool actionChosen_ = false;  ///< The lever was moved while the button for actions is held.
  WalkType walkType_ = WalkType::normal;
  HeadMode headMode_ = HeadMode::searchAuto;
  HeadMotionRequest head_;
  MotionRequest motion_;
  // The requests as they were taken last.
  MotionRequest takenMotion_;
  HeadMode takenMode_ = headMode_;
  HeadMotionRequest takenHead_;
};

}  // namespace gt
