#pragma once
#include <memory>
#include <string>
#include <vector>

#include "network/ToolPort.h"
#include "representations/behavior/TeamMessage.h"

namespace gt {

/// A robot as the router knows it.
struct RoutedRobot {
  std::string name;
  std::string robot;     ///< Endpoint on which the robot listens for tools.
  std::string tools;     ///< Endpoint on which the router listens for tools of it; empty: on none.
  std::size_t team = 0;  ///< Robots with the same number are team mates; 0 of none.
};

/// What the router does besides passing messages.
struct RouterOptions {
  std::vector<RoutedRobot> robots;
  std::string all;  ///< Endpoint for tools of all robots, such as a game manager; empty: none.
  std::optional<Keys> listenKeys;   ///< For tools.
  std::optional<Keys> connectKeys;  ///< For robots.
};

/// Splits the report's way to name robots (report 5.3): `10.0.1.100`, or `10.0.1 100 101 102` for
/// several of a subnet, or `NAME=ENDPOINT`. Robots of a subnet listen on `port`, the router for
/// their tools on `port` + the last number of their address, for others on the ports from `port` +
/// 301 on. The first four are one team, the others another.
Result<std::vector<RoutedRobot>> parseRobots(const std::vector<std::string>& arguments,
                                             const std::string& listen, int port);

/// Passes message queues between robots and tools (report 5.3): each robot has a port, on which
/// any number of tools sees all it sends and may send to it. Brings team messages to the robots'
/// team mates.
class Router {
 public:
  static Result<std::unique_ptr<Router>> open(const RouterOptions& options);

  /// Waits up to some ms for messages and passes them on.
  void step(std::int64_t ms);

  struct Statistics {
    std::string robot;
    bool connected = false;
    std::size_t tools = 0;
    std::uint64_t toTools = 0, toRobot = 0, dropped = 0, rejected = 0;  ///< Messages so far.
  };
  std::vector<Statistics> statistics() const;
  /// Where tools of all robots connect.
  std::string endpointOfAll() const { return all_ ? all_->endpoint() : ""; }
  std::string endpointOf(std::size_t robot) const { return routes_[robot]->tools->endpoint(); }

 private:
  struct Route {
    RoutedRobot robot;
    std::unique_ptr<ToolConnection> connection;
    std::unique_ptr<ToolPort> tools;
    TeamMessages mates;
    bool matesChanged = false;
    Time clock;  ///< Of the robot: the newest of its messages.
    std::int64_t asked = -1;
    std::uint64_t toTools = 0, toRobot = 0;
    MessageQueue fromRobot{2 * toolQueueSize}, fromTools{2 * toolQueueSize};
  };

  Router() = default;
  void passFromRobot(Route& route);
  void passToRobot(Route& route);
  void passTeamMessage(const Route& from, const Message& message);
  void askForTeamMessages(Route& route);

  Network network_;
  std::vector<std::unique_ptr<Route>> routes_;
  std::unique_ptr<ToolPort> all_;
  MessageQueue toAll_{2 * toolQueueSize};
};

}  // namespace gt
