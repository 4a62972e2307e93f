#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "network/Keys.h"
#include "network/Socket.h"

struct zmq_pollitem_t;

namespace gt {

class ZeroMq;

/// The network connections of one program: its sockets, keys and clock. Endpoints are those of
/// ZeroMQ (tcp://, inproc://), and ipc://PATH on this machine. Not thread-safe.
class Network {
 public:
  Network();
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Listens for several peers. Endpoints that other machines can reach (not ipc:// or the loopback
  /// device) require keys; ipc:// does not use keys.
  Result<Socket*> listen(const std::string& endpoint, const std::optional<Keys>& keys = {},
                         const SocketLimits& limits = {});
  /// Connects to one peer as soon as it is present, and again after each restart. `name` identifies
  /// this program to the peer; without a name the connection is anonymous.
  Result<Socket*> connect(const std::string& endpoint, const std::string& name,
                          const std::optional<Keys>& keys = {}, const SocketLimits& limits = {});
  /// Waits until data arrives or `ms` have passed, but at least until `shortest` ms after the last
  /// wait, so that a flood of messages does not keep the program busy.
  void wait(std::int64_t ms, std::int64_t shortest = 0);

  /// The time that outgoing frames are stamped with.
  Time now;
  /// Number of this session; differs for each start of the program.
  std::uint64_t session() const { return session_; }
  /// Time (ms) since the network was made, independent of the robot's clock.
  std::int64_t elapsed() const;

 private:
  Result<Socket*> add(Result<std::unique_ptr<Socket>> socket);
  ZeroMq& zeroMq();

  std::uint64_t session_;
  std::int64_t begin_;
  std::int64_t woken_ = 0;
  std::unique_ptr<ZeroMq> zeroMq_;  ///< Made when a socket needs it, because it starts threads.
  std::vector<std::unique_ptr<Socket>> sockets_;
  std::vector<zmq_pollitem_t> waitedFor_;
};

/// Whether an endpoint is reachable from this machine only.
bool isLocal(std::string_view endpoint);

}  // namespace gt
