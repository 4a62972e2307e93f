#pragma once
#include <string>
#include <vector>

#include "network/RobotList.h"

namespace gt {

/// The arguments of the router's command line, and what is kept of them for the next start.
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
        field<&RouterSettings::robots>("as on the command line (report 5.3)"),
        field<&RouterSettings::sockets>("folder of the robots of this machine"),
        field<&RouterSettings::listen>("address on which tools connect"),
        field<&RouterSettings::port>("of robots", {1, 65000}),
        field<&RouterSettings::release>("only team messages"),
        field<&RouterSettings::gameManager>("a port for tools of all robots"),
        field<&RouterSettings::noTeams>("no team messages"),
        field<&RouterSettings::team>("of all robots; empty: as they are named"),
        field<&RouterSettings::routers>("a port for other routers"),
        field<&RouterSettings::join>("endpoints of other routers"),
        field<&RouterSettings::keys>("key file for listening"),
        field<&RouterSettings::connectKeys>("key file for connecting"),
        field<&RouterSettings::foxglove>("where viewers connect; empty: nowhere"),
        field<&RouterSettings::foxgloveOrigins>("of viewers in browsers, beside this machine")};
  }

  RobotList::Places places() const { return {listen, port, sockets}; }
  /// Where the router listens for tools of all robots, and for other routers.
  std::string endpoint(int number) const {
    return "tcp://" + listen + ":" + std::to_string(port + number);
  }
  /// A robot of the list as these settings want it.
  RoutedRobot wanted(RoutedRobot robot) const;
};

/// Above the router's port: the ports for other routers, and for tools of all robots.
constexpr int routersPort = 299;
constexpr int allRobotsPort = 300;

/// What the router shall do, but for its robots; reads the key files.
Result<RouterOptions> routerOptions(const RouterSettings& settings);

/// The file with the settings of the last start, in the folder for a user's state of programs
/// ($XDG_STATE_HOME, or ~/.local/state); empty if the user has none.
std::string lastSettingsFile();
/// Keeps settings for the next start; makes the folder.
Result<void> keepSettings(const RouterSettings& settings, const std::string& file);

}  // namespace gt
