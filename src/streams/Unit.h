#pragma once
#include <string_view>

namespace gt {

/// The unit of a number, as fields state it to streams, views and tools. A combination of units
/// applies to the parts of the field's value in their order, such as mm and rad to those of a pose.
enum class Unit {
  none,
  mm,
  mmRad,
  mmOrPixel,
  pixel,
  frames,  ///< Of the joints and sensors, 8 ms each.
  ticks,   ///< Of the simulator or the sensors, 8 ms each.
  percent,
  deg,
  rad,
  rad2,
  oneRad,  ///< A number without unit, then an angle.
  ns,
  us,
  ms,
  s,
  min,
  mmPerS,
  mmPerMs,
  mmPerS2,
  mmPerRad,
  mmPerSPerRootS,
  mmRadPerS,
  degPerS,
  radPerS,
  radPerMs,
  radPerS2,
  radPerMm,
  perMm,
  perMm2,
  perRad,
  perS,
  perMin,
  cd
};

/// The unit as written behind a number, or behind several with a comma in between; empty for a number without a unit.
constexpr std::string_view unitText(Unit unit) {
  switch (unit) {
    case Unit::none:
      return "";
    case Unit::mm:
      return "mm";
    case Unit::mmRad:
      return "mm, rad";
    case Unit::mmOrPixel:
      return "mm or pixel";
    case Unit::pixel:
      return "pixel";
    case Unit::frames:
      return "frames";
    case Unit::ticks:
      return "ticks";
    case Unit::percent:
      return "%";
    case Unit::deg:
      return "deg";
    case Unit::rad:
      return "rad";
    case Unit::rad2:
      return "rad^2";
    case Unit::oneRad:
      return "1, rad";
    case Unit::ns:
      return "ns";
    case Unit::us:
      return "us";
    case Unit::ms:
      return "ms";
    case Unit::s:
      return "s";
    case Unit::min:
      return "min";
    case Unit::mmPerS:
      return "mm/s";
    case Unit::mmPerMs:
      return "mm/ms";
    case Unit::mmPerS2:
      return "mm/s^2";
    case Unit::mmPerRad:
      return "mm/rad";
    case Unit::mmPerSPerRootS:
      return "mm/s per root of a second";
    case Unit::mmRadPerS:
      return "mm/s, rad/s";
    case Unit::degPerS:
      return "deg/s";
    case Unit::radPerS:
      return "rad/s";
    case Unit::radPerMs:
      return "rad/ms";
    case Unit::radPerS2:
      return "rad/s^2";
    case Unit::radPerMm:
      return "rad/mm";
    case Unit::perMm:
      return "1/mm";
    case Unit::perMm2:
      return "1/mm^2";
    case Unit::perRad:
      return "1/rad";
    case Unit::perS:
      return "1/s";
    case Unit::perMin:
      return "1/min";
    case Unit::cd:
      return "cd";
  }
  return "";
}

}  // namespace gt
