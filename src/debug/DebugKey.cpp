#include "debug/DebugKey.h"

#include <algorithm>

namespace gt {
namespace {

std::vector<const DebugKey*>& registry() {
  static std::vector<const DebugKey*> keys;
  return keys;
}

}  // namespace

DebugKey::DebugKey(std::string_view name) : name_{name} {
  if constexpr (debugging) {
    index_ = registry().size();
    registry().push_back(this);
  }
}

const std::vector<const DebugKey*>& DebugKey::all() {
  return registry();
}

const DebugKey* DebugKey::find(std::string_view name) {
  const auto found =
      std::find_if(all().begin(), all().end(), [&](auto* key) { return key->name() == name; });
  return found == all().end() ? nullptr : *found;
}

bool DebugKeyTable::isDue(State& state, Time now) {
  switch (state.request.mode) {
    case DebugKeyMode::disabled:
      return false;
    case DebugKeyMode::always:
      return true;
    case DebugKeyMode::times:
      if (++state.count >= state.request.n) state.request.mode = DebugKeyMode::disabled;
      return state.count <= state.request.n;
    case DebugKeyMode::everyTimes:
      return ++state.count % std::max<std::int64_t>(state.request.n, 1) == 0;
    case DebugKeyMode::everyMs:
      if (now - state.last < state.request.n) return false;
      state.last = now;
      return true;
  }
  return false;
}

}  // namespace gt
