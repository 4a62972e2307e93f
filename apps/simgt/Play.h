#pragma once
#include <string>

#include "foxglove/FoxgloveServer.h"
#include "match/Match.h"

namespace gt {

/// What `simgt play` was asked for.
struct PlayOptions {
  MatchOptions match;
  std::string out = "out/match";
  std::string
      script;  ///< Console commands; what they do not take of the match is played after them.
  bool logs = true;
  bool strict = false;              ///< Fails because of warnings of the robots, too.
  bool realTime = false;            ///< No faster than the clock; so are matches of robots outside.
  std::vector<std::string> remote;  ///< Robots outside: NAME or NAME=ENDPOINT.
  FoxgloveAccess foxglove;
  std::string keys;  ///< Key file for those that connect from other machines; none if empty.
};

/// Plays a match with a progress bar and a line for each event, then writes match.json, times.json
/// and report.html, also of what was played until something ended it: a signal (EndSignals), an
/// error of the script, a robot's program that failed, an exception. Returns an error if it was one
/// of the last three, if a file is wrong, or if one could not be written; otherwise the program's
/// exit status: 128 more than the signal; 1 if an expectation of the script failed, or a robot
/// warned and the run is strict.
Result<int> play(PlayOptions options);

}  // namespace gt
