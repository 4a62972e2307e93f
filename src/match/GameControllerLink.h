#pragma once
#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"
#include "network/Endpoint.h"

namespace gt {

/// A packet received by UDP.
struct Datagram {
  std::vector<std::byte> bytes;
  std::string sender;     ///< ADDRESS:PORT
  std::int64_t time = 0;  ///< When it was received: ms of a monotonic clock.
};

/// Receives a game controller's messages by UDP, and answers them.
class GameControllerLink {
 public:
  /// Listens on an address of IPv4 and a port; port 0 takes a free one.
  static Result<std::unique_ptr<GameControllerLink>> listen(const Endpoint& endpoint);
  ~GameControllerLink();
  GameControllerLink(const GameControllerLink&) = delete;
  GameControllerLink& operator=(const GameControllerLink&) = delete;

  int port() const { return port_; }
  /// The next message, from any sender. Empty if none is pending. Does not block.
  std::optional<Datagram> receive();
  /// Sends an answer to a port of the machine that sent the last message.
  void answer(std::span<const std::byte> bytes, int port) const;

 private:
  GameControllerLink(int socket, int port) : socket_{socket}, port_{port} {}

  int socket_;
  int port_;
  sockaddr_in sender_{};
};

}  // namespace gt
