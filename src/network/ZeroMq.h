#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "base/Result.h"
#include "network/Keys.h"
#include "network/Socket.h"

namespace gt {

/// The ZeroMQ context of a program, with the access control for its sockets.
class ZeroMq {
 public:
  /// Restricts a listening socket to clients that own the client's secret key.
  void guard(zmq::socket_t& socket, const Keys& keys);
  /// Answers ZeroMQ's access requests (its protocol ZAP).
  void answerKeyQuestions();
  zmq::context_t& context() { return context_; }
  /// Readable when there is an access request; null if no socket uses keys.
  void* questions() { return keyKeeper_ ? keyKeeper_->handle() : nullptr; }

 private:
  zmq::context_t context_;
  std::vector<std::string> clients_;  ///< Public keys of accepted clients, 32 bytes each.
  std::optional<zmq::socket_t> keyKeeper_;
};

/// The connection events that ZeroMQ reports for a socket.
class SocketEvents {
 public:
  SocketEvents(ZeroMq& zeroMq, zmq::socket_t& watched, int kinds);
  struct Event {
    std::uint16_t kind = 0;
    std::int32_t value = -1;  ///< File descriptor of the connection, or reason of a failure.
  };
  std::optional<Event> next();

 private:
  zmq::socket_t events_;
};

/// Watches the connections of a listening tcp socket. ZeroMQ limits the size of a message's parts,
/// but neither their number nor that of connections. Therefore a connection is closed if it sends
/// more bytes than a frame has without completing a message. If all places are occupied, a
/// connection that has not sent anything is closed, or, if there is none, the new one. Each IP
/// address may only occupy a part of the places. If no key is required, connections of other users
/// (except the administrator) are closed, too, as for sockets in the file system.
class ConnectionGuard {
 public:
  ConnectionGuard(ZeroMq& zeroMq, zmq::socket_t& watched, const SocketLimits& limits,
                  bool usersOnly, Refusals& refusals);
  /// Processes a complete message of a connection. Returns false if it must be ignored.
  bool admits(int connection);
  /// Must be called often.
  void check();

 private:
  struct Connection {
    int file;
    std::string address;
    std::int64_t bytes = 0;  ///< Bytes received up to the last complete message.
    bool heard = false;
    bool known = false;  ///< Whether a message of this connection was admitted.
  };

  void takeEvents();
  void forget(int file);
  bool hasRoom();
  void drop(std::vector<Connection>::iterator connection, Refusal reason);
  bool hasShare(const Connection& connection) const;
  bool isTolerable(Connection& connection) const;

  SocketLimits limits_;
  bool usersOnly_;
  Refusals& refusals_;
  int failedHandshakes_ = 0;  ///< Failed handshakes of connections that have not ended yet.
  SocketEvents events_;
  std::vector<Connection> connections_;
};

/// A ZeroMQ socket, for all endpoints that are reachable from other machines.
class ZeroMqSocket : public Socket {
 public:
  static Result<std::unique_ptr<Socket>> listen(const Network& network, ZeroMq& zeroMq,
                                                const std::string& endpoint,
                                                const std::optional<Keys>& keys,
                                                const SocketLimits& limits);
  static Result<std::unique_ptr<Socket>> connect(const Network& network, ZeroMq& zeroMq,
                                                 const std::string& endpoint,
                                                 const std::string& name,
                                                 const std::optional<Keys>& keys,
                                                 const SocketLimits& limits);

  bool send(std::string_view peer, FrameKind kind, const Topic& topic, const void* value) override;
  bool receive(Received& received) override;
  std::string trouble() override;
  std::string endpoint() const override { return socket_.get(zmq::sockopt::last_endpoint); }
  void* zeroMq() const override { return const_cast<zmq::socket_t&>(socket_).handle(); }

 private:
  ZeroMqSocket(const Network& network, ZeroMq& zeroMq, zmq::socket_type type,
               const SocketLimits& limits);
  bool receivePart(zmq::message_t& part);
  bool receiveFrame(Received& received);

  bool listens_;
  bool hasKey_ = false;
  zmq::socket_t socket_;
  zmq::message_t peer_, message_;
  std::string address_;  ///< Address of the last message's sender.
  std::optional<ConnectionGuard> guard_;
  std::optional<SocketEvents> handshakes_;
  std::string trouble_;
  std::int64_t checked_ = 0;
};

}  // namespace gt
