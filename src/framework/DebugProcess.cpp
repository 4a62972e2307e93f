#include "framework/DebugProcess.h"

namespace gt {

void DebugProcess::connect(PackageSender& fromProcess, PackageLink& toProcess) {
  fromProcess.connect(addReceiver());
  sender_.connect(toProcess);
}

PackageReceiver& DebugProcess::addReceiver() {
  in_.push_back(std::make_unique<In>());
  enlist(in_.back()->receiver);
  return in_.back()->receiver;
}

int DebugProcess::main() {
  for (const auto& in : in_)
    if (in->receiver.receivedNew()) in->queue.copyAllMessages(toTools_);
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
