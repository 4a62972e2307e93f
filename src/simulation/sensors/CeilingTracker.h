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

/// Tracks robots and ball through the images of a camera at the ceiling, and provides the result as
/// an oracled world state, for experiments without knowledge of the truth (report 6.2.2).
class CeilingTracker {
 public:
  /// Updates the tracks; observations that are no numbers or of no robot of a team are ignored.
  void update(const CeilingCameraPercept& percept);
  /// Fills `state` with the world at the time `now`, in the team's coordinates. Returns false if
  /// the robot was not seen for half a second. Other robots that were not seen in that time are
  /// left out; a ball that was not seen in that time rests at its last position.
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

/// Reads a log of a camera at the ceiling, simulated or real. Returns an error if the log lacks the
/// topic or cannot be read as a whole.
Result<std::vector<CeilingCameraPercept>> readCeilingLog(const std::string& path);

}  // namespace gt
