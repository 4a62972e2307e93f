#include "observer/RouterLink.h"

namespace gt {
namespace {

constexpr std::chrono::milliseconds answering{1500};

}  // namespace

Result<std::unique_ptr<RouterLink>> RouterLink::open(Router& router, std::size_t robot,
                                                     Network& network, const Vocabulary& vocabulary,
                                                     const std::optional<Keys>& keys) {
  auto tool = ToolConnection::open(network, router.endpointOf(robot), keys, &vocabulary);
  if (!tool) return tool.error();
  return std::unique_ptr<RouterLink>{new RouterLink{router, robot, std::move(*tool)}};
}

void RouterLink::exchange(const Taker& take) {
  router_.step(0);
  connection_->update(messages_);
  take(messages_);
  messages_.clear();
}

std::chrono::milliseconds RouterLink::patience() const {
  return router_.statistics()[robot_].connected ? answering : std::chrono::milliseconds{0};
}

}  // namespace gt
