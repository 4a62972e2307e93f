#pragma once
#include <string>
#include <vector>

#include "foxglove/FoxgloveServer.h"
#include "match/Match.h"

namespace gt {

/// What `simgt console` was asked for.
struct ConsoleOptions {
  MatchOptions match;
  std::vector<std::string> scripts;   ///< Executed one after another, before anything is typed.
  std::vector<std::string> commands;  ///< Likewise, behind them.
  FoxgloveAccess foxglove;
};

/// Runs a scene with a console: its start script, then scripts and commands of the command line, or
/// else what is typed or piped in. Returns the program's exit status: 1 if an expectation failed, 2
/// after an error that ended it.
int runConsole(const ConsoleOptions& options);

}  // namespace gt
