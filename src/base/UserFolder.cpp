#include "base/UserFolder.h"

#include <cstdlib>
#include <filesystem>

namespace gt {
namespace {

namespace fs = std::filesystem;

/// The absolute path in a variable of the environment; empty if it holds none.
fs::path pathIn(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value == '/' ? fs::path{value} : fs::path{};
}

fs::path ofHome(const char* folder) {
  const fs::path home = pathIn("HOME");
  return home.empty() || !*folder ? fs::path{} : home / folder;
}

}  // namespace

std::string userFolder(UserFolder folder) {
  struct Place {
    const char *variable, *ofHome;
  };
  constexpr Place places[]{{"XDG_CACHE_HOME", ".cache"},
                           {"XDG_CONFIG_HOME", ".config"},
                           {"XDG_STATE_HOME", ".local/state"},
                           {"XDG_RUNTIME_DIR", ""}};
  const Place& place = places[static_cast<std::size_t>(folder)];
  fs::path found = pathIn(place.variable);
  if (found.empty()) found = ofHome(place.ofHome);
  return found.empty() ? "" : (found / "gt2003").string();
}

}  // namespace gt
