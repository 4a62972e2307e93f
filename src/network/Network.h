#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zmq.hpp>

#include "framework/Representation.h"
#include "network/Frame.h"
#include "network/Keys.h"

namespace gt {

class Network;

/// A message as it came in; views into the socket's memory until the next one.
struct Received {
  std::string_view peer;  ///< Who sent it, where several may; empty otherwise.
  Frame frame;
};

/// How much a socket holds for others.
struct SocketLimits {
  int frames = 64;                      ///< In each direction, for each peer; more are dropped.
  std::int64_t frameSize = 16'000'000;  ///< A larger frame ends the connection.
};

/// One end of connections: listening for many peers, or connected to one. Never waits.
class Socket {
 public:
  /// Sends a package, or without a value a frame without one. False if it was dropped since the
  /// peer is not there or does not keep up.
  bool send(std::string_view peer, FrameKind kind, const RepresentationType& type,
            const void* value);
  /// The next frame that came in; messages that are none are counted and passed over.
  bool receive(Received& received);
  /// How many messages were no frames.
  std::uint64_t rejected() const { return rejected_; }
  /// Where it listens; for tcp with the port that was chosen if it was asked for port 0.
  std::string endpoint() const { return socket_.get(zmq::sockopt::last_endpoint); }

 private:
  friend class Network;
  Socket(Network& network, zmq::socket_type type);
  bool receivePart(zmq::message_t& part);

  Network& network_;
  bool listens_;
  zmq::socket_t socket_;
  zmq::message_t peer_, message_;
  std::uint64_t rejected_ = 0;
};

/// The network as one program sees it, over ZeroMQ: its sockets, its keys, its clock. One thread.
class Network {
 public:
  Network();
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Listens for many peers. Beyond this machine (not ipc:// or the loopback device) only with
  /// keys. `name` is what it is called in errors.
  Result<Socket*> listen(const std::string& endpoint, const std::optional<Keys>& keys = {},
                         const SocketLimits& limits = {});
  /// Connects to one peer, as soon as it is there and again whenever it is; `name` is who one is
  /// there, no name an anonymous one.
  Result<Socket*> connect(const std::string& endpoint, const std::string& name,
                          const std::optional<Keys>& keys = {}, const SocketLimits& limits = {});
  /// Waits until something comes in or the time in ms is over.
  void wait(std::int64_t ms);

  /// The clock that frames are stamped with.
  Time now;
  /// A number that another start of the program does not have.
  std::uint64_t session() const { return session_; }
  /// Milliseconds since the network was made, whatever the robot's clock says.
  std::int64_t elapsed() const;

 private:
  friend class Socket;
  void answerKeyQuestions();
  void makeKeyKeeper();
  Result<Socket*> add(std::unique_ptr<Socket> socket, const std::string& endpoint,
                      const SocketLimits& limits);

  zmq::context_t context_;
  std::uint64_t session_;
  std::int64_t begin_;
  std::vector<std::string> clients_;  ///< Public keys of those who are let in, as 32 bytes.
  std::optional<zmq::socket_t> keyKeeper_;
  std::vector<std::unique_ptr<Socket>> sockets_;
  std::vector<zmq::pollitem_t> items_;
};

/// Whether an endpoint can be reached from this machine only.
bool isLocal(std::string_view endpoint);

}  // namespace gt
