#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The point that the distance sensor in the head hits, relative to the robot (report 3.1).
/// Provided by the SensorDataProcessor.
struct PsdPercept {
  Time time;
  Vector3d offset = Vector3d::Zero();
  bool tooFarAway = true;

  static constexpr auto fields() {
    return Fields{field<&PsdPercept::time>(Unit::ms), field<&PsdPercept::offset>(Unit::mm),
                  field<&PsdPercept::tooFarAway>("whether nothing was measured within 900 mm")};
  }
};

}  // namespace gt
