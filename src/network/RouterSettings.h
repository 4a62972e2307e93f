#pragma once
#include <string>
#include <vector>

#include "network/RobotList.h"

namespace gt {

/// The arguments of the router's command line, which are kept for the next start.
struct RouterSettings {
  std::vector<std::string> robots;
  std::string sockets;
  std::string listen = "127.0.0.1";
  int port = 15000;
  bool release = false;
  bool gameManager = false;
  bool noTeams = false;
  std::string team;
  bool routers = false;
  std::vector<std::string> join;
  std::string keys;
  std::string connectKeys;
  std::string foxglove;
  std::vector<std::string> foxgloveOrigins;

  static constexpr auto fields() {
    return Fields{
        field<&RouterSettings::robots>("robots as on the command line (report 5.3)"),
        field<&RouterSettings::sockets>("folder of the sockets of this machine's robots"),
        field<&RouterSettings::listen>("address on which tools connect"),
        field<&RouterSettings::port>("port of robots", {1, 65000}),
        field<&RouterSettings::release>("whether only team messages are transferred"),
        field<&RouterSettings::gameManager>("a port for tools of all robots"),
        field<&RouterSettings::noTeams>("whether team messages are not transferred"),
        field<&RouterSettings::team>("team of all robots; empty: according to their names"),
        field<&RouterSettings::routers>("a port for other routers"),
        field<&RouterSettings::join>("endpoints of other routers"),
        field<&RouterSettings::keys>("key file for listening"),
        field<&RouterSettings::connectKeys>("key file for connecting"),
        field<&RouterSettings::foxglove>("endpoint for viewers; empty: none"),
        field<&RouterSettings::foxgloveOrigins>(
            "origins of viewers in browsers, in addition to this machine")};
  }

  RobotList::Places places() const { return {listen, port, sockets}; }
  /// The endpoint on which the router listens for tools of all robots, or for other routers.
  std::string endpoint(int number) const {
    return "tcp://" + listen + ":" + std::to_string(port + number);
  }
  /// A robot of the list, modified according to these settings.
  RoutedRobot wanted(RoutedRobot robot) const;
};

/// Offsets to the router's port: the ports for other routers, and for tools of all robots.
constexpr int routersPort = 299;
constexpr int allRobotsPort = 300;

/// The router's options except its robots; reads the key files.
Result<RouterOptions> routerOptions(const RouterSettings& settings);

/// The file with the settings of the last start, in the user's state folder ($XDG_STATE_HOME, or
/// ~/.local/state); empty if the user has none.
std::string lastSettingsFile();
/// Saves settings for the next start; creates the folder.
Result<void> keepSettings(const RouterSettings& settings, const std::string& file);

}  // namespace gt
