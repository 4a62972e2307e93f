#pragma once
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <functional>

#include "base/FileDescriptor.h"

namespace gt {

/// Lets a program end in order after Ctrl-C (SIGINT), SIGTERM, the closing of its terminal
/// (SIGHUP), or the end of the program that reads its output (SIGPIPE). While an object exists, the
/// first of these signals is stored, and the program must end by itself; a second signal ends it at
/// once. A signal that was ignored when the program started (nohup) stays ignored. Only one object
/// may exist at a time.
class EndSignals {
 public:
  /// `wake` is called by the signal handler, so it may only do what is safe there. Signals that
  /// arrive within `togetherMs` (ms) of the first count as one: shells and `timeout` send theirs
  /// twice.
  explicit EndSignals(std::function<void()> wake = {}, std::int64_t togetherMs = 300);
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// The first signal that was received; 0 if none was.
  int received() const { return received_; }
  /// Exit status of the program after a signal: 128 + the signal's number.
  int status() const { return 128 + received_; }
  /// Discards the stored signal because it was not meant for this program. The next signal counts
  /// as the first again.
  void forget();

  /// Blocks until a file or socket can be read; returns false if a signal was received before.
  bool waitFor(int file) const;
  /// A file descriptor that becomes readable once a signal has been received.
  int event() const { return event_.number(); }

 private:
  static constexpr std::array numbers{SIGINT, SIGTERM, SIGHUP, SIGPIPE};

  static void handle(int signal);
  void take(int signal);
  bool leaveClosed(int signal) const;

  static inline std::atomic<EndSignals*> active_ = nullptr;
  std::function<void()> wake_;
  std::int64_t togetherMs_;
  FileDescriptor event_;
  std::atomic<int> received_ = 0;
  std::atomic<std::int64_t> receivedMs_ = 0;
  std::array<struct sigaction, numbers.size()> before_{};
  std::array<bool, 3> terminal_{};  ///< Whether each of the standard files is a terminal.
};

}  // namespace gt
