#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/Result.h"
#include "foxglove/WebSocketOutbox.h"

namespace gt {

/// A server of the WebSocket protocol (RFC 6455) on a thread of its own. Its functions are called
/// by one thread and never wait for the network. Memory is bounded for each client, in both
/// directions: what one does not take in time is dropped for that one, and one that sends more than
/// is taken is not read. On the loopback device programs of other users are turned away, and
/// everywhere pages that a browser has loaded from elsewhere.
class WebSocketServer {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;  ///< 0: any that is free.
    /// The first of these that a client offers is chosen; clients that offer none are turned away.
    std::vector<std::string> subprotocols{};
    /// Where pages may be from that connect, beside this machine: SCHEME://HOST[:PORT].
    std::vector<std::string> origins{};
    std::size_t mostClients = 16;
    std::size_t mostWaiting = 4 << 20;  ///< Bytes for a client before messages are dropped.
    /// Connections that have not asked for anything yet; the oldest one leaves for the next.
    std::size_t mostStrangers = 64;
    std::chrono::milliseconds introduction{3000};  ///< Until a connection must have asked.
  };
  enum class EventKind { connected, text, binary, closed };
  struct Event {
    EventKind kind = EventKind::connected;
    std::uint64_t client = 0;  ///< Counted from 1 and never used again.
    std::string data{};
  };

  static Result<std::unique_ptr<WebSocketServer>> open(const Options& options);
  ~WebSocketServer();  ///< Closes all connections.
  WebSocketServer(const WebSocketServer&) = delete;
  WebSocketServer& operator=(const WebSocketServer&) = delete;

  /// Refused connections of one reason.
  struct Refusal {
    std::string why;    ///< A sentence.
    std::string first;  ///< The address of the first one.
    std::uint64_t count = 0;
  };

  std::uint16_t port() const;
  /// What has happened since this was called last. Costs next to nothing if that is nothing. Throws
  /// what has ended the server's thread, such as a lack of memory.
  std::vector<Event> take();
  /// An event was dealt with. While many of a client were not, it is not read.
  void finish(const Event& event);
  /// Whether the client would get a droppable message. Otherwise nobody has to make one: so much
  /// waits for it that it would be dropped, or of a number an older one still waits.
  bool takes(std::uint64_t client, std::uint32_t newestOf = 0) const;
  /// Sends a message as soon as the client can receive it. A client that has disconnected is not an
  /// error.
  void send(std::uint64_t client, WebSocketMessage message);
  /// Messages that were dropped for clients that were too slow, or replaced by newer ones.
  std::uint64_t dropped() const;
  /// One of each reason.
  std::vector<Refusal> refusals() const;

 private:
  class Server;
  explicit WebSocketServer(std::unique_ptr<Server> server);
  std::unique_ptr<Server> server_;
};

}  // namespace gt
