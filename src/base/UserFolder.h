#pragma once
#include <string>

namespace gt {

/// Folders of the user for files that a program writes without being asked to, so that these never
/// go to the working directory.
enum class UserFolder {
  cache,    ///< Data that can be recreated: $XDG_CACHE_HOME, or ~/.cache.
  config,   ///< Settings: $XDG_CONFIG_HOME, or ~/.config.
  state,    ///< History, last session, crash reports: $XDG_STATE_HOME, or ~/.local/state.
  runtime,  ///< Sockets: $XDG_RUNTIME_DIR.
};

/// The subfolder gt2003 of a user's folder, by the XDG Base Directory Specification: variables that
/// hold no absolute path are ignored. Empty if the user has no such folder. The subfolder need not
/// exist.
std::string userFolder(UserFolder folder);

}  // namespace gt
