#pragma once
#include <array>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/Time.h"

namespace gt {

/// Names what the calling thread does for as long as this object exists: a crash report shows those
/// that are open, the outermost first, such as a process with the time of its cycle, and the module
/// that runs. Costs a few instructions. The name must outlive it.
class CrashContext {
 public:
  explicit CrashContext(const char* name, Time since = never())
      : name_{name}, since_{since}, outer_{innermost_} {
    innermost_ = this;
  }
  ~CrashContext() { innermost_ = outer_; }
  CrashContext(const CrashContext&) = delete;
  CrashContext& operator=(const CrashContext&) = delete;

  /// Calls visit(text) for the parts of the calling thread's contexts as one line, as "Cognition at
  /// 4800 ms, BallLocator"; of more than sixteen for the innermost ones. Safe in signal handlers.
  template <typename Visit>
  static void forEachPart(Visit&& visit) {
    std::array<const CrashContext*, 16> open;
    std::size_t n = 0;
    for (const CrashContext* at = innermost_; at && n < open.size(); at = at->outer_)
      open[n++] = at;
    for (bool first = true; n > 0; first = false) {
      const CrashContext& context = *open[--n];
      if (!first) visit(std::string_view{", "});
      visit(std::string_view{context.name_});
      if (context.since_ == never()) continue;
      std::array<char, 24> digits;
      const auto end = std::to_chars(digits.begin(), digits.end(), context.since_.ms).ptr;
      visit(std::string_view{" at "});
      visit(std::string_view{digits.begin(), end});
      visit(std::string_view{" ms"});
    }
  }

 private:
  static thread_local constinit inline const CrashContext* innermost_ = nullptr;

  const char* name_;
  Time since_;
  const CrashContext* outer_;
};

/// Notes a line for a crash report, which shows the last 32 of them, each behind its CrashContext:
/// what a module was about to do, or what it last saw. From any thread, without
/// memory or locks; what is longer than 120 bytes is cut.
void noteForCrashReport(std::string_view line);

/// The notes of a process, which crash/CrashHandler.h writes.
class CrashNotes {
 public:
  static CrashNotes& ofProcess();

  void add(std::string_view line);
  /// Calls visit(letter) for each letter of a note. A note that is written meanwhile is torn at
  /// worst. Safe in signal handlers.
  template <typename Visit>
  void forEachLetter(std::uint64_t note, Visit&& visit) const {
    for (const std::atomic<char>& c : notes_[note % count]) {
      const char letter = c.load(std::memory_order_relaxed);
      if (letter == 0) return;
      visit(letter);
    }
  }
  /// The notes that are kept are those from `begin` to before `end`.
  std::uint64_t begin() const { return end() > count ? end() - count : 0; }
  std::uint64_t end() const { return added_.load(); }

 private:
  static constexpr std::size_t count = 32, length = 120;

  std::array<std::array<std::atomic<char>, length>, count> notes_{};
  std::atomic<std::uint64_t> added_{0};
};

}  // namespace gt
