#pragma once
#include <array>

#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// The switches of the ERS-210 (facts, 1.3); the paws in the order of Leg.
enum class Switch { headFront, headBack, chin, back, pawFR, pawFL, pawHR, pawHL };

/// What the body's sensors measured in one frame of 8 ms. Provided by the platform.
struct SensorData {
  Time time;
  JointAngles joints;
  Vector3d acceleration = Vector3d::Zero();
  double psd = 900;
  EnumArray<Switch, bool> switches;

  static constexpr auto fields() {
    return Fields{
        field<&SensorData::time>(Unit::ms),
        field<&SensorData::joints>(Unit::rad, "measured angles, in the order of Joint"),
        field<&SensorData::acceleration>(
            Unit::mmPerS2, "specific force along x ahead, y left, z up; z is +9810 at rest"),
        field<&SensorData::psd>(Unit::mm, "measurement of the distance sensor in the head",
                                {100, 900}),
        field<&SensorData::switches>("whether each switch is pressed, in the order of Switch")};
  }
};

/// The last frames of sensor data, the newest last (report 3.1). Provided by the platform.
struct SensorDataBuffer {
  static constexpr int capacity = 16;  ///< 128 ms, which covers the exposure of an image.
  std::array<SensorData, capacity> frames;

  const SensorData& newest() const { return frames.back(); }
  /// The frame nearest to a time; the oldest one if the time lies before all frames.
  const SensorData& at(Time time) const {
    int best = capacity - 1;
    while (best > 0 && frames[static_cast<std::size_t>(best)].time.ms > time.ms + 4) --best;
    return frames[static_cast<std::size_t>(best)];
  }
  void push(const SensorData& frame) {
    for (std::size_t i = 1; i < frames.size(); ++i) frames[i - 1] = frames[i];
    frames.back() = frame;
  }

  static constexpr auto fields() {
    return Fields{field<&SensorDataBuffer::frames>("frames of sensor data, the oldest first")};
  }
};

}  // namespace gt
