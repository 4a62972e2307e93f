#pragma once
#include <cstdint>

#include "match/MatchRobot.h"

namespace gt {

/// Hands what a robot provides to its body, for robots that answer in the tick in which they sense.
class BodyCommands {
 public:
  template <typename T>
  using Provided = const T*;

  /// Where the values lie, as they are at the end of each cycle; null what the robot does not
  /// provide.
  CommandSlots<Provided> places{};
  const MotionInfo* motion = nullptr;
  CameraSettings camera;  ///< As the camera is set.

  template <typename T>
  const T* place() const {
    return std::get<const T*>(places);
  }
  /// To be called once after each cycle.
  void give(RobotOutput& output, bool withImage);

 private:
  std::int64_t images_ = 0;
};

/// Whether a robot's body and its team can take these: programs elsewhere may send anything.
bool isSane(const JointData& joints);
bool isSane(const JointGains& joints);
bool isSane(const OdometryData& odometry);
bool isSane(const TeamMessage& message);

}  // namespace gt
