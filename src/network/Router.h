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
  std::string robot;  ///< Endpoint on which the robot listens for tools.
  std::string tools;  ///< Endpoint on which the router listens for tools of this robot; empty:
                      ///< none.
  std::string team;   ///< Robots of the same team are teammates; empty: no team.
};

/// A team message as exchanged between routers.
struct RoutedTeamMessage {
  std::string team;
  TeamMessage message;

  static constexpr auto fields() {
    return Fields{field<&RoutedTeamMessage::team>("team of the sender, see RoutedRobot::team"),
                  field<&RoutedTeamMessage::message>()};
  }
};

/// Options of the router besides its robots.
struct RouterOptions {
  std::vector<RoutedRobot> robots;
  std::string all;      ///< Endpoint for tools of all robots, such as a game manager; empty: none.
  std::string routers;  ///< Endpoint for other routers; empty: none.
  std::vector<std::string> others;  ///< Endpoints on which other routers listen for this one.
  std::optional<Keys> listenKeys;   ///< For tools and other routers.
  std::optional<Keys> connectKeys;  ///< For robots and other routers.
};

/// Transfers message queues between robots and tools (report 5.3). Each robot has a port for any
/// number of tools, which receive everything that the robot sends and may send messages to it.
/// Delivers team messages to the robots' teammates, also to those at other routers. All routers are
/// connected pairwise, and a message is sent from the sender's router to all others.
class Router {
 public:
  static Result<std::unique_ptr<Router>> open(const RouterOptions& options);

  /// Serves an additional robot.
  Result<void> add(const RoutedRobot& robot);
  /// Waits up to `ms` for messages and transfers them.
  void step(std::int64_t ms);

  struct Statistics {
    std::string robot;
    bool connected = false;
    std::string trouble{};  ///< Why the robot is not connected, if known.
    std::size_t tools = 0;
    std::uint64_t toTools = 0, toRobot = 0, dropped = 0, rejected = 0;  ///< Messages so far.
  };
  std::vector<Statistics> statistics() const;
  /// The refused connections at each port, by its name.
  std::vector<std::pair<std::string, Refusals>> refusals() const;
  /// Refused connections that were not reported yet, as lines for the user: one line for each port
  /// and reason, only once.
  std::vector<std::string> takeNews();
  /// Number of connected other routers.
  std::size_t routers() const;
  /// Time (ms) since the router was opened.
  std::int64_t elapsed() const { return network_.elapsed(); }
  /// Endpoint for tools of all robots.
  std::string endpointOfAll() const { return all_ ? all_->endpoint() : ""; }
  /// Endpoint for other routers.
  std::string endpointOfRouters() const { return routers_ ? routers_->endpoint() : ""; }
  std::string endpointOf(std::size_t robot) const { return routes_[robot]->tools->endpoint(); }

 private:
  struct Route {
    RoutedRobot robot;
    std::unique_ptr<ToolConnection> connection;
    std::unique_ptr<ToolPort> tools;
    TeamMessages mates;
    bool matesChanged = false;
    Time clock;  ///< Clock of the robot: time of its newest message.
    std::int64_t asked = -1;
    std::uint64_t toTools = 0, toRobot = 0;
    MessageQueue fromRobot{2 * toolQueueSize}, fromTools{2 * toolQueueSize};
  };

  explicit Router(const RouterOptions& options)
      : listenKeys_{options.listenKeys}, connectKeys_{options.connectKeys} {}
  Result<void> openRouters(const RouterOptions& options);
  void passFromRobot(Route& route);
  void passToRobot(Route& route);
  void passTeamMessage(const Route& from, const Message& message);
  void notifyTeammates(const RoutedTeamMessage& routed, const Route* from);
  void exchangeWithRouters();
  void askForTeamMessages(Route& route);
  std::vector<std::pair<std::string, ToolPort*>> ports() const;

  std::optional<Keys> listenKeys_, connectKeys_;
  Network network_;
  std::vector<std::unique_ptr<Route>> routes_;
  std::unique_ptr<ToolPort> all_, routers_;
  std::vector<std::unique_ptr<ToolConnection>> others_;
  MessageQueue toAll_{2 * toolQueueSize};
  MessageQueue toRouters_{2 * toolQueueSize}, fromRouters_{2 * toolQueueSize};
};

}  // namespace gt
