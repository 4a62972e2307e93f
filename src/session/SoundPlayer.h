#pragma once
#include <map>
#include <string>

#include "base/Time.h"
#include "devices/SdlSpeaker.h"
#include "session/Session.h"

namespace gt {

/// Plays on this machine what the loudspeakers of a session's robots begin to play.
class SoundPlayer {
 public:
  /// `folder` holds the wave files.
  explicit SoundPlayer(std::string folder) : folder_{std::move(folder)} {}

  /// Plays what has begun since this was called last; nothing at the first time. Returns an error
  /// if this machine cannot play it.
  Result<void> follow(Session& session, const std::vector<ConsoleRobot*>& robots);

 private:
  std::string folder_;
  SdlSpeaker speaker_;
  std::map<std::string, Time> began_;  ///< The last sound of each robot.
};

}  // namespace gt
