#pragma once
#include <map>
#include <string>

#include "base/Time.h"
#include "devices/SdlSpeaker.h"
#include "session/Session.h"

namespace gt {

/// Plays on this machine the sounds that the loudspeakers of a session's robots begin to play.
class SoundPlayer {
 public:
  /// `folder` holds the wave files.
  explicit SoundPlayer(std::string folder) : folder_{std::move(folder)} {}

  /// Plays the sounds that have begun since the last call; none at the first call. Returns an error
  /// if this machine cannot play one.
  Result<void> follow(Session& session, const std::vector<ConsoleRobot*>& robots);

 private:
  std::string folder_;
  SdlSpeaker speaker_;
  std::map<std::string, Time> began_;  ///< The last sound of each robot.
};

}  // namespace gt
