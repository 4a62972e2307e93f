#include "network/LocalSocket.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::TestFolder;

struct Load {
  std::vector<std::uint8_t> bytes;

  static constexpr auto fields() { return Fields{field<&Load::bytes>()}; }
};
const RepresentationType& load = representation<Load>();

Load loadOf(std::size_t size, int seed) {
  Load value;
  value.bytes.resize(size);
  for (std::size_t i = 0; i < size; ++i)
    value.bytes[i] = static_cast<std::uint8_t>(i * 7 + static_cast<std::size_t>(seed));
  return value;
}

/// What came in last at a socket, and how much came in so far.
struct Inbox {
  explicit Inbox(Socket& s) : socket{s} {}
  void take() {
    for (Received received; socket.receive(received); ++count) {
      peer = received.peer;
      if (received.frame.kind != FrameKind::package) continue;
      EXPECT_TRUE(decode(received.frame.bytes, value));
    }
  }
  /// Waits for one more frame.
  bool next() {
    const int before = count;
    return eventually([&] { return count > before; }, [&] { take(); });
  }
  Socket& socket;
  std::string peer;
  Load value;
  int count = 0;
};

class LocalSocketTest : public ::testing::Test {
 protected:
  LocalSocketTest()
      : server{**network.listen(endpoint)},
        client{**network.connect(endpoint, "client")},
        atServer{server},
        atClient{client} {
    EXPECT_TRUE(client.send("", FrameKind::request, load, nullptr));
    EXPECT_TRUE(atServer.next());
    EXPECT_EQ(atServer.peer, "client");
  }
  void expectPasses(const Load& value) {
    ASSERT_TRUE(server.send("client", FrameKind::package, load, &value));
    ASSERT_TRUE(atClient.next());
    EXPECT_EQ(atClient.value.bytes, value.bytes);
  }
  /// After whatever somebody did, others are served.
  void expectServes() {
    Load value = loadOf(50'000, 1);
    ASSERT_TRUE(client.send("", FrameKind::package, load, &value));
    ASSERT_TRUE(
        eventually([&] { return atServer.value.bytes == value.bytes; }, [&] { atServer.take(); }));
    expectPasses(loadOf(70'000, 2));
  }

  TestFolder folder;
  const std::string endpoint = folder.endpoint("socket");
  Network network;
  Socket &server, &client;
  Inbox atServer, atClient;
};

TEST_F(LocalSocketTest, CarriesPackagesOfAllSizes) {
  int seed = 0;
  for (const std::size_t size : {0, 1, 4000, 4085, 4086, 4087, 4088, 4089, 5000, 65'000, 65'536,
                                 65'537, 1'000'000, 10, 100'000, 3'900'000, 4096})
    expectPasses(loadOf(size, ++seed));
  const Load tooLarge = loadOf(4'000'001, 0);
  EXPECT_FALSE(server.send("client", FrameKind::package, load, &tooLarge));
  EXPECT_FALSE(server.send("nobody", FrameKind::request, load, nullptr));
  expectServes();
}

/// Two packages have room; who sends more before one is read replaces the older.
TEST_F(LocalSocketTest, NewestPackagesReplaceOlderOnes) {
  for (int i = 1; i <= 5; ++i) {
    const Load value = loadOf(100'000, i);
    ASSERT_TRUE(server.send("client", FrameKind::package, load, &value));
  }
  const int before = atClient.count;
  ASSERT_TRUE(atClient.next());
  EXPECT_EQ(atClient.count - before, 2);
  EXPECT_EQ(atClient.value.bytes, loadOf(100'000, 5).bytes);
  EXPECT_EQ(client.rejected(), 0u);
}

TEST_F(LocalSocketTest, AProgramThatIsStartedAgainTakesItsPlace) {
  expectPasses(loadOf(100'000, 3));
  Network other;
  Socket& again = **other.connect(endpoint, "client");
  ASSERT_TRUE(again.send("", FrameKind::request, load, nullptr));
  ASSERT_TRUE(atServer.next());
  Inbox atAgain{again};
  const Load value = loadOf(100'000, 4);
  ASSERT_TRUE(server.send("client", FrameKind::package, load, &value));
  ASSERT_TRUE(atAgain.next());
  EXPECT_EQ(atAgain.value.bytes, value.bytes) << "with the memory that belongs to it";
}

TEST_F(LocalSocketTest, AServerThatIsStartedAgainIsFound) {
  TestFolder place;
  auto first = std::make_unique<Network>();
  Socket& old = **first->listen(place.endpoint("s"));
  Socket& user = **network.connect(place.endpoint("s"), "user");
  const auto request = [&] { user.send("", FrameKind::request, load, nullptr); };
  Inbox atOld{old};
  ASSERT_TRUE(eventually([&] { return atOld.count > 0; }, [&] { request(), atOld.take(); }));
  Network second;
  EXPECT_FALSE(second.listen(place.endpoint("s"))) << "somebody listens there";
  first.reset();
  EXPECT_FALSE(std::filesystem::exists(place.file("s")));
  Socket& next = **second.listen(place.endpoint("s"));
  Inbox atNext{next};
  EXPECT_TRUE(eventually([&] { return atNext.count > 0; },
                         [&] {
                           Received ignored;
                           user.receive(ignored);
                           request();
                           atNext.take();
                         }));
}

TEST(LocalSocket, WhatAKilledProgramLeftIsNoObstacle) {
  const TestFolder folder;
  const std::string path = folder.file("s");
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path.c_str());
  FileDescriptor left{socket(AF_UNIX, SOCK_SEQPACKET, 0)};
  ASSERT_EQ(bind(left.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  left = FileDescriptor{};
  ASSERT_TRUE(std::filesystem::exists(path));
  Network network;
  EXPECT_TRUE(network.listen("ipc://" + path));
  std::ofstream{folder.file("file")} << "precious";
  EXPECT_FALSE(network.listen(folder.endpoint("file")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("file"))) << "not taken away";
  EXPECT_FALSE(network.listen("ipc://" + std::string(200, 'x')));
  EXPECT_FALSE(network.connect("ipc://" + std::string(200, 'x'), ""));
  EXPECT_FALSE(network.listen("ipc://"));
  EXPECT_FALSE(network.listen(folder.endpoint("no/such/folder")));
}

/// Somebody who speaks with a local socket as he likes.
class Enemy {
 public:
  explicit Enemy(const std::string& path)
      : socket_{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0)} {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, path.c_str());
    EXPECT_EQ(connect(socket_.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  bool send(const std::string& bytes, int descriptor = -1, std::size_t copies = 1) {
    iovec part{const_cast<char*>(bytes.data()), bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    std::vector<std::byte> control(CMSG_SPACE(copies * sizeof(int)));
    if (descriptor >= 0) {
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      cmsghdr* beside = CMSG_FIRSTHDR(&message);
      *beside = {CMSG_LEN(copies * sizeof(int)), SOL_SOCKET, SCM_RIGHTS};
      for (std::size_t i = 0; i < copies; ++i)
        std::memcpy(CMSG_DATA(beside) + i * sizeof(int), &descriptor, sizeof descriptor);
    }
    return sendmsg(socket_.number(), &message, MSG_NOSIGNAL) >= 0;
  }
  /// A notice of a package in shared memory.
  static std::string notice(std::uint64_t number, std::uint64_t size) {
    const auto header = frameHeader({FrameKind::package, load.id, 1, {}, {}});
    std::string text(16, '\0');
    std::memcpy(text.data(), &number, 8);
    std::memcpy(text.data() + 8, &size, 8);
    return text + std::string{reinterpret_cast<const char*>(header.data()), header.size()};
  }

 private:
  FileDescriptor socket_;
};

FileDescriptor memory(std::size_t size, int seals) {
  FileDescriptor result{memfd_create("enemy", MFD_ALLOW_SEALING)};
  EXPECT_EQ(ftruncate(result.number(), static_cast<off_t>(size)), 0);
  EXPECT_EQ(fcntl(result.number(), F_ADD_SEALS, seals), 0);
  return result;
}

std::size_t openFiles() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator{"/proc/self/fd"}) {
    static_cast<void>(entry);
    ++count;
  }
  return count;
}

TEST_F(LocalSocketTest, MemoryThatIsNoneIsRefused) {
  Enemy enemy{folder.file("socket")};
  ASSERT_TRUE(enemy.send("GT-local-2 enemy"));
  const FileDescriptor file{open("/etc/passwd", O_RDONLY)}, null{open("/dev/null", O_RDONLY)};
  const FileDescriptor unsealed = memory(200'000, 0), tiny = memory(64, F_SEAL_SHRINK),
                       empty = memory(0, F_SEAL_SHRINK),
                       huge = memory(std::size_t{1} << 40, F_SEAL_SHRINK);
  std::uint64_t wrong = 0;
  for (const FileDescriptor* descriptor : {&file, &null, &unsealed, &tiny, &empty, &huge}) {
    ASSERT_TRUE(enemy.send(Enemy::notice(1, 100), descriptor->number()));
    ++wrong;
  }
  ASSERT_TRUE(enemy.send(Enemy::notice(1, 100)));  // of memory that never came
  ++wrong;
  EXPECT_TRUE(eventually([&] { return server.rejected() == wrong; }, [&] { atServer.take(); }));
  expectServes();
}

TEST_F(LocalSocketTest, NumbersAndSizesInSharedMemoryAreNotTrusted) {
  Enemy enemy{folder.file("socket")};
  ASSERT_TRUE(enemy.send("GT-local-2 enemy"));
  const FileDescriptor slot = memory(200'000, F_SEAL_SHRINK);
  auto* numbers = static_cast<std::uint64_t*>(
      mmap(nullptr, 200'000, PROT_READ | PROT_WRITE, MAP_SHARED, slot.number(), 0));
  std::memset(numbers, 0xff, 200'000);
  ASSERT_TRUE(enemy.send(Enemy::notice(7, 1000), slot.number()));
  for (const std::uint64_t size :
       {std::uint64_t{99'969}, std::uint64_t{200'000}, std::uint64_t{1} << 40, ~std::uint64_t{0}})
    for (const std::uint64_t number : {std::uint64_t{1}, ~std::uint64_t{0}})
      ASSERT_TRUE(enemy.send(Enemy::notice(number, size)));
  // What has the right number and size is a package, if one that cannot be read.
  ASSERT_TRUE(enemy.send(Enemy::notice(~std::uint64_t{0}, 99'968)));
  Received received;
  ASSERT_TRUE(eventually([&] { return server.receive(received); }, [] {}));
  EXPECT_EQ(received.frame.bytes.size(), 99'968u);
  EXPECT_EQ(received.peer, "enemy");
  EXPECT_GE(server.rejected(), 4u);
  expectServes();
  munmap(numbers, 200'000);
}

TEST_F(LocalSocketTest, AFloodOfGarbageHarmsNobody) {
  expectServes();
  const std::size_t files = openFiles();
  {
    Enemy enemy{folder.file("socket")}, silent{folder.file("socket")};
    const FileDescriptor slot = memory(200'000, F_SEAL_SHRINK);
    enemy.send("GT-local-2 client2");
    for (int i = 0; i < 5000; ++i) {
      const auto n = static_cast<std::size_t>(i);
      enemy.send(std::string(n % 5000, static_cast<char>(i)), i % 3 ? -1 : slot.number(),
                 n % 4 + 1);
      enemy.send(Enemy::notice(n, n * 1000).substr(0, n % 50), i % 2 ? -1 : slot.number(), 3);
      if (i % 50 == 0) atServer.take();
    }
    expectServes();
  }
  EXPECT_TRUE(eventually([&] { return openFiles() <= files; }, [&] { atServer.take(); }))
      << openFiles() << " of " << files;
}

TEST_F(LocalSocketTest, WhoWaitsWhileThereAreNoDescriptorsDoesNotKeepTheProgramAwake) {
  FileDescriptor waiting{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0)};
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const FileDescriptor next{dup(0)};  // all with lower numbers are in use
  const rlimit few{static_cast<rlim_t>(next.number()), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, folder.file("socket").c_str());
  EXPECT_EQ(connect(waiting.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  int awake = 0;
  for (const std::int64_t begin = network.elapsed(); network.elapsed() - begin < 500; ++awake) {
    network.wait(20);
    atServer.take();
  }
  EXPECT_LE(awake, 50);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  const std::size_t files = openFiles();
  EXPECT_TRUE(eventually([&] { return openFiles() > files; }, [&] { atServer.take(); }))
      << "it is let in when there are some";
}

TEST_F(LocalSocketTest, OnlySoManyAreLetIn) {
  std::vector<std::unique_ptr<Enemy>> crowd;
  const std::size_t files = openFiles();
  for (int i = 0; i < 200; ++i) {
    crowd.push_back(std::make_unique<Enemy>(folder.file("socket")));
    crowd.back()->send("GT-local-2 ");
    usleep(1100);
    atServer.take();
  }
  EXPECT_LE(openFiles(), files + 200 + SocketLimits{}.peers);
  expectServes();
}

}  // namespace
}  // namespace gt
