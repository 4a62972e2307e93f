#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "workbench/SessionThread.h"

namespace gt {

/// What a robot's behavior sends about its decisions (xabsl/tools/trace), collected for a dialog:
/// also of robots on logs, where it comes from the log if the behavior does not run itself.
class BehaviorTraces {
 public:
  explicit BehaviorTraces(SessionThread& session);

  /// Collects those of another robot from now on; empty: of the connected one.
  void follow(const std::string& robot);
  /// The texts that came since this was called last. The first states what all others are about.
  std::deque<std::string> takeParts();
  /// Whether the robots are other ones since this was asked last.
  bool beganAnew();

 private:
  class Collector;

  SessionThread& session_;
  std::shared_ptr<Collector> collector_;
  std::shared_ptr<const void> handle_;  ///< Its end ends the collecting.
  std::uint64_t beginnings_ = 0;
};

}  // namespace gt
