// Dies on purpose: crash_child FOLDER segv|abort|overflow|thread|divide
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "base/CrashNotes.h"
#include "crash/CrashHandler.h"

namespace crashes {

volatile int sink = 0;

[[gnu::noinline]] void writeNowhere(volatile int* where) {
  *where = 42;  // segv
}

[[gnu::noinline]] void giveUp() {
  std::abort();  // abort
}

[[gnu::noinline]] int divideBy(int n) {
  return 7 / n;  // divide
}

[[gnu::noinline]] int recurse(int depth) {
  if (depth == sink - 1) return 0;  // never, but who knows
  volatile char room[4096] = {};
  room[depth % 4096] = 1;
  return recurse(depth + 1) + room[17];  // overflow
}

[[gnu::noinline]] void die(std::string_view how) {
  volatile int* nowhere = nullptr;
  if (how == "segv" || how == "thread") writeNowhere(nowhere);
  if (how == "abort") giveUp();
  if (how == "divide") sink = divideBy(sink);
  if (how == "killed") kill(getpid(), SIGSEGV);
  if (how == "overflow") sink = recurse(0);
  sink = 1;
}

}  // namespace crashes

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  gt::installCrashHandler({"crash_child", argv[1]});
  const gt::CrashContext robot{"red1"}, module{"Doubler"};
  for (int i = 0; i < 40; ++i) gt::noteForCrashReport("step " + std::to_string(i));
  const std::string_view how = argv[2];
  if (how.starts_with("thread")) {
    std::thread thread{[how] {
      const gt::CrashStack stack;
      crashes::die(how == "thread-overflow" ? "overflow" : how);
      crashes::sink = 1;
    }};
    thread.join();
  } else {
    crashes::die(how);
  }
  return crashes::sink;
}
