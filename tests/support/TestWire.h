#pragma once
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "base/TemporaryFolder.h"
#include "framework/Process.h"
#include "framework/RepresentationDefinition.h"
#include "network/Wire.h"

namespace gt::testing {

/// A folder for sockets and files of one test.
class TestFolder {
 public:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string endpoint(const std::string& name) const { return "ipc://" + file(name); }

 private:
  TemporaryFolder folder_;
};

/// Whether a port of the loopback device was nobody's; it is this program's then, until it ends.
inline bool takePort(int port, bool keep) {
  const int holder = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool taken = ::bind(holder, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
  if (!taken || !keep) ::close(holder);
  return taken;
}
/// A port of the loopback device on which nobody listens, nor on the 299 behind it, which a router
/// needs. Tests that run beside this one get others, as the last but one of these is kept; and
/// they are below those that the system gives whoever asks for any.
inline int freePort() {
  constexpr int first = 10'000, block = 300, blocks = 75;
  static int next = static_cast<int>(::getpid()) % blocks;
  for (;;) {
    const int port = first + block * (next++ % blocks);
    if (takePort(port, false) && takePort(port + block - 2, true)) return port;
  }
}
inline std::string freeTcpEndpoint() {
  return "tcp://127.0.0.1:" + std::to_string(freePort());
}

struct NumberPackage {
  int number = 0;

  static constexpr auto fields() { return Fields{field<&NumberPackage::number>()}; }
};

namespace newer {

/// The package as another version of the program has it.
struct NumberPackage {
  double more = 0.5;
  double number = 0;

  static constexpr auto fields() {
    return Fields{field<&NumberPackage::more>(), field<&NumberPackage::number>()};
  }
};
static_assert(complete<NumberPackage>);

}  // namespace newer

/// A process whose main() is given by the test.
struct Custom : Process {
  explicit Custom(const std::string& name) : Process{name} {}
  int main() override {
    if (work) work();
    return pause;
  }
  std::function<void()> work;
  int pause = -1;
};

/// For what is meant to succeed, on whatever a machine has to do besides.
constexpr std::chrono::seconds patience{60};

/// Lets something happen again and again until a condition holds; false if it does not in time.
template <typename Condition, typename Action>
bool eventually(Condition condition, Action action, std::chrono::milliseconds time = patience) {
  for (const auto end = std::chrono::steady_clock::now() + time;
       std::chrono::steady_clock::now() < end;) {
    if (condition()) return true;
    action();
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return condition();
}

}  // namespace gt::testing
