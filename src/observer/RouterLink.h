#pragma once
#include <memory>

#include "network/Router.h"
#include "observer/RobotLink.h"

namespace gt {

/// The message queues of a robot in another program, by its port at a router in this program.
class RouterLink : public RobotLink {
 public:
  /// Connects to the port of a robot of the router, which is given by its index. The router, the
  /// network and the vocabulary must outlive the link. The keys are required if the router only
  /// accepts tools with keys.
  static Result<std::unique_ptr<RouterLink>> open(Router& router, std::size_t robot,
                                                  Network& network, const Vocabulary& vocabulary,
                                                  const std::optional<Keys>& keys = {});

  RobotKind kind() const override { return RobotKind::physical; }
  MessageQueue& toRobot() override { return connection_->out(); }
  void exchange(const Taker& take) override;
  /// Zero for a robot that is not connected, because it cannot answer.
  std::chrono::milliseconds patience() const override;

 private:
  RouterLink(Router& router, std::size_t robot, std::unique_ptr<ToolConnection> connection)
      : router_{router}, robot_{robot}, connection_{std::move(connection)} {}

  Router& router_;
  std::size_t robot_;
  std::unique_ptr<ToolConnection> connection_;
  MessageQueue messages_{2 * toolQueueSize};
};

}  // namespace gt
