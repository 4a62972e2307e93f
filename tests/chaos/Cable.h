#pragma once
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/FileDescriptor.h"
#include "base/Random.h"

namespace gt::testing {

/// A cable to another machine, which is a network namespace. Its packets pass through this program,
/// which can lose, delay and duplicate them. Needs root.
class Cable {
 public:
  /// What happens to packets; the shares are between 0 and 1.
  struct Fault {
    double lost = 0;
    std::chrono::milliseconds delay{0}, jitter{0};
    double duplicated = 0;
  };

  Cable() {
    works_ = geteuid() == 0 && plug(ends_[0], name_ + "a") && plug(ends_[1], name_ + "b") &&
             run("ip netns add " + name_) && run("ip link set " + name_ + "b netns " + name_) &&
             run("ip addr add " + address(1) + "/30 dev " + name_ + "a") &&
             run("ip link set " + name_ + "a up") && run("ip -n " + name_ + " link set lo up") &&
             run("ip -n " + name_ + " addr add " + address(2) + "/30 dev " + name_ + "b") &&
             run("ip -n " + name_ + " link set " + name_ + "b up");
    if (works_) carrying_ = std::thread{[this] { carry(); }};
  }
  ~Cable() {
    ended_ = true;
    if (carrying_.joinable()) carrying_.join();
    run("ip netns del " + name_);
  }
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;

  /// False if no namespace and no network device can be made here.
  bool works() const { return works_; }
  std::string here() const { return address(1); }
  std::string there() const { return address(2); }
  /// A command that runs there.
  std::vector<std::string> command(std::vector<std::string> words) const {
    words.insert(words.begin(), {"/sbin/ip", "netns", "exec", name_});
    return words;
  }
  void set(const Fault& fault) {
    const std::lock_guard lock{mutex_};
    fault_ = fault;
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Packet = std::vector<std::byte>;

  static bool run(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
  }
  /// Each test program has a subnet of its own: they run at the same time.
  static std::string address(int end) {
    const int subnet = getpid() % (256 * 64);
    return "10.204." + std::to_string(subnet / 64) + "." + std::to_string(subnet % 64 * 4 + end);
  }
  static bool plug(FileDescriptor& end, const std::string& device) {
    end = FileDescriptor{open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC)};
    ifreq request{};
    request.ifr_flags = IFF_TUN | IFF_NO_PI;
    device.copy(request.ifr_name, IFNAMSIZ - 1);
    return end && ioctl(end.number(), TUNSETIFF, &request) == 0;
  }

  void carry() {
    std::array<pollfd, 2> files{{{ends_[0].number(), POLLIN, 0}, {ends_[1].number(), POLLIN, 0}}};
    while (!ended_) {
      poll(files.data(), files.size(), 1);
      for (std::size_t from = 0; from < ends_.size(); ++from) take(from);
      for (; !waiting_.empty() && waiting_.begin()->first <= Clock::now();
           waiting_.erase(waiting_.begin())) {
        const auto& [to, packet] = waiting_.begin()->second;
        // A packet for which there is no room is lost, as on any cable.
        if (write(ends_[to].number(), packet.data(), packet.size()) < 0) continue;
      }
    }
  }
  void take(std::size_t from) {
    const std::lock_guard lock{mutex_};
    Packet packet(65536);
    for (ssize_t n = 0; (n = read(ends_[from].number(), packet.data(), packet.size())) > 0;) {
      const Packet taken{packet.begin(), packet.begin() + n};
      const int copies = random_.chance(fault_.lost)         ? 0
                         : random_.chance(fault_.duplicated) ? 2
                                                             : 1;
      for (int i = 0; i < copies; ++i) {
        const std::chrono::duration<double, std::milli> jitter = fault_.jitter * random_.uniform();
        const auto due =
            Clock::now() + fault_.delay + std::chrono::duration_cast<Clock::duration>(jitter);
        waiting_.emplace(due, std::pair{1 - from, taken});
      }
    }
  }

  std::string name_ = "gt" + std::to_string(getpid());
  std::array<FileDescriptor, 2> ends_;
  bool works_ = false;
  std::mutex mutex_;  ///< Of the fault.
  Fault fault_;
  Random random_{1};
  std::multimap<Clock::time_point, std::pair<std::size_t, Packet>>
      waiting_;  ///< By when they go on.
  std::atomic<bool> ended_ = false;
  std::thread carrying_;
};

}  // namespace gt::testing
