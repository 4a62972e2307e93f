#pragma once
#include <memory>
#include <vector>

#include "base/Result.h"

namespace gt {

/// The first joystick that is connected to this machine, by SDL. It is reconnected after it was
/// disconnected.
class SdlJoystick {
 public:
  enum class Part { axis, hatX, hatY, button };
  /// A change of an axis, hat or button.
  struct Event {
    Part part;
    int number;    ///< Of the axis, hat or button, from 0.
    double value;  ///< -1 to 1, + to the right and backward; 0 or 1 for a button.
  };

  /// Returns an error if no joystick is connected.
  static Result<std::unique_ptr<SdlJoystick>> open();
  ~SdlJoystick();
  SdlJoystick(const SdlJoystick&) = delete;
  SdlJoystick& operator=(const SdlJoystick&) = delete;

  std::string name() const;
  /// Returns the events since the last call. Does not block.
  std::vector<Event> take();

 private:
  struct Device;
  explicit SdlJoystick(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
};

}  // namespace gt
