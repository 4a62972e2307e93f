#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/Enum.h"
#include "base/Time.h"

namespace gt {

/// Whether debugging is part of the program. The build switch GT_DEBUGGING=OFF takes all of it out.
#ifdef GT_NO_DEBUGGING
constexpr bool debugging = false;
#else
constexpr bool debugging = true;
#endif

/// The name of something that can be asked for at run time, like "SelfLocator/samples" (report
/// E.3). A constant at namespace scope in the file that uses it; that is the one place one writes
/// to add a key. Constants of one name are one key: several modules may draw under it.
class DebugKey {
 public:
  explicit DebugKey(std::string_view name) : name_{name} {
    if constexpr (debugging) enlist();
  }
  DebugKey(const DebugKey&) = delete;
  DebugKey& operator=(const DebugKey&) = delete;

  std::string_view name() const { return name_; }
  std::size_t index() const { return index_; }

  /// All keys of the program, each name once, in the order of their indices.
  static const std::vector<const DebugKey*>& all();
  /// The key with a name; null if there is none.
  static const DebugKey* find(std::string_view name);

 private:
  void enlist();

  std::string_view name_;
  std::size_t index_ = 0;
};

/// When a key's output is sent (report E.3).
enum class DebugKeyMode { disabled, always, times, everyTimes, everyMs };

/// The request for one key: its mode and the mode's number.
struct DebugKeyRequest {
  DebugKeyMode mode = DebugKeyMode::disabled;
  std::int64_t n = 0;
};

/// Whether something that was asked for is to be sent this time (report E.3).
class DebugKeyState {
 public:
  DebugKeyState() = default;
  explicit DebugKeyState(DebugKeyRequest request) : request_{request} {}

  const DebugKeyRequest& request() const { return request_; }
  /// Counts, so to be called once for each output.
  bool isDue(Time now);

 private:
  DebugKeyRequest request_;
  std::int64_t count_ = 0;
  Time last_ = never();
};

/// The states of all keys in one process (report E.3).
class DebugKeyTable {
 public:
  DebugKeyTable() : asked_(DebugKey::all().size(), false), states_(DebugKey::all().size()) {}

  void set(const DebugKey& key, DebugKeyRequest request) {
    states_[key.index()] = DebugKeyState{request};
    asked_[key.index()] = request.mode != DebugKeyMode::disabled;
  }
  DebugKeyRequest get(const DebugKey& key) const { return states_[key.index()].request(); }

  /// True if the key's output is to be sent this time. Counts, so to be called once for each
  /// output.
  bool isActive(const DebugKey& key, Time now) {
    return debugging && asked_[key.index()] && states_[key.index()].isDue(now);
  }

 private:
  std::vector<char> asked_;  ///< Whether a key is on; next to each other, for speed.
  std::vector<DebugKeyState> states_;
};

}  // namespace gt
