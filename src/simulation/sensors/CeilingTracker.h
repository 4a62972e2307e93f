#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "base/Result.h"
#include "representations/infrastructure/CeilingCameraPercept.h"
#include "representations/infrastructure/OracledWorldState.h"

namespace gt {

/// Follows robots and ball through the images of a camera at the ceiling, and provides what an
/// oracle would: for experiments where nobody knows the truth (report 6.2.2).
class CeilingTracker {
 public:
  void update(const CeilingCameraPercept& percept);
  /// Fills in the world as it is now for a robot; false if that was not seen for half a second.
  /// What was not seen lately is left out; the ball stays where it was seen last.
  bool fill(TeamColor team, int number, Time now, OracledWorldState& state) const;

 private:
  /// A point that moves (an alpha-beta filter).
  struct Track {
    void follow(const Vector2d& seen, Time time);
    Vector2d at(Time time) const;

    Vector2d position = Vector2d::Zero(), speed = Vector2d::Zero();  ///< mm, mm/s
    Time seen = never();
  };
  struct RobotTrack {
    Track place;
    double rotation = 0;
  };

  EnumArray<TeamColor, std::array<RobotTrack, 4>> robots_;
  Track ball_;
};

/// The topic of a CeilingCameraPercept in a log.
constexpr const char* ceilingTopic = "/CeilingCameraPercept";

/// Reads a log of a camera at the ceiling, simulated or real.
Result<std::vector<CeilingCameraPercept>> readCeilingLog(const std::string& path);

}  // namespace gt
