#pragma once
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace gt::testing {

/// Another machine, as far as the network goes: a network namespace, joined to this one by a cable.
/// Where that may not be made (it needs root), the loopback device takes its place.
class OtherMachine {
 public:
  OtherMachine() {
    isolated_ =
        geteuid() == 0 && run("ip netns add " + name_) &&
        run("ip link add " + cable_ + "a type veth peer name " + cable_ + "b netns " + name_) &&
        run("ip addr add " + ends_.here + "/30 dev " + cable_ + "a") &&
        run("ip link set " + cable_ + "a up") && run("ip -n " + name_ + " link set lo up") &&
        run("ip -n " + name_ + " addr add " + ends_.there + "/30 dev " + cable_ + "b") &&
        run("ip -n " + name_ + " link set " + cable_ + "b up");
    if (isolated_) return;
    std::printf("no network namespace can be made here: over the loopback device\n");
    ends_ = {"127.0.0.1", "127.0.0.1"};
  }
  ~OtherMachine() {
    run("ip link del " + cable_ + "a");
    run("ip netns del " + name_);
  }
  OtherMachine(const OtherMachine&) = delete;
  OtherMachine& operator=(const OtherMachine&) = delete;

  /// False if it is this machine.
  bool isolated() const { return isolated_; }
  /// The addresses by which the two know each other.
  const std::string& here() const { return ends_.here; }
  const std::string& there() const { return ends_.there; }
  /// A command that runs there.
  std::vector<std::string> command(std::vector<std::string> words) const {
    if (isolated_) words.insert(words.begin(), {"/sbin/ip", "netns", "exec", name_});
    return words;
  }

 private:
  struct Ends {
    std::string here, there;
  };

  static bool run(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
  }
  /// Each test program has a subnet of its own: they run at the same time.
  static Ends addresses() {
    const int subnet = getpid() % (256 * 64);
    const std::string network = "10.203." + std::to_string(subnet / 64) + ".";
    return {network + std::to_string(subnet % 64 * 4 + 1),
            network + std::to_string(subnet % 64 * 4 + 2)};
  }

  std::string name_ = "gt2003-" + std::to_string(getpid());
  std::string cable_ = "gt" + std::to_string(getpid() % 100'000);
  Ends ends_ = addresses();
  bool isolated_ = false;
};

}  // namespace gt::testing
