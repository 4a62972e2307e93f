#pragma once
#include "base/Enum.h"
#include "streams/Reflection.h"

namespace gt {

// The words of the report, B.4.3.
enum class WhiteBalance { wb_indoor_mode, wb_outdoor_mode, wb_fl_mode };
enum class Gain { gain_low, gain_mid, gain_high };
enum class ShutterSpeed { shutter_slow, shutter_mid, shutter_fast };

/// Settings of the camera (camera.cfg, report B.4.3). They must be the settings with which the
/// color table was made. Configuration.
struct CameraSettings {
  WhiteBalance whiteBalance = WhiteBalance::wb_indoor_mode;
  Gain gain = Gain::gain_mid;
  ShutterSpeed shutterSpeed = ShutterSpeed::shutter_mid;

  friend bool operator==(const CameraSettings&, const CameraSettings&) = default;
  static constexpr auto fields() {
    return Fields{field<&CameraSettings::whiteBalance>(), field<&CameraSettings::gain>(),
                  field<&CameraSettings::shutterSpeed>()};
  }
};

}  // namespace gt
