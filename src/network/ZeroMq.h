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

/// ZeroMQ as one program uses it, and who may connect to it.
class ZeroMq {
 public:
  /// Makes that a listening socket lets in only who holds the client's key.
  void guard(zmq::socket_t& socket, const Keys& keys);
  /// Answers ZeroMQ's questions who may connect (its protocol ZAP).
  void answerKeyQuestions();
  zmq::context_t& context() { return context_; }
  /// Readable when there is a question; null if nobody needs keys.
  void* questions() { return keyKeeper_ ? keyKeeper_->handle() : nullptr; }

 private:
  zmq::context_t context_;
  std::vector<std::string> clients_;  ///< Public keys of those who are let in, as 32 bytes.
  std::optional<zmq::socket_t> keyKeeper_;
};

/// What ZeroMQ reports of a socket's connections.
class SocketEvents {
 public:
  SocketEvents(ZeroMq& zeroMq, zmq::socket_t& watched, int kinds);
  struct Event {
    std::uint16_t kind = 0;
    std::int32_t value = -1;  ///< The connection's file descriptor, or the reason of a failure.
  };
  std::optional<Event> next();

 private:
  zmq::socket_t events_;
};

/// Watches who is connected with a listening socket over tcp. ZeroMQ limits the parts of a message,
/// but not their number, nor that of connections: who sends more bytes without an end of a message
/// than a frame has is cut off, and when all places are taken, who has sent nothing yet, or if all
/// have, who comes. An address has a part of the places only. Where no key is needed, who is not of
/// this user (or the administrator) is cut off, too: as with sockets of the file system.
class ConnectionGuard {
 public:
  ConnectionGuard(ZeroMq& zeroMq, zmq::socket_t& watched, const SocketLimits& limits,
                  bool usersOnly, Refusals& refusals);
  /// A whole message came in by this connection; false if it is to be passed over.
  bool admits(int connection);
  /// To be called often.
  void check();

 private:
  struct Connection {
    int file;
    std::string address;
    std::int64_t bytes = 0;  ///< That had come in when a message was complete.
    bool heard = false;
    bool known = false;  ///< Something was admitted from it.
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
  int failedHandshakes_ = 0;  ///< Of connections that have not ended yet.
  SocketEvents events_;
  std::vector<Connection> connections_;
};

/// A socket of ZeroMQ, for all endpoints that others than this machine can reach.
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
  std::string address_;  ///< Of the last message's sender.
  std::optional<ConnectionGuard> guard_;
  std::optional<SocketEvents> handshakes_;
  std::string trouble_;
  std::int64_t checked_ = 0;
};

}  // namespace gt
