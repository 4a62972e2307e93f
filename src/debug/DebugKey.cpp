#include "debug/DebugKey.h"

#include <algorithm>
#include <string>

#include "base/Contract.h"

namespace gt {
namespace {

struct Registry {
  std::vector<DebugKey> keys;
  bool closed = false;  ///< Set once a table exists, because it has an entry for each key.
};

Registry& registry() {
  static Registry registry;
  return registry;
}

}  // namespace

DebugKey::DebugKey(std::string_view name) : name_{name} {
  if constexpr (debugging) {
    if (const DebugKey* same = find(name)) {
      index_ = same->index_;
      return;
    }
    if (registry().closed)
      violate("The debug key '" + std::string{name} +
              "' is made while the program runs. A key is a constant at namespace scope.");
    index_ = registry().keys.size();
    registry().keys.push_back(*this);
  }
}

const std::vector<DebugKey>& DebugKey::all() {
  return registry().keys;
}

const DebugKey* DebugKey::find(std::string_view name) {
  const auto found = std::ranges::find(all(), name, &DebugKey::name);
  return found == all().end() ? nullptr : &*found;
}

DebugKeyTable::DebugKeyTable() : asked_(DebugKey::all().size()), entries_(DebugKey::all().size()) {
  registry().closed = true;
}

bool DebugKeyState::isDue(Time now) {
  switch (request_.mode) {
    case DebugKeyMode::disabled:
      return false;
    case DebugKeyMode::always:
      return true;
    case DebugKeyMode::times:
      if (++count_ >= request_.n) request_.mode = DebugKeyMode::disabled;
      return count_ <= request_.n;
    case DebugKeyMode::everyTimes:
      return ++count_ % std::max<std::int64_t>(request_.n, 1) == 0;
    case DebugKeyMode::everyMs:
      // Time may jump back if a log is played from another position or a simulation is restarted.
      if (now >= last_ && now - last_ < request_.n) return false;
      last_ = now;
      return true;
  }
  return false;
}

}  // namespace gt
