#pragma once
#include <cstdint>
#include <optional>

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
  CameraSettings camera;  ///< As the camera is set.

  template <typename T>
  const T* place() const {
    return std::get<const T*>(places);
  }
  /// To be called once after each cycle, with what the robot does then.
  void give(RobotOutput& output, const Belief& belief, bool withImage);

 private:
  template <typename T>
  void give(T& command, bool withImage) const;
  void give(std::optional<TeamMessage>& message, bool withImage) const;
  void give(std::optional<CameraSettings>& settings, bool withImage);

  std::int64_t images_ = 0;
};

/// Whether a robot's body and its team can take a command: programs elsewhere may send anything.
template <typename T>
bool isSane(const T&) {
  return true;
}
bool isSane(const JointData& joints);
bool isSane(const JointGains& joints);
bool isSane(const OdometryData& odometry);
bool isSane(const TeamMessage& message);

}  // namespace gt
