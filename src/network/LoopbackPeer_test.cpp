#include "network/LoopbackPeer.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace gt {
namespace {

constexpr uid_t anotherUser = 65534;

/// A listening socket; `use` gets the accepted end of a connection that a child makes as `user`.
template <typename Address>
void connectAs(uid_t user, Address address, const std::function<void(int)>& use) {
  const int listener = socket(reinterpret_cast<sockaddr&>(address).sa_family, SOCK_STREAM, 0);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listener, 1), 0);
  ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const pid_t child = fork();
  if (child == 0) {
    if (user != geteuid() && setuid(user) != 0) _exit(2);
    const int own = socket(reinterpret_cast<sockaddr&>(address).sa_family, SOCK_STREAM, 0);
    if (connect(own, reinterpret_cast<sockaddr*>(&address), size) != 0) _exit(1);
    char byte = 0;
    const auto end = read(own, &byte, 1);  // until the test closes its end
    _exit(end == 0 ? 0 : 1);
  }
  const int accepted = accept(listener, nullptr, nullptr);
  use(accepted);
  close(accepted);
  close(listener);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

sockaddr_in loopback() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

TEST(LoopbackPeer, OfTheSameUserIsKnown) {
  connectAs(geteuid(), loopback(), [](int socket) {
    EXPECT_TRUE(isOverLoopback(socket));
    EXPECT_TRUE(isPeerOfThisUser(socket));
  });
}

TEST(LoopbackPeer, OfAnotherUserIsTold) {
  if (geteuid() != 0) GTEST_SKIP() << "only the administrator can become another user";
  connectAs(anotherUser, loopback(), [](int socket) {
    EXPECT_TRUE(isOverLoopback(socket));
    EXPECT_FALSE(isPeerOfThisUser(socket));
  });
}

TEST(LoopbackPeer, IsKnownByAnAddressOfIPv6) {
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_addr = in6addr_loopback;
  const int probe = socket(AF_INET6, SOCK_STREAM, 0);
  const bool missing =
      probe < 0 || bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0;
  close(probe);
  if (missing) GTEST_SKIP() << "this machine has no IPv6";
  connectAs(geteuid(), address, [](int socket) {
    EXPECT_TRUE(isOverLoopback(socket));
    EXPECT_TRUE(isPeerOfThisUser(socket));
  });
  if (geteuid() == 0)
    connectAs(anotherUser, address, [](int socket) { EXPECT_FALSE(isPeerOfThisUser(socket)); });
}

TEST(LoopbackPeer, WithoutAConnectionIsNobodys) {
  const int alone = socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_FALSE(isPeerOfThisUser(alone));
  close(alone);
}

}  // namespace
}  // namespace gt
