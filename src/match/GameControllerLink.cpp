#include "match/GameControllerLink.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

namespace gt {
namespace {

/// Bytes; longer ones lose their end, and are no messages then.
constexpr std::size_t longestDatagram = 2048;

sockaddr* general(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);
}

}  // namespace

Result<std::unique_ptr<GameControllerLink>> GameControllerLink::listen(int port) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket < 0) return Error{.file = "game controller", .what = std::strerror(errno)};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof address;
  if (::bind(socket, general(address), size) != 0 ||
      ::getsockname(socket, general(address), &size) != 0) {
    const Error error{.file = "game controller",
                      .field = "port " + std::to_string(port),
                      .what = std::strerror(errno)};
    ::close(socket);
    return error;
  }
  return std::unique_ptr<GameControllerLink>{
      new GameControllerLink{socket, ntohs(address.sin_port)}};
}

GameControllerLink::~GameControllerLink() {
  ::close(socket_);
}

std::optional<std::vector<std::byte>> GameControllerLink::receive() {
  std::array<std::byte, longestDatagram> buffer;
  socklen_t size = sizeof sender_;
  const auto count = ::recvfrom(socket_, buffer.data(), buffer.size(), 0, general(sender_), &size);
  if (count < 0) return std::nullopt;
  return std::vector<std::byte>{buffer.begin(), buffer.begin() + count};
}

void GameControllerLink::answer(std::span<const std::byte> bytes, int port) const {
  sockaddr_in to = sender_;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  // An answer that is lost is sent again with the next message.
  static_cast<void>(::sendto(socket_, bytes.data(), bytes.size(), 0, general(to), sizeof to));
}

}  // namespace gt
