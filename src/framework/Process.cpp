#include "framework/Process.h"

#include <algorithm>

namespace gt {

void PackageSender::send() {
  for (Link& link : links_) {
    link.toBeSent = !link.receiver->requested();
    if (!link.toBeSent) link.receiver->deliver(package_);
  }
}

void PackageSender::sendLater() {
  for (Link& link : links_)
    if (link.toBeSent && link.receiver->accepts()) {
      link.receiver->deliver(package_);
      link.toBeSent = false;
    }
}

bool PackageSender::requestedNew() const {
  return std::any_of(links_.begin(), links_.end(),
                     [](const Link& link) { return link.receiver->requested(); });
}

bool PackageSender::ready() const {
  return !blocking_ || std::all_of(links_.begin(), links_.end(), [](const Link& link) {
    return link.receiver->requested() || !link.receiver->active();
  });
}

bool PackageSender::triggers() const {
  return blocking_ && std::any_of(links_.begin(), links_.end(),
                                  [](const Link& link) { return link.receiver->active(); });
}

namespace detail {
void registerIn(Process& process, PackageSender& sender) {
  process.add(sender);
}
void registerIn(Process& process, PackageReceiver& receiver) {
  process.add(receiver);
}
}  // namespace detail

bool Process::ready() const {
  const bool triggered = std::any_of(receivers_.begin(), receivers_.end(),
                                     [](auto* receiver) { return receiver->blocking(); }) ||
                         std::any_of(senders_.begin(), senders_.end(),
                                     [](auto* sender) { return sender->triggers(); });
  return (triggered || !waitsForPackage_) &&
         std::all_of(receivers_.begin(), receivers_.end(),
                     [](auto* receiver) { return receiver->ready(); }) &&
         std::all_of(senders_.begin(), senders_.end(),
                     [](auto* sender) { return sender->ready(); });
}

bool Process::step(Time now) {
  return stepBy([now] { return now; });
}

bool Process::stepBy(const Clock& clock) {
  const Time begin = clock();
  if (begin < next_ || !ready()) return false;
  now_ = begin;
  for (PackageReceiver* receiver : receivers_) receiver->receive();
  const int wait = main();
  for (PackageSender* sender : senders_) sender->sendLater();
  for (PackageReceiver* receiver : receivers_) receiver->request();
  schedule(wait, clock());
  return true;
}

void Process::schedule(int wait, Time end) {
  waitsForPackage_ = wait == 0;
  if (wait >= 0) {
    next_ = end + wait;
  } else {
    // A delayed begin of a cycle does not delay the following ones.
    const bool onTime = now_ - next_ < -wait;
    next_ = (onTime ? next_ : now_) + -wait;
  }
}

}  // namespace gt
