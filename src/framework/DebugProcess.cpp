#include "framework/DebugProcess.h"

#include <utility>

namespace gt {

void DebugProcess::connect(PackageSender& fromProcess, PackageLink& toProcess) {
  fromProcess.connect(addReceiver());
  sender_.connect(toProcess);
}

PackageReceiver& DebugProcess::addReceiver() {
  in_.push_back(std::make_unique<In>());
  add(in_.back()->receiver);
  return in_.back()->receiver;
}

Result<void> DebugProcess::request(const QueueFillRequest& request) {
  if (fill_.request(request, now())) return {};
  return Error{.field = "seconds", .what = "collect and save need a time above 0 and up to a day"};
}

void DebugProcess::adopt(DebugProcess& other) {
  fill_ = std::move(other.fill_);
  other.toTools_.moveAllMessages(toTools_);
  other.fromTools_.moveAllMessages(fromTools_);
}

void DebugProcess::handleRequests() {
  Requests::carryOutAll(fromTools_, name(), *this,
                        [this](const RequestAnswer& answer) { toTools_.write(now(), answer); });
}

int DebugProcess::main() {
  handleRequests();
  fill_.update(now());
  toTools_.reportDropped(now());
  for (const auto& in : in_)
    if (in->receiver.receivedNew()) fill_.take(in->queue, toTools_);
  // All processes must have taken the last queue before the next one is sent, or a request would be
  // lost.
  if (!fromTools_.empty() && sender_.ready()) {
    out_.clear();
    fromTools_.moveAllMessages(out_);
    sender_.send();
  }
  return -8;
}

}  // namespace gt
