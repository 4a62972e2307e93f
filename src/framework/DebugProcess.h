#pragma once
#include <memory>
#include <string>
#include <vector>

#include "framework/Process.h"
#include "framework/QueueFill.h"
#include "framework/RequestTypes.h"

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
  using Requests = RequestTypes<QueueFillRequest>;
  /// Fills the queue to the tools in another way; an error if the request makes no sense. Requests
  /// also come in by message.
  Result<void> request(const QueueFillRequest& request);
  /// What takes messages that a request asks to save (report I: `qfr save`).
  void onSave(QueueFill::Saver saver) { fill_.onSave(std::move(saver)); }
  /// Goes on where another one stops: with its messages, and as its queue was asked to be filled.
  void adopt(DebugProcess& other);
  /// What came from the processes since it was last taken.
  MessageQueue& toTools() { return toTools_; }
  /// What shall go to all processes in the next cycle.
  MessageQueue& fromTools() { return fromTools_; }
  /// Carries out what the tools ask of this process, and takes it out of their messages.
  void handleRequests();

 protected:
  int main() override;

 private:
  struct In {
    MessageQueue queue;
    PackageReceiver receiver{representation<MessageQueue>(), &queue};
  };
  std::vector<std::unique_ptr<In>> in_;
  QueueFill fill_;
  MessageQueue toTools_{8 << 20};
  MessageQueue fromTools_;
  MessageQueue out_;
  /// Knows whether all processes have taken the last queue; not registered, since collecting goes
  /// on meanwhile.
  PackageSender sender_{representation<MessageQueue>(), &out_, true};
};

}  // namespace gt
