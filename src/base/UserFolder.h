#pragma once
#include <string>

namespace gt {

/// Where a program keeps for its user what nobody asked it to write: never in the working
/// directory.
enum class UserFolder {
  cache,    ///< What can be made again: $XDG_CACHE_HOME, or ~/.cache.
  config,   ///< Settings: $XDG_CONFIG_HOME, or ~/.config.
  state,    ///< History, what ran last, crash reports: $XDG_STATE_HOME, or ~/.local/state.
  runtime,  ///< Sockets: $XDG_RUNTIME_DIR.
};

/// This project's folder there, gt2003, by the XDG Base Directory Specification: variables that
/// hold no absolute path do not count. Empty if the user has no such folder. It need not exist.
std::string userFolder(UserFolder folder);

}  // namespace gt
