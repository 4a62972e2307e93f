#include "network/Router.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "framework/Requests.h"

namespace gt {
namespace {

constexpr std::size_t robotsPerTeam = 4;
/// The tools' ports of robots without a number of their own.
constexpr int firstNamedPort = 301;
/// A robot that was started anew is asked again for its team messages, in ms.
constexpr std::int64_t askAfter = 2000;

std::optional<int> numberIn(std::string_view text, int low, int high) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < low || number > high)
    return {};
  return number;
}

/// The parts of an address of numbers between dots; empty if it is none.
std::vector<int> numbersOf(const std::string& text) {
  std::vector<int> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t dot = std::min(text.find('.', at), text.size());
    const auto number = numberIn(std::string_view{text}.substr(at, dot - at), 0, 255);
    if (!number) return {};
    numbers.push_back(*number);
    at = dot + 1;
  }
  return numbers;
}

}  // namespace

Result<std::vector<RoutedRobot>> parseRobots(const std::vector<std::string>& arguments,
                                             const std::string& listen, int port) {
  std::vector<RoutedRobot> robots;
  std::string subnet;
  int named = 0;
  const auto add = [&](const std::string& name, const std::string& endpoint, int number) {
    robots.push_back({name, endpoint, "tcp://" + listen + ":" + std::to_string(port + number),
                      robots.size() / robotsPerTeam + 1});
  };
  for (const std::string& argument : arguments) {
    const auto equals = argument.find('=');
    const std::vector<int> numbers = numbersOf(argument);
    if (equals != argument.npos && equals > 0 && equals + 1 < argument.size())
      add(argument.substr(0, equals), argument.substr(equals + 1), firstNamedPort + named++);
    else if (numbers.size() == 4)
      add(argument, "tcp://" + argument + ":" + std::to_string(port), numbers.back());
    else if (numbers.size() == 3)
      subnet = argument + ".";
    else if (numbers.size() == 1 && !subnet.empty())
      add(subnet + argument, "tcp://" + subnet + argument + ":" + std::to_string(port), numbers[0]);
    else
      return Error{"", 0, argument,
                   "is no robot: expected NAME=ENDPOINT, an address as "
                   "10.0.1.100, or a subnet and numbers as 10.0.1 100 101"};
  }
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (robots[i].tools == robots[j].tools || robots[i].name == robots[j].name)
        return Error{"", 0, robots[i].name, "has the name or number of another robot"};
  return robots;
}

Result<std::unique_ptr<Router>> Router::open(const RouterOptions& options) {
  std::unique_ptr<Router> router{new Router};
  for (const RoutedRobot& robot : options.robots) {
    auto route = std::make_unique<Route>();
    route->robot = robot;
    auto connection = ToolConnection::open(router->network_, robot.robot, options.connectKeys);
    if (!connection) return connection.error();
    route->connection = std::move(*connection);
    if (!robot.tools.empty()) {
      auto tools = ToolPort::open(router->network_, robot.tools, options.listenKeys);
      if (!tools) return tools.error();
      route->tools = std::move(*tools);
    }
    router->routes_.push_back(std::move(route));
  }
  if (!options.all.empty()) {
    auto all = ToolPort::open(router->network_, options.all, options.listenKeys);
    if (!all) return all.error();
    router->all_ = std::move(*all);
  }
  return router;
}

void Router::step(std::int64_t ms) {
  network_.wait(ms, std::min<std::int64_t>(ms, 2));
  if (all_) all_->update(toAll_);
  for (const auto& route : routes_) {
    toAll_.copyAllMessages(route->connection->out());
    passFromRobot(*route);
  }
  toAll_.clear();
  for (const auto& route : routes_) passToRobot(*route);
}

void Router::passFromRobot(Route& route) {
  route.connection->update(route.fromRobot);
  route.fromRobot.handleAllMessages([&](const Message& message) {
    ++route.toTools;
    route.clock = std::max(route.clock, message.time);
    if (route.robot.team > 0 && message.is<TeamMessage>()) passTeamMessage(route, message);
  });
  if (route.tools) route.tools->send(route.fromRobot);
  if (all_) all_->send(route.fromRobot);
  route.fromRobot.clear();
}

void Router::passTeamMessage(const Route& from, const Message& message) {
  TeamMessage content;
  if (!message.read(content)) return;
  for (const auto& mate : routes_) {
    if (mate.get() == &from || mate->robot.team != from.robot.team) continue;
    const auto player = static_cast<std::size_t>(content.playerNumber) - 1;
    if (player >= mate->mates.byPlayer.size()) return;
    mate->mates.byPlayer[player] = {content, mate->clock};
    mate->matesChanged = true;
  }
}

/// Team mates need each other's messages whether or not a tool asked for them.
void Router::askForTeamMessages(Route& route) {
  const bool due = route.asked < 0 || network_.elapsed() - route.asked >= askAfter;
  if (route.robot.team == 0 || !route.connection->connected() || !due) return;
  route.connection->out().write({}, WatchRequest{"TeamMessage", ""});
  route.asked = network_.elapsed();
}

void Router::passToRobot(Route& route) {
  if (route.tools) route.tools->update(route.fromTools);
  askForTeamMessages(route);
  if (route.matesChanged && route.connection->out().write(route.clock, route.mates))
    route.matesChanged = false;
  route.fromTools.handleAllMessages([&](const Message&) { ++route.toRobot; });
  route.fromTools.copyAllMessages(route.connection->out());
  route.fromTools.clear();
}

std::vector<Router::Statistics> Router::statistics() const {
  std::vector<Statistics> list;
  for (const auto& route : routes_) {
    Statistics& s = list.emplace_back();
    s.robot = route->robot.name;
    s.connected = route->connection->connected();
    s.toTools = route->toTools;
    s.toRobot = route->toRobot;
    s.dropped = route->connection->out().dropped();
    s.rejected = route->connection->rejected();
    if (!route->tools) continue;
    s.tools = route->tools->tools();
    s.dropped += route->tools->dropped();
    s.rejected += route->tools->rejected();
  }
  return list;
}

}  // namespace gt
