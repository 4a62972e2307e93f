#include "base/EndSignals.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <ctime>
#include <utility>

namespace gt {
namespace {

std::int64_t monotonicMs() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000 + now.tv_nsec / 1'000'000;
}

}  // namespace

EndSignals::EndSignals(std::function<void()> wake, std::int64_t togetherMs)
    : wake_{std::move(wake)},
      togetherMs_{togetherMs},
      event_{eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)} {
  assert(!active_);
  active_ = this;
  for (int file = 0; file < 3; ++file)
    terminal_[static_cast<std::size_t>(file)] = isatty(file) != 0;
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    sigaction(numbers[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(numbers[i], &action, nullptr);
  }
}

EndSignals::~EndSignals() {
  for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before_[i], nullptr);
  active_ = nullptr;
}

void EndSignals::forget() {
  std::uint64_t count = 0;
  static_cast<void>(::read(event_.number(), &count, sizeof count));
  received_ = 0;
}

bool EndSignals::waitFor(int file) const {
  std::array<pollfd, 2> files{pollfd{file, POLLIN, 0}, pollfd{event_.number(), POLLIN, 0}};
  while (!received()) {
    if (poll(files.data(), files.size(), -1) < 0 && errno != EINTR) return false;
    if (files[1].revents == 0 && files[0].revents != 0) return true;
  }
  return false;
}

void EndSignals::handle(int signal) {
  const int before = errno;
  if (EndSignals* active = active_) active->take(signal);
  errno = before;
}

void EndSignals::take(int signal) {
  // SIGPIPE of other pipes is ignored: their writers get an error.
  if ((signal == SIGHUP || signal == SIGPIPE) && !leaveClosed(signal) && signal == SIGPIPE) return;
  int none = 0;
  if (!received_.compare_exchange_strong(none, signal)) {
    if (monotonicMs() - receivedMs_ < togetherMs_) return;
    std::signal(signal, SIG_DFL);
    raise(signal);  // as soon as the handler returns
    return;
  }
  receivedMs_ = monotonicMs();
  const std::uint64_t one = 1;
  static_cast<void>(::write(event_.number(), &one, sizeof one));
  if (wake_) wake_();
}

/// Redirects standard files that are a closed terminal (SIGHUP) or a pipe that nobody reads to
/// /dev/null. Otherwise printing would fail, and the program would end before it has written
/// everything. Returns whether there was such a file.
bool EndSignals::leaveClosed(int signal) const {
  bool left = false;
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int file = 0; file < 3; ++file) {
    pollfd output{file, POLLOUT, 0};
    const bool closed = signal == SIGHUP
                            ? terminal_[static_cast<std::size_t>(file)] && !isatty(file)
                            : poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
    if (closed) left = dup2(nowhere, file) >= 0;
  }
  close(nowhere);
  return left;
}

}  // namespace gt
