#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "workbench/SessionThread.h"

namespace gt {

/// Collects for a dialog the traces that a robot's behavior sends about its decisions
/// (xabsl/tools/trace). For robots on logs, traces are taken from the log if the behavior does not
/// run itself.
class BehaviorTraces {
 public:
  explicit BehaviorTraces(SessionThread& session);

  /// Collects the traces of another robot from now on; empty: of the connected one.
  void follow(const std::string& robot);
  /// The texts received since the last call. The first text describes what all others refer to.
  std::deque<std::string> takeParts();
  /// Whether the session was restarted, and so has other robots, since the last call.
  bool beganAnew();

 private:
  class Collector;

  SessionThread& session_;
  std::shared_ptr<Collector> collector_;
  std::shared_ptr<const void> handle_;  ///< Its destruction ends the collecting.
  std::uint64_t beginnings_ = 0;
};

}  // namespace gt
