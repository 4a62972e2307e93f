#pragma once
#include <memory>
#include <vector>

#include "base/Result.h"

namespace gt {

/// A joystick of this machine, by SDL: the first that is plugged in. One that was pulled out is
/// taken again when it is back.
class SdlJoystick {
 public:
  enum class Part { axis, hatX, hatY, button };
  /// Something on it was moved.
  struct Event {
    Part part;
    int number;    ///< Of the axis, hat or button, from 0.
    double value;  ///< -1 to 1, to the right and back; of a button 0 or 1.
  };

  /// An error if none is plugged in.
  static Result<std::unique_ptr<SdlJoystick>> open();
  ~SdlJoystick();
  SdlJoystick(const SdlJoystick&) = delete;
  SdlJoystick& operator=(const SdlJoystick&) = delete;

  std::string name() const;
  /// What happened since this was called last. Does not block.
  std::vector<Event> take();

 private:
  struct Device;
  explicit SdlJoystick(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
};

}  // namespace gt
