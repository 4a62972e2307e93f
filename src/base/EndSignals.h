#pragma once
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <functional>

#include "base/FileDescriptor.h"

namespace gt {

/// Lets a program end in order when it is asked to: by Ctrl-C (SIGINT), by SIGTERM, because its
/// terminal was closed (SIGHUP), or because who reads what it prints has gone (SIGPIPE). While an
/// object exists, the first of these signals is kept, and the program ends by itself; a second one
/// ends it at once. A signal that the program was started to ignore (nohup) is ignored. One object
/// at a time.
class EndSignals {
 public:
  /// `wake` is called by the signal's handler, so it may do only what is safe there. Signals that
  /// come within `togetherMs` are one: shells and `timeout` send theirs twice.
  explicit EndSignals(std::function<void()> wake = {}, std::int64_t togetherMs = 300);
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// The first signal that came; 0 if none has.
  int received() const { return received_; }
  /// What the program ends with after a signal: 128 more than it.
  int status() const { return 128 + received_; }
  /// Forgets the signal, which did not mean the program: the next one is the first again.
  void forget();

  /// Waits until a file or socket can be read; returns false if a signal came before.
  bool waitFor(int file) const;
  /// Can be read once a signal has come.
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
  std::array<bool, 3> terminal_{};  ///< Which of the standard files are one.
};

}  // namespace gt
