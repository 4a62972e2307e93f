#include "Viewers.h"

#include <algorithm>

#include "logs/MessageTypes.h"
#include "observer/RouterLink.h"

namespace gt {

Viewers::Viewers(Router& router, std::unique_ptr<FoxgloveServer> server)
    : router_{router}, vocabulary_{messageTypes()}, server_{std::move(server)} {}

Result<std::unique_ptr<Viewers>> Viewers::open(Router& router, const RouterSettings& settings,
                                               const RouterOptions& options) {
  if (settings.release) return Error{.field = "--foxglove", .what = "needs ports for tools"};
  if (options.listenKeys && !options.connectKeys)
    return Error{.field = "--foxglove", .what = "needs --connect-keys where there is --keys"};
  auto server =
      FoxgloveServer::open({settings.foxglove, settings.foxgloveOrigins}, "GT2003 router");
  if (!server) return server.error();
  std::unique_ptr<Viewers> viewers{new Viewers{router, std::move(*server)}};
  if (options.listenKeys) viewers->keys_ = options.connectKeys;
  return viewers;
}

Result<void> Viewers::update() {
  const auto statistics = router_.statistics();
  for (std::size_t i = robots_.size(); i < statistics.size(); ++i) {
    auto link = RouterLink::open(router_, i, network_, vocabulary_, keys_);
    if (!link) return link.error();
    robots_.push_back(std::make_unique<ObservedRobot>(statistics[i].robot, std::move(*link)));
  }
  FoxgloveSubject subject{.now = {}, .field = {}};
  for (const auto& robot : robots_) {
    robot->update();
    subject.now = std::max(subject.now, robot->time());
    subject.robots.push_back(robot.get());
  }
  server_->update(subject);
  return {};
}

}  // namespace gt
