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
  /// The two halves of connect(), for processes in other programs: addReceiver() receives from one
  /// more process; sender() sends to all.
  PackageReceiver& addReceiver();
  PackageSender& sender() { return sender_; }
  using Requests = RequestTypes<QueueFillRequest>;
  /// Changes how the queue to the tools is filled. Returns an error if the request is invalid.
  /// Requests are also accepted as messages.
  Result<void> request(const QueueFillRequest& request);
  /// Sets the receiver of the messages that a request asks to save (report I: `qfr save`).
  void onSave(QueueFill::Saver saver) { fill_.onSave(std::move(saver)); }
  /// Takes over the messages and the queue fill request of another Debug process.
  void adopt(DebugProcess& other);
  /// Messages of the processes that were not taken yet.
  MessageQueue& toTools() { return toTools_; }
  /// Messages that are sent to all processes in the next cycle.
  MessageQueue& fromTools() { return fromTools_; }
  /// Executes the tools' requests that concern this process, and removes them from the messages.
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
  /// Reports whether all processes have taken the last queue. Not registered, because messages must
  /// be collected in the meantime.
  PackageSender sender_{representation<MessageQueue>(), &out_, true};
};

}  // namespace gt
