#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "framework/Process.h"
#include "framework/RepresentationDefinition.h"
#include "network/Wire.h"
#include "streams/TemporaryFolder.h"

namespace gt::testing {

/// A folder for sockets and files of one test.
class TestFolder {
 public:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string endpoint(const std::string& name) const { return "ipc://" + file(name); }

 private:
  TemporaryFolder folder_;
};

/// A port of the loopback device on which nobody listens.
inline int freePort() {
  Network network;
  const std::string endpoint = (*network.listen("tcp://127.0.0.1:*"))->endpoint();
  return std::stoi(endpoint.substr(endpoint.rfind(':') + 1));
}
inline std::string freeTcpEndpoint() {
  return "tcp://127.0.0.1:" + std::to_string(freePort());
}

struct NumberPackage {
  int number = 0;

  static constexpr auto fields() { return Fields{field("number", &NumberPackage::number)}; }
};

namespace newer {

/// The package as another version of the program has it.
struct NumberPackage {
  double more = 0.5;
  double number = 0;

  static constexpr auto fields() {
    return Fields{field("more", &NumberPackage::more), field("number", &NumberPackage::number)};
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
