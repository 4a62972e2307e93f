#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "base/Result.h"
#include "base/Time.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {

/// A joystick that moves the selected robots by hand (report I.5.2: jbc, jhc): its axes x, y and z
/// walk, the accelerator lever moves one joint of the head and the coolie hat the other two. The
/// program reads the device; this class maps its states to requests.
class Joystick {
 public:
  static constexpr int buttons = 32;
  enum class Axis { x, y, z, accelerator, hatX, hatY };
  enum class HeadAxis { tilt, pan, roll };

  /// Sets the command of a button, 1 to 32; empty: none.
  void setCommand(int button, std::string command) { commands_[button] = std::move(command); }
  /// Sets the joint of the head that the accelerator lever moves; the default is pan.
  void setHeadAxis(HeadAxis axis) { headAxis_ = axis; }

  /// Moves an axis, from -1 to 1.
  void move(Axis axis, double value) {
    axes_[axis] = value;
    moved_ = true;
  }
  /// Presses or releases a button; returns its command when it was pressed and has one.
  std::optional<std::string> press(int button, bool down);

  /// The walk request (mm/s and rad/s, relative to the robot) if it has changed; empty while a
  /// button is pressed (report I.5.2).
  std::optional<Pose2D> walk();
  /// The requested angles of the head (rad); the hat's directions are integrated over time. Empty
  /// if they have not changed.
  std::optional<HeadMotionRequest> head(Time now);

 private:
  bool pressed() const;

  std::map<int, std::string> commands_;
  std::array<bool, buttons + 1> down_{};
  EnumArray<Axis, double> axes_;
  HeadAxis headAxis_ = HeadAxis::pan;
  HeadMotionRequest head_;
  bool moved_ = false;
  Pose2D lastWalk_;
  Time lastHead_ = never();
};

}  // namespace gt
