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

/// The network as one program sees it: its sockets, its keys, its clock. Endpoints are those of
/// ZeroMQ (tcp://, inproc://), and ipc://PATH within this machine. One thread.
class Network {
 public:
  Network();
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Listens for many peers. Beyond this machine (not ipc:// or the loopback device) only with
  /// keys; ipc:// needs none and takes none.
  Result<Socket*> listen(const std::string& endpoint, const std::optional<Keys>& keys = {},
                         const SocketLimits& limits = {});
  /// Connects to one peer, as soon as it is there and again whenever it is; `name` is who one is
  /// there, no name an anonymous one.
  Result<Socket*> connect(const std::string& endpoint, const std::string& name,
                          const std::optional<Keys>& keys = {}, const SocketLimits& limits = {});
  /// Waits until something comes in or the time in ms is over, but until `shortest` ms after the
  /// last wait: a flood does not keep the program awake.
  void wait(std::int64_t ms, std::int64_t shortest = 0);

  /// The clock that frames are stamped with.
  Time now;
  /// A number that another start of the program does not have.
  std::uint64_t session() const { return session_; }
  /// Milliseconds since the network was made, independent of the robot's clock.
  std::int64_t elapsed() const;

 private:
  Result<Socket*> add(Result<std::unique_ptr<Socket>> socket);
  ZeroMq& zeroMq();

  std::uint64_t session_;
  std::int64_t begin_;
  std::int64_t woken_ = 0;
  std::unique_ptr<ZeroMq> zeroMq_;  ///< Made when a socket needs it, as it has threads.
  std::vector<std::unique_ptr<Socket>> sockets_;
  std::vector<zmq_pollitem_t> waitedFor_;
};

/// Whether an endpoint can be reached from this machine only.
bool isLocal(std::string_view endpoint);

}  // namespace gt
