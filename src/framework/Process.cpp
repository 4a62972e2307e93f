#include "framework/Process.h"

#include <algorithm>

namespace gt {

bool PackageSender::requestedNew() const {
  return std::any_of(links_.begin(), links_.end(), [](auto* link) { return link->requested(); });
}

bool PackageSender::ready() const {
  return !blocking_ ||
         std::all_of(links_.begin(), links_.end(), [](auto* link) { return link->requested(); });
}

namespace detail {
void enlist(Process& process, PackageSender& sender) {
  process.enlist(sender);
}
void enlist(Process& process, PackageReceiver& receiver) {
  process.enlist(receiver);
}
}  // namespace detail

bool Process::ready() const {
  const bool hasBlocking = std::any_of(receivers_.begin(), receivers_.end(),
                                       [](auto* receiver) { return receiver->blocking(); });
  return (hasBlocking || !waitsForPackage_) &&
         std::all_of(receivers_.begin(), receivers_.end(),
                     [](auto* receiver) { return receiver->ready(); }) &&
         std::all_of(senders_.begin(), senders_.end(),
                     [](auto* sender) { return sender->ready(); });
}

bool Process::step(Time now) {
  if (now < next_ || !ready()) return false;
  now_ = now;
  for (PackageReceiver* receiver : receivers_) receiver->receive();
  const int wait = main();
  waitsForPackage_ = wait == 0;
  next_ = now + (wait < 0 ? -wait : wait);
  return true;
}

}  // namespace gt
