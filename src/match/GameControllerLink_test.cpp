#include "match/GameControllerLink.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace gt {
namespace {

/// A game controller on this machine.
class GameManager {
 public:
  GameManager() : socket_{::socket(AF_INET, SOCK_DGRAM, 0)} {
    sockaddr_in own = local(0);
    socklen_t size = sizeof own;
    ::bind(socket_, reinterpret_cast<sockaddr*>(&own), size);
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
    port_ = ntohs(own.sin_port);
  }
  ~GameManager() { ::close(socket_); }
  GameManager(const GameManager&) = delete;
  GameManager& operator=(const GameManager&) = delete;

  int port() const { return port_; }
  void send(int port, const std::string& text) const {
    const sockaddr_in to = local(port);
    ::sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to),
             sizeof to);
  }
  std::string receive() const {
    pollfd waiting{socket_, POLLIN, 0};
    constexpr int patience = 60'000;  // ms
    ::poll(&waiting, 1, patience);
    char buffer[100];
    const auto size = ::recv(socket_, buffer, sizeof buffer, MSG_DONTWAIT);
    return {buffer, size > 0 ? static_cast<std::size_t>(size) : 0};
  }

 private:
  static sockaddr_in local(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
  }

  int socket_, port_ = 0;
};

/// The next message; empty if none is pending. Loopback delivers before `sendto` returns.
std::string next(GameControllerLink& link) {
  const auto message = link.receive();
  return message ? std::string{reinterpret_cast<const char*>(message->data()), message->size()}
                 : "";
}

TEST(GameControllerLink, ReceivesEachMessageOnceAndAnswersTheLastSender) {
  const auto link = std::move(*GameControllerLink::listen(0));
  EXPECT_EQ(next(*link), "") << "does not block";
  const GameManager first, second, answers;
  first.send(link->port(), "ready");
  first.send(link->port(), "set");
  EXPECT_EQ(next(*link), "ready");
  EXPECT_EQ(next(*link), "set");
  EXPECT_EQ(next(*link), "");
  const std::string alive = "alive";
  link->answer(std::as_bytes(std::span{alive}), answers.port());
  EXPECT_EQ(answers.receive(), alive) << "at another port of the sender's machine";
  second.send(link->port(), "playing");
  EXPECT_EQ(next(*link), "playing");
}

TEST(GameControllerLink, TellsThatAPortIsTaken) {
  const auto link = std::move(*GameControllerLink::listen(0));
  const auto second = GameControllerLink::listen(link->port());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().field, "port " + std::to_string(link->port()));
}

}  // namespace
}  // namespace gt
