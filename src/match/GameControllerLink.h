#pragma once
#include <netinet/in.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Receives a game controller's messages by UDP, and answers them.
class GameControllerLink {
 public:
  /// Listens on a port of all interfaces; 0 takes a free one.
  static Result<std::unique_ptr<GameControllerLink>> listen(int port);
  ~GameControllerLink();
  GameControllerLink(const GameControllerLink&) = delete;
  GameControllerLink& operator=(const GameControllerLink&) = delete;

  int port() const { return port_; }
  /// The next message, from any sender. Empty if none is pending. Does not block.
  std::optional<std::vector<std::byte>> receive();
  /// Sends to a port of the machine that the last message came from.
  void answer(std::span<const std::byte> bytes, int port) const;

 private:
  GameControllerLink(int socket, int port) : socket_{socket}, port_{port} {}

  int socket_;
  int port_;
  sockaddr_in sender_{};
};

}  // namespace gt
