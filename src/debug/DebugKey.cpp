#include "debug/DebugKey.h"

#include <algorithm>

namespace gt {
namespace {

std::vector<const DebugKey*>& registry() {
  static std::vector<const DebugKey*> keys;
  return keys;
}

}  // namespace

void DebugKey::enlist() {
  if (const DebugKey* same = find(name_)) {
    index_ = same->index_;
    return;
  }
  index_ = registry().size();
  registry().push_back(this);
}

const std::vector<const DebugKey*>& DebugKey::all() {
  return registry();
}

const DebugKey* DebugKey::find(std::string_view name) {
  const auto found =
      std::find_if(all().begin(), all().end(), [&](auto* key) { return key->name() == name; });
  return found == all().end() ? nullptr : *found;
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
      // Time may go back: a log is played from elsewhere, a simulation is started anew.
      if (now >= last_ && now - last_ < request_.n) return false;
      last_ = now;
      return true;
  }
  return false;
}

}  // namespace gt
