#pragma once
#include <array>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/Time.h"

namespace gt {

/// Names what the calling thread does while this object exists, such as a process with the time of
/// its cycle, or the module that runs. A crash report shows the open contexts, the outermost first.
/// A context costs a few instructions. The name must outlive the object.
class CrashContext {
 public:
  explicit CrashContext(const char* name, Time since = never())
      : name_{name}, since_{since}, outer_{innermost_} {
    innermost_ = this;
  }
  ~CrashContext() { innermost_ = outer_; }
  CrashContext(const CrashContext&) = delete;
  CrashContext& operator=(const CrashContext&) = delete;

  /// Calls visit(text) for the parts of a line that lists the calling thread's contexts, such as
  /// "Cognition at 4800 ms, BallLocator". Lists at most the sixteen innermost contexts. Safe in
  /// signal handlers.
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

/// Adds a note to the crash report, for instance what a module is about to do or what it last saw.
/// The report shows the last 32 notes, each after its CrashContext. Can be called from any thread;
/// allocates no memory and takes no locks. Notes are cut after 120 bytes.
void noteForCrashReport(std::string_view line);

/// The crash notes of this program. crash/CrashHandler.h writes them to the report.
class CrashNotes {
 public:
  static CrashNotes& ofProcess();

  void add(std::string_view line);
  /// Calls visit(letter) for each letter of a note. A note that is being written meanwhile may be a
  /// mix of the old and the new text. Safe in signal handlers.
  template <typename Visit>
  void forEachLetter(std::uint64_t note, Visit&& visit) const {
    for (const std::atomic<char>& c : notes_[note % count]) {
      const char letter = c.load(std::memory_order_relaxed);
      if (letter == 0) return;
      visit(letter);
    }
  }
  /// The notes that are kept have the numbers from `begin` up to, but not including, `end`.
  std::uint64_t begin() const { return end() > count ? end() - count : 0; }
  std::uint64_t end() const { return added_.load(); }

 private:
  static constexpr std::size_t count = 32, length = 120;

  std::array<std::array<std::atomic<char>, length>, count> notes_{};
  std::atomic<std::uint64_t> added_{0};
};

}  // namespace gt
