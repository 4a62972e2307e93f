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
  /// Registers the key. Keys of a program are known before its first robot exists, so a key that is
  /// a member or a local variable ends the program with a sentence.
  explicit DebugKey(std::string_view name);

  std::string_view name() const { return name_; }
  std::size_t index() const { return index_; }

  /// All keys of the program, each name once, in the order of their indices.
  static const std::vector<DebugKey>& all();
  /// The key with a name; null if there is none.
  static const DebugKey* find(std::string_view name);

 private:
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
  /// Has a side effect: call once per output.
  bool isDue(Time now);

 private:
  DebugKeyRequest request_;
  std::int64_t count_ = 0;
  Time last_ = never();
};

/// The states of all keys in one process (report E.3). A key that is due in a frame is due for all
/// who use it in that frame.
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
  /// True if the key's output is to be sent in this frame.
  bool isActive(const DebugKey& key) {
    return debugging && asked_[key.index()] && isDue(entries_[key.index()]);
  }

 private:
  struct Entry {
    DebugKeyState state;
    std::uint64_t frame = 0;  ///< In which it was asked last whether the key is due.
    bool due = false;         ///< In that frame.
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
  std::vector<char> asked_;  ///< Whether a key is on; next to each other, for speed.
  std::vector<Entry> entries_;
};

}  // namespace gt
