#include "network/Router.h"

#include <algorithm>

#include "framework/Requests.h"

namespace gt {
namespace {

/// A robot that was started anew is asked again for its team messages, in ms.
constexpr std::int64_t askAfter = 2000;

}  // namespace

Result<std::unique_ptr<Router>> Router::open(const RouterOptions& options) {
  std::unique_ptr<Router> router{new Router{options}};
  for (const RoutedRobot& robot : options.robots)
    if (auto done = router->add(robot); !done) return done.error();
  if (!options.all.empty()) {
    auto all = ToolPort::open(router->network_, options.all, options.listenKeys);
    if (!all) return all.error();
    router->all_ = std::move(*all);
  }
  if (auto done = router->openRouters(options); !done) return done.error();
  return router;
}

Result<void> Router::openRouters(const RouterOptions& options) {
  if (!options.routers.empty()) {
    auto port = ToolPort::open(network_, options.routers, listenKeys_);
    if (!port) return port.error();
    routers_ = std::move(*port);
  }
  for (const std::string& endpoint : options.others) {
    auto other = ToolConnection::open(network_, endpoint, connectKeys_);
    if (!other) return other.error();
    others_.push_back(std::move(*other));
  }
  return {};
}

Result<void> Router::add(const RoutedRobot& robot) {
  auto route = std::make_unique<Route>();
  route->robot = robot;
  if (!robot.tools.empty()) {
    auto tools = ToolPort::open(network_, robot.tools, listenKeys_);
    if (!tools) return tools.error();
    route->tools = std::move(*tools);
  }
  auto connection = ToolConnection::open(network_, robot.robot, connectKeys_);
  if (!connection) return connection.error();
  route->connection = std::move(*connection);
  routes_.push_back(std::move(route));
  return {};
}

void Router::step(std::int64_t ms) {
  network_.wait(ms, std::min<std::int64_t>(ms, 2));
  if (all_) all_->update(toAll_);
  for (const auto& route : routes_) {
    toAll_.copyAllMessages(route->connection->out());
    passFromRobot(*route);
  }
  toAll_.clear();
  exchangeWithRouters();
  for (const auto& route : routes_) passToRobot(*route);
}

void Router::passFromRobot(Route& route) {
  route.connection->update(route.fromRobot);
  route.fromRobot.handleAllMessages([&](const Message& message) {
    ++route.toTools;
    route.clock = std::max(route.clock, message.time);
    if (!route.robot.team.empty() && message.is<TeamMessage>()) passTeamMessage(route, message);
  });
  if (route.tools) {
    route.tools->relay(route.connection->theirs());
    route.tools->send(route.fromRobot);
  }
  if (all_) all_->send(route.fromRobot);
  route.fromRobot.clear();
}

void Router::passTeamMessage(const Route& from, const Message& message) {
  RoutedTeamMessage routed{from.robot.team, {}};
  if (!message.read(routed.message)) return;
  notifyTeammates(routed, &from);
  if (routers_ || !others_.empty()) toRouters_.write(message.time, routed);
}

void Router::notifyTeammates(const RoutedTeamMessage& routed, const Route* from) {
  const auto player = static_cast<std::size_t>(routed.message.playerNumber) - 1;
  for (const auto& mate : routes_) {
    if (mate.get() == from || mate->robot.team.empty() || mate->robot.team != routed.team) continue;
    if (player >= mate->mates.byPlayer.size()) return;
    mate->mates.byPlayer[player] = {routed.message, mate->clock};
    mate->matesChanged = true;
  }
}

/// Messages of other routers are not passed on to further ones: nothing goes round in circles.
void Router::exchangeWithRouters() {
  if (routers_) {
    routers_->send(toRouters_);
    routers_->update(fromRouters_);
  }
  for (const auto& other : others_) {
    // Nothing waits for who is not there: it would be old when it arrived.
    if (other->connected()) toRouters_.copyAllMessages(other->out());
    other->update(fromRouters_);
  }
  toRouters_.clear();
  fromRouters_.handleAllMessages([&](const Message& message) {
    RoutedTeamMessage routed;
    if (message.is<RoutedTeamMessage>() && message.read(routed)) notifyTeammates(routed, nullptr);
  });
  fromRouters_.clear();
}

/// Teammates need each other's messages whether or not a tool asked for them.
void Router::askForTeamMessages(Route& route) {
  const bool due = route.asked < 0 || network_.elapsed() - route.asked >= askAfter;
  if (route.robot.team.empty() || !route.connection->connected() || !due) return;
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

std::size_t Router::routers() const {
  const auto there = std::ranges::count_if(others_, [](const auto& o) { return o->connected(); });
  return static_cast<std::size_t>(there) + (routers_ ? routers_->tools() : 0);
}

std::vector<Router::Statistics> Router::statistics() const {
  std::vector<Statistics> list;
  for (const auto& route : routes_) {
    Statistics& s = list.emplace_back();
    s.robot = route->robot.name;
    s.connected = route->connection->connected();
    s.trouble = route->connection->trouble();
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

/// Where tools and other routers connect.
std::vector<std::pair<std::string, ToolPort*>> Router::ports() const {
  std::vector<std::pair<std::string, ToolPort*>> list;
  for (const auto& route : routes_)
    if (route->tools) list.emplace_back(route->robot.name, route->tools.get());
  if (all_) list.emplace_back("tools of all robots", all_.get());
  if (routers_) list.emplace_back("other routers", routers_.get());
  return list;
}

std::vector<std::pair<std::string, Refusals>> Router::refusals() const {
  std::vector<std::pair<std::string, Refusals>> list;
  for (const auto& [name, port] : ports()) list.emplace_back(name, port->refusals());
  return list;
}

std::vector<std::string> Router::takeNews() {
  std::vector<std::string> news;
  for (const auto& [name, port] : ports())
    for (const std::string& line : port->takeNews()) news.push_back(name + ": " + line);
  return news;
}

}  // namespace gt
