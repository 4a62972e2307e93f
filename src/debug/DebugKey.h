#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/Enum.h"
#include "base/Time.h"

namespace gt {

/// Whether debugging is part of the program. The build switch GT_DEBUGGING=OFF removes it
/// completely.
#ifdef GT_NO_DEBUGGING
constexpr bool debugging = false;
#else
constexpr bool debugging = true;
#endif

/// The name of debug output that can be requested at run time, such as "SelfLocator/samples"
/// (report E.3). A key is a constant at namespace scope in the file that uses it; no other place
/// must be changed to add one. Constants of the same name are the same key: several modules may
/// draw under it.
class DebugKey {
 public:
  /// Registers the key. All keys of a program must be registered before its first robot exists.
  /// Therefore a key that is a member or a local variable ends the program with a message.
  explicit DebugKey(std::string_view name);

  std::string_view name() const { return name_; }
  std::size_t index() const { return index_; }

  /// All keys of the program, each name once, in the order of their indices.
  static const std::vector<DebugKey>& all();
  /// Returns the key with a name; null if there is none.
  static const DebugKey* find(std::string_view name);

 private:
  std::string_view name_;
  std::size_t index_ = 0;
};

/// When a key's output is sent (report E.3).
enum class DebugKeyMode { disabled, always, times, everyTimes, everyMs };

/// The request for one key: its mode and the number that belongs to the mode.
struct DebugKeyRequest {
  DebugKeyMode mode = DebugKeyMode::disabled;
  std::int64_t n = 0;
};

/// Decides whether requested output is sent this time (report E.3).
class DebugKeyState {
 public:
  DebugKeyState() = default;
  explicit DebugKeyState(DebugKeyRequest request) : request_{request} {}

  const DebugKeyRequest& request() const { return request_; }
  /// Has a side effect: call once per output.
  bool isDue(Time now);

 private:
  DebugKeyRequest request_;
  std::int64_t count_ = 0;
  Time last_ = never();
};

/// The states of all keys in one process (report E.3). If a key is due in a frame, it is due for
/// all its users in that frame.
class DebugKeyTable {
 public:
  DebugKeyTable();

  void set(const DebugKey& key, DebugKeyRequest request) {
    entries_[key.index()] = Entry{DebugKeyState{request}};
    asked_[key.index()] = request.mode != DebugKeyMode::disabled;
  }
  DebugKeyRequest get(const DebugKey& key) const { return entries_[key.index()].state.request(); }

  /// Begins the next frame.
  void begin(Time now) {
    now_ = now;
    ++frame_;
  }
  /// Whether the key's output is to be sent in this frame.
  bool isActive(const DebugKey& key) {
    return debugging && asked_[key.index()] && isDue(entries_[key.index()]);
  }

 private:
  struct Entry {
    DebugKeyState state;
    std::uint64_t frame = 0;  ///< Frame of the last check whether the key is due.
    bool due = false;         ///< Result of that check.
  };
  bool isDue(Entry& entry) {
    if (entry.frame != frame_) {
      entry.frame = frame_;
      entry.due = entry.state.isDue(now_);
    }
    return entry.due;
  }

  Time now_;
  std::uint64_t frame_ = 1;
  std::vector<char> asked_;  ///< Whether each key is switched on; stored separately for speed.
  std::vector<Entry> entries_;
};

}  // namespace gt
