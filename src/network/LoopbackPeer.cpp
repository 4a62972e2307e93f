#include "network/LoopbackPeer.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace gt {
namespace {

/// An end of a connection as /proc/net/tcp and tcp6 list it.
struct End {
  std::string text;
  bool isLoopback = false;
};

std::string words(const void* address, std::size_t size, in_port_t port) {
  std::string text;
  std::array<char, 16> word{};
  for (std::size_t i = 0; i < size; i += sizeof(std::uint32_t)) {
    std::uint32_t value = 0;
    std::memcpy(&value, static_cast<const char*>(address) + i, sizeof value);
    std::snprintf(word.data(), word.size(), "%08X", value);
    text += word.data();
  }
  std::snprintf(word.data(), word.size(), ":%04X", static_cast<unsigned>(ntohs(port)));
  return text + word.data();
}

std::optional<End> endOf(int socket, decltype(&getpeername) which) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (which(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return std::nullopt;
  in_addr four{};
  in_port_t port = 0;
  if (address.ss_family == AF_INET) {
    const auto& in = reinterpret_cast<const sockaddr_in&>(address);
    four = in.sin_addr;
    port = in.sin_port;
  } else if (address.ss_family == AF_INET6) {
    const auto& in = reinterpret_cast<const sockaddr_in6&>(address);
    if (!IN6_IS_ADDR_V4MAPPED(&in.sin6_addr))
      return End{words(&in.sin6_addr, sizeof in.sin6_addr, in.sin6_port),
                 IN6_IS_ADDR_LOOPBACK(&in.sin6_addr) != 0};
    constexpr int before = 12;  // bytes of an address of IPv6 that stands for one of IPv4
    std::memcpy(&four, in.sin6_addr.s6_addr + before, sizeof four);
    port = in.sin6_port;
  } else {
    return std::nullopt;
  }
  constexpr int network = 24;  // bits behind it
  return End{words(&four, sizeof four, port), ntohl(four.s_addr) >> network == IN_LOOPBACKNET};
}

}  // namespace

bool isOverLoopback(int socket) {
  const auto own = endOf(socket, getsockname);
  return own && own->isLoopback;
}

bool isPeerOfThisUser(int socket) {
  const auto peer = endOf(socket, getpeername), own = endOf(socket, getsockname);
  if (!peer || !own) return false;
  for (const char* file : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    std::ifstream connections{file};
    for (std::string line; std::getline(connections, line);) {
      std::istringstream columns{line};
      std::string number, local, remote, state, queues, timer, retransmits;
      uid_t user = 0;
      if (columns >> number >> local >> remote >> state >> queues >> timer >> retransmits >> user &&
          local == peer->text && remote == own->text)
        return user == geteuid() || user == 0;
    }
  }
  return false;
}

}  // namespace gt
