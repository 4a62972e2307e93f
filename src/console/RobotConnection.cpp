#include "console/RobotConnection.h"

#include <filesystem>

#include "robot/Solutions.h"

namespace gt {
namespace {

constexpr int robotPort = 15000;

/// The message queues of a robot elsewhere, by its port at the router.
class ConnectionLink : public RobotLink {
 public:
  ConnectionLink(Router& router, std::size_t robot, std::unique_ptr<ToolConnection> connection)
      : router_{router}, robot_{robot}, connection_{std::move(connection)} {}
  RobotKind kind() const override { return RobotKind::physical; }
  MessageQueue& toRobot() override { return connection_->out(); }
  void exchange(const Taker& take) override {
    router_.step(0);
    connection_->update(messages_);
    take(messages_);
    messages_.clear();
  }
  /// A robot that is not connected cannot answer.
  std::chrono::milliseconds patience() const override {
    return std::chrono::milliseconds{router_.statistics()[robot_].connected ? 1500 : 0};
  }

 private:
  Router& router_;
  std::size_t robot_;
  std::unique_ptr<ToolConnection> connection_;
  MessageQueue messages_{2 * toolQueueSize};
};

class ConnectedRobot : public ConsoleRobot {
 public:
  using ConsoleRobot::ConsoleRobot;
  Result<void> step(Time) override {
    observed().update();
    return {};
  }
};

/// The report names a robot by the least significant byte of its address.
std::string shortName(const std::string& name) {
  const bool address = name.find_first_not_of("0123456789.") == name.npos;
  return address ? name.substr(name.rfind('.') + 1) : name;
}

}  // namespace

Result<std::unique_ptr<RobotConnection>> RobotConnection::open(
    const std::vector<std::string>& robots, bool gameManager, const DataRoot& root,
    std::optional<Keys> keys) {
  std::unique_ptr<RobotConnection> connection{new RobotConnection};
  const auto routed = RobotList::parse(robots, {"127.0.0.1", robotPort, ""});
  if (!routed) return routed.error();
  if (routed->robots().empty() || routed->searches())
    return Error{.field = "sc", .what = "expected an address"};
  RouterOptions options;
  options.robots = routed->robots();
  if (gameManager) options.all = "tcp://127.0.0.1:" + std::to_string(robotPort + 300);
  for (RoutedRobot& robot : options.robots)
    robot.tools = "ipc://" + (connection->sockets_.path() / shortName(robot.name)).string();
  if (const std::string file = root.path("config/tool.key");
      !keys && std::filesystem::exists(file)) {
    auto loaded = loadKeys(file);
    if (!loaded) return loaded.error();
    keys = std::move(*loaded);
  }
  options.connectKeys = std::move(keys);
  auto router = Router::open(options);
  if (!router) return router.error();
  connection->router_ = std::move(*router);
  for (std::size_t i = 0; i < options.robots.size(); ++i) {
    auto tool = ToolConnection::open(connection->network_, connection->router_->endpointOf(i), {},
                                     &robotVocabulary());
    if (!tool) return tool.error();
    connection->robots_.push_back(std::make_unique<ConnectedRobot>(
        shortName(options.robots[i].name),
        std::make_unique<ConnectionLink>(*connection->router_, i, std::move(*tool))));
  }
  connection->connected_.resize(options.robots.size(), false);
  return connection;
}

void RobotConnection::step() {
  router_->step(0);
}

std::vector<std::string> RobotConnection::silent() const {
  std::vector<std::string> names;
  for (const auto& robot : router_->statistics())
    if (!robot.connected) names.push_back(robot.robot);
  return names;
}

std::vector<std::string> RobotConnection::news() {
  std::vector<std::string> lines;
  const auto statistics = router_->statistics();
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    if (statistics[i].connected == connected_[i]) continue;
    connected_[i] = statistics[i].connected;
    lines.push_back("router: " + statistics[i].robot +
                    (connected_[i] ? " is connected" : " is gone"));
  }
  return lines;
}

}  // namespace gt
