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
  std::string tools;  ///< Endpoint on which the router listens for tools of it; empty: on none.
  std::string team;   ///< Robots of the same one are teammates; empty: of none.
};

/// A team message as routers send it to each other.
struct RoutedTeamMessage {
  std::string team;
  TeamMessage message;

  static constexpr auto fields() {
    return Fields{field<&RoutedTeamMessage::team>("as RoutedRobot::team"),
                  field<&RoutedTeamMessage::message>()};
  }
};

/// What the router does besides passing messages.
struct RouterOptions {
  std::vector<RoutedRobot> robots;
  std::string all;      ///< Endpoint for tools of all robots, such as a game manager; empty: none.
  std::string routers;  ///< Endpoint for other routers; empty: none.
  std::vector<std::string> others;  ///< Endpoints on which other routers listen for this one.
  std::optional<Keys> listenKeys;   ///< For tools and other routers.
  std::optional<Keys> connectKeys;  ///< For robots and other routers.
};

/// Passes message queues between robots and tools (report 5.3): each robot has a port, on which
/// any number of tools sees all it sends and may send to it. Brings team messages to the robots'
/// teammates, also to those at other routers: each two routers are connected, and a message goes
/// from the sender's router to all others.
class Router {
 public:
  static Result<std::unique_ptr<Router>> open(const RouterOptions& options);

  /// Serves one more robot.
  Result<void> add(const RoutedRobot& robot);
  /// Waits up to some ms for messages and passes them on.
  void step(std::int64_t ms);

  struct Statistics {
    std::string robot;
    bool connected = false;
    std::string trouble{};  ///< Why it is not, as far as it is known.
    std::size_t tools = 0;
    std::uint64_t toTools = 0, toRobot = 0, dropped = 0, rejected = 0;  ///< Messages so far.
  };
  std::vector<Statistics> statistics() const;
  /// Who was not let in at each port, by its name.
  std::vector<std::pair<std::string, Refusals>> refusals() const;
  /// The same as lines for the user that were not taken yet: of each port and reason one, once.
  std::vector<std::string> takeNews();
  /// How many other routers are there.
  std::size_t routers() const;
  /// Milliseconds since it was opened.
  std::int64_t elapsed() const { return network_.elapsed(); }
  /// Where tools of all robots connect.
  std::string endpointOfAll() const { return all_ ? all_->endpoint() : ""; }
  /// Where other routers connect.
  std::string endpointOfRouters() const { return routers_ ? routers_->endpoint() : ""; }
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
