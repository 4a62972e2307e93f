#include "session/RobotConnection.h"

#include <filesystem>

#include "observer/RouterLink.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

constexpr int robotPort = 15000;

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
    auto link = RouterLink::open(*connection->router_, i, connection->network_, robotVocabulary());
    if (!link) return link.error();
    connection->robots_.push_back(
        std::make_unique<ConnectedRobot>(shortName(options.robots[i].name), std::move(*link)));
  }
  connection->connected_.resize(options.robots.size(), false);
  return connection;
}

void RobotConnection::step() {
  router_->step(0);
}

std::vector<Router::Statistics> RobotConnection::silent() const {
  auto robots = router_->statistics();
  std::erase_if(robots, [](const auto& robot) { return robot.connected; });
  return robots;
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
