#pragma once
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <string>
#include <utility>
#include <vector>

#include "base/FileDescriptor.h"

namespace gt {

/// Connects to a port of this machine, or a local socket, again and again, and sends garbage over a
/// third of the connections. None of them waits.
inline std::vector<FileDescriptor> connectMany(const sockaddr* to, socklen_t size, int type) {
  constexpr int connections = 2000;
  std::vector<FileDescriptor> all;
  for (int i = 0; i < connections; ++i) {
    FileDescriptor socket{::socket(to->sa_family, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    if (!socket) continue;
    static_cast<void>(connect(socket.number(), to, size));  // goes on by itself
    if (i % 3 == 0) send(socket.number(), "garbage", 7, MSG_NOSIGNAL);
    all.push_back(std::move(socket));
  }
  return all;
}
inline std::vector<FileDescriptor> connectMany(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connectMany(reinterpret_cast<sockaddr*>(&address), sizeof address, SOCK_STREAM);
}
inline std::vector<FileDescriptor> connectMany(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  return connectMany(reinterpret_cast<sockaddr*>(&address), sizeof address, SOCK_SEQPACKET);
}

}  // namespace gt
