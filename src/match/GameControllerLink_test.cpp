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
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&own), size), 0);
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
  if (!message) return "";
  return {reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size()};
}

TEST(GameControllerLink, ReceivesEachMessageOnceAndAnswersTheLastSender) {
  const auto link = std::move(*GameControllerLink::listen({}));
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

TEST(GameControllerLink, SaysWhoSentAMessage) {
  const auto link = std::move(*GameControllerLink::listen({}));
  const GameManager manager;
  manager.send(link->port(), "set");
  const auto message = link->receive();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->sender, "127.0.0.1:" + std::to_string(manager.port()));
}

TEST(GameControllerLink, TellsWhereItCannotListen) {
  const auto link = std::move(*GameControllerLink::listen({}));
  const auto port = static_cast<std::uint16_t>(link->port());
  for (const char* address : {"127.0.0.1", "192.0.2.1", "here", "::1"}) {
    const auto second = GameControllerLink::listen({address, port});
    ASSERT_FALSE(second) << address;
    EXPECT_EQ(second.error().field, std::string{address} + ":" + std::to_string(port));
  }
}

TEST(GameControllerLink, HearsOnlyThisMachineUnlessAskedFor) {
  const auto link = std::move(*GameControllerLink::listen({}));
  // Another address of this machine has room for the same port.
  EXPECT_TRUE(GameControllerLink::listen({"127.0.0.2", static_cast<std::uint16_t>(link->port())}));
}

}  // namespace
}  // namespace gt
