#include "match/GameControllerLink.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>

namespace gt {
namespace {

/// Size of the receive buffer (bytes). Longer packets are truncated and then are no valid messages.
constexpr std::size_t longestDatagram = 2048;

sockaddr* general(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);
}

std::string senderName(const sockaddr_in& address) {
  char text[INET_ADDRSTRLEN] = "";
  inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
  return std::string{text} + ":" + std::to_string(ntohs(address.sin_port));
}

std::int64_t clockMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Result<std::unique_ptr<GameControllerLink>> GameControllerLink::listen(const Endpoint& endpoint) {
  const auto failed = [&](const char* what) {
    return Error{.file = "game controller",
                 .field = endpoint.address + ":" + std::to_string(endpoint.port),
                 .what = what};
  };
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(endpoint.port);
  if (inet_pton(AF_INET, endpoint.address.c_str(), &address.sin_addr) != 1)
    return failed("is no IPv4 address of this machine");
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket < 0) return failed(std::strerror(errno));
  socklen_t size = sizeof address;
  if (::bind(socket, general(address), size) != 0 ||
      ::getsockname(socket, general(address), &size) != 0) {
    const Error error = failed(std::strerror(errno));
    ::close(socket);
    return error;
  }
  return std::unique_ptr<GameControllerLink>{
      new GameControllerLink{socket, ntohs(address.sin_port)}};
}

GameControllerLink::~GameControllerLink() {
  ::close(socket_);
}

std::optional<Datagram> GameControllerLink::receive() {
  std::array<std::byte, longestDatagram> buffer;
  socklen_t size = sizeof sender_;
  const auto count = ::recvfrom(socket_, buffer.data(), buffer.size(), 0, general(sender_), &size);
  if (count < 0) return std::nullopt;
  return Datagram{{buffer.begin(), buffer.begin() + count}, senderName(sender_), clockMs()};
}

void GameControllerLink::answer(std::span<const std::byte> bytes, int port) const {
  sockaddr_in to = sender_;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  // An answer that is lost is sent again with the next message.
  static_cast<void>(::sendto(socket_, bytes.data(), bytes.size(), 0, general(to), sizeof to));
}

}  // namespace gt
