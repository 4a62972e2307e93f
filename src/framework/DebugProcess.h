#pragma once
#include <memory>
#include <string>
#include <vector>

#include "framework/Process.h"

namespace gt {

/// The process that collects messages from all other processes for the tools, and distributes the
/// tools' messages to them (report 2.2.3.2).
class DebugProcess : public Process {
 public:
  explicit DebugProcess(std::string name) : Process{std::move(name)} {}

  /// Connects to one of the robot's processes by its queues.
  void connect(PackageSender& fromProcess, PackageLink& toProcess);
  /// The same in two halves, for processes in other programs: receives from one more of them; sends
  /// to all.
  PackageReceiver& addReceiver();
  PackageSender& sender() { return sender_; }
  /// What came from the processes since it was last taken.
  MessageQueue& toTools() { return toTools_; }
  /// What shall go to all processes in the next cycle.
  MessageQueue& fromTools() { return fromTools_; }

 protected:
  int main() override;

 private:
  struct In {
    MessageQueue queue;
    PackageReceiver receiver{representation<MessageQueue>(), &queue};
  };
  std::vector<std::unique_ptr<In>> in_;
  MessageQueue toTools_{8 << 20};
  MessageQueue fromTools_;
  MessageQueue out_;
  /// Tells whether all processes have taken the last queue; not enlisted, since collecting goes on
  /// meanwhile.
  PackageSender sender_{representation<MessageQueue>(), &out_, true};
};

}  // namespace gt
