#pragma once
#include "base/Time.h"
#include "representations/infrastructure/CameraSettings.h"
#include "streams/Reflection.h"

namespace gt {

/// The errors of a camera, each of which can be set independently. The defaults are those of match
/// scenes; all zero (and brightness 1) is a perfect camera. Configuration.
struct CameraEffects {
  bool rollingShutter = true;
  double blur = 0.6;
  double vignetting = 0.2;
  double brightness = 1;
  double shiftCb = 0;
  double shiftCr = 0;
  double noiseY = 3;
  double noiseCb = 2;
  double noiseCr = 2;
  bool pixelShading = false;
  bool shadows = false;
  double exposure = 0;
  double lightChange = 0;
  double lightPeriod = 10;
  double noiseGrowth = 0;
  double noiseCorrelation = 0;
  double chromaBlur = 0;
  double rimCb = 0;
  double rimCr = 0;
  double unevenLight = 0;
  double delay = 0;
  double delayJitter = 0;

  /// Longest time by which an image is older than its time stamp (ms).
  static constexpr double longestDelay = 40;
  /// Longest time from the exposure of an image's first row to that of its last (ms).
  static constexpr double longestImage = 40;

  /// The effects at a time: `brightness` includes the change of the light (`lightChange`) then.
  CameraEffects at(Time time) const;
  /// A camera without faults.
  static CameraEffects none() { return {false, 0, 0, 1, 0, 0, 0, 0, 0, false, false}; }

  /// Whether any effect changes the colors of pixels.
  bool colors() const {
    CameraEffects perfect = none();
    perfect.rollingShutter = rollingShutter;
    perfect.pixelShading = pixelShading;
    perfect.shadows = shadows;
    perfect.exposure = exposure;
    perfect.lightPeriod = lightPeriod;
    perfect.delay = delay;
    perfect.delayJitter = delayJitter;
    return *this != perfect;
  }
  friend bool operator==(const CameraEffects&, const CameraEffects&) = default;

  static constexpr auto fields() {
    return Fields{
        field<&CameraEffects::rollingShutter>(
            "rows are exposed one after another; otherwise all with the middle row"),
        field<&CameraEffects::blur>(Unit::pixel, "standard deviation of the lens' blur", {0, 2}),
        field<&CameraEffects::vignetting>("part of the light lost in the corners", {0, 0.9}),
        field<&CameraEffects::brightness>("factor on all light", {0, 1.9}),
        field<&CameraEffects::shiftCb>("color cast, added to cb", {-128, 128}),
        field<&CameraEffects::shiftCr>("color cast, added to cr", {-128, 128}),
        field<&CameraEffects::noiseY>("standard deviation of a pixel's noise", {0, 60}),
        field<&CameraEffects::noiseCb>({0, 60}),
        field<&CameraEffects::noiseCr>({0, 60}),
        field<&CameraEffects::pixelShading>(
            "each pixel is lit by the emitters for itself; otherwise each surface, by daylight"),
        field<&CameraEffects::shadows>("with pixelShading: emitters throw shadows"),
        field<&CameraEffects::exposure>(
            Unit::ms, "of each row: what the camera turns past is smeared", {0, 40}),
        field<&CameraEffects::lightChange>("share by which all light grows and shrinks", {0, 0.9}),
        field<&CameraEffects::lightPeriod>(Unit::s, "in which it does so", {0.1, 1000}),
        field<&CameraEffects::noiseGrowth>(
            "share by which the noise is stronger where y is 255 than where it is 0", {0, 1}),
        field<&CameraEffects::noiseCorrelation>("of the noise of neighbors in a row", {0, 0.5}),
        field<&CameraEffects::chromaBlur>(
            Unit::pixel,
            "standard deviation by which cb and cr bleed into the rows above and below", {0, 1.8}),
        field<&CameraEffects::rimCb>(
            "color cast of the corners, added to cb; it grows with the squared distance from the "
            "middle",
            {-64, 64}),
        field<&CameraEffects::rimCr>("color cast of the corners, added to cr, as rimCb", {-64, 64}),
        field<&CameraEffects::unevenLight>(
            "share by which places on the field are brighter or darker at most", {0, 0.9}),
        field<&CameraEffects::delay>(Unit::ms, "by which images are older than their time stamps",
                                     {0, longestDelay}),
        field<&CameraEffects::delayJitter>(
            Unit::ms, "standard deviation of that, from image to image", {0, longestDelay})};
  }
};

/// The effects under other camera settings (report B.4.3); `effects` are those under the default
/// settings. Each step of gain or shutter speed changes the light by half a stop; gain also changes
/// the noise, shutter speed also the exposure. Other white balances than the default shift the
/// colors, as in light that they are not made for.
CameraEffects withSettings(CameraEffects effects, const CameraSettings& settings);

}  // namespace gt
