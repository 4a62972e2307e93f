#pragma once
#include <cstdint>
#include <optional>

#include "match/MatchRobot.h"

namespace gt {

/// Passes the commands that a robot provides to its body, for robots that answer in the tick in
/// which they sense.
class BodyCommands {
 public:
  template <typename T>
  using Provided = const T*;

  /// Pointers to the robot's values at the end of each cycle; null for commands that the robot does
  /// not provide.
  CommandSlots<Provided> places{};
  CameraSettings camera;  ///< The settings that the camera has.

  template <typename T>
  const T* place() const {
    return std::get<const T*>(places);
  }
  /// Fills the output with the commands of a cycle. To be called once after each cycle.
  void give(RobotOutput& output, const Belief& belief, bool withImage);

 private:
  template <typename T>
  void give(T& command, bool withImage) const;
  void give(std::optional<TeamMessage>& message, bool withImage) const;
  void give(std::optional<CameraSettings>& settings, bool withImage);

  std::int64_t images_ = 0;
};

/// Whether a command is valid for a robot's body or its team: other programs may send anything.
template <typename T>
bool isSane(const T&) {
  return true;
}
bool isSane(const JointData& joints);
bool isSane(const JointGains& joints);
bool isSane(const OdometryData& odometry);
bool isSane(const TeamMessage& message);

}  // namespace gt
