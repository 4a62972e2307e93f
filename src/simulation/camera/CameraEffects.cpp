#include "simulation/camera/CameraEffects.h"

#include <algorithm>
#include <cmath>

#include "base/Geometry.h"

namespace gt {

CameraEffects CameraEffects::at(Time time) const {
  CameraEffects effects = *this;
  const double turn = 2 * pi * static_cast<double>(time.ms) / (1000 * lightPeriod);
  effects.brightness = std::clamp(brightness * (1 + lightChange * std::sin(turn)), 0.0, 1.9);
  effects.lightChange = 0;
  return effects;
}

CameraEffects withSettings(CameraEffects effects, const CameraSettings& settings) {
  const int gain = static_cast<int>(settings.gain) - static_cast<int>(Gain::gain_mid);
  const int exposure = static_cast<int>(ShutterSpeed::shutter_mid) -
                       static_cast<int>(settings.shutterSpeed);  // slow: more light
  const auto stops = [](int halves) { return std::exp2(halves / 2.0); };
  effects.brightness = std::clamp(effects.brightness * stops(gain + exposure), 0.0, 1.9);
  for (double* noise : {&effects.noiseY, &effects.noiseCb, &effects.noiseCr})
    *noise = std::min(*noise * stops(gain), 60.0);
  effects.exposure = std::min(effects.exposure * stops(2 * exposure), 40.0);
  constexpr double warm = 12, cold = 6;
  if (settings.whiteBalance == WhiteBalance::wb_outdoor_mode) {
    effects.shiftCb = std::clamp(effects.shiftCb - warm, -128.0, 128.0);
    effects.shiftCr = std::clamp(effects.shiftCr + warm, -128.0, 128.0);
  } else if (settings.whiteBalance == WhiteBalance::wb_fl_mode) {
    effects.shiftCb = std::clamp(effects.shiftCb + cold, -128.0, 128.0);
    effects.shiftCr = std::clamp(effects.shiftCr + cold, -128.0, 128.0);
  }
  return effects;
}

}  // namespace gt
