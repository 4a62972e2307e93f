#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/TemporaryFolder.h"
#include "network/RobotList.h"
#include "session/ConsoleRobot.h"

namespace gt {

/// The connection to robots whose processes are programs elsewhere (report I.5.1: sc): a router
/// runs in the background, and a tool is connected to each of its robots.
class RobotConnection {
 public:
  /// Connects to robots in the router's notation (RobotList), which are named by the last number of
  /// their address. With `gameManager` there is a port for tools of all robots, too. If no keys for
  /// robots of other machines are passed, those in `config/tool.key` of the root are taken, if that
  /// file exists.
  static Result<std::unique_ptr<RobotConnection>> open(const std::vector<std::string>& robots,
                                                       bool gameManager, const DataRoot& root,
                                                       std::optional<Keys> keys = {});

  /// Forwards messages in both directions.
  void step();
  /// The endpoint for a game manager; empty if there is no such port.
  std::string gameManager() const { return router_->endpointOfAll(); }
  /// The robots, which the caller keeps; the connection must outlive them.
  std::vector<std::unique_ptr<ConsoleRobot>> takeRobots() { return std::move(robots_); }
  /// The changes since the last call: a line for each robot that connected or disconnected.
  std::vector<std::string> news();
  /// State of each robot's connection, and the number of messages that passed through it.
  std::vector<Router::Statistics> statistics() const { return router_->statistics(); }
  /// The robots that are not connected.
  std::vector<Router::Statistics> silent() const;

 private:
  RobotConnection() = default;

  TemporaryFolder sockets_;
  std::unique_ptr<Router> router_;
  Network network_;
  std::vector<std::unique_ptr<ConsoleRobot>> robots_;
  std::vector<bool> connected_;
};

}  // namespace gt
