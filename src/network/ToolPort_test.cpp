#include "network/ToolPort.h"

#include <netinet/in.h>
#include <sys/fsuid.h>
#include <sys/socket.h>

#include <fstream>
#include <zmq.hpp>

#include "base/FileDescriptor.h"
#include "debug/Debug.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::NumberPackage;
using testing::TestFolder;

/// A robot's side and two tools.
class ToolPortTest : public ::testing::Test {
 protected:
  ToolPortTest() {
    auto opened = ToolPort::open(robotNetwork, folder.endpoint("tools"));
    EXPECT_TRUE(opened);
    port = std::move(*opened);
    for (auto& tool : tools) tool = *ToolConnection::open(toolNetwork, folder.endpoint("tools"));
  }
  void step() {
    port->update(fromTools);
    for (std::size_t i = 0; i < 2; ++i) tools[i]->update(toTool[i]);
  }
  void sendNumbers(int from, int count) {
    MessageQueue queue;
    for (int i = from; i < from + count; ++i) queue.write(Time{i}, NumberPackage{i});
    port->send(queue);
  }
  static std::vector<int> numbers(const MessageQueue& queue) {
    std::vector<int> list;
    queue.handleAllMessages([&](const Message& message) {
      NumberPackage package;
      EXPECT_TRUE(message.read(package));
      list.push_back(package.number);
    });
    return list;
  }

  TestFolder folder;
  Network robotNetwork, toolNetwork;
  std::unique_ptr<ToolPort> port;
  std::array<std::unique_ptr<ToolConnection>, 2> tools;
  MessageQueue fromTools;
  std::array<MessageQueue, 2> toTool{MessageQueue{2 * toolQueueSize},
                                     MessageQueue{2 * toolQueueSize}};
};

TEST_F(ToolPortTest, EveryToolGetsEveryMessageInOrder) {
  ASSERT_TRUE(eventually([&] { return port->tools() == 2; }, [&] { step(); }));
  int sent = 0;
  ASSERT_TRUE(eventually(
      [&] { return numbers(toTool[0]).size() == 100 && numbers(toTool[1]).size() == 100; },
      [&] {
        if (sent < 100) sendNumbers(sent, 10), sent += 10;
        step();
      }));
  for (const MessageQueue& queue : toTool)
    for (int i = 0; i < 100; ++i) EXPECT_EQ(numbers(queue)[static_cast<std::size_t>(i)], i);
}

TEST_F(ToolPortTest, TheRobotGetsTheMessagesOfAllTools) {
  tools[0]->out().write(Time{}, NumberPackage{1});
  tools[1]->out().write(Time{}, NumberPackage{2});
  ASSERT_TRUE(eventually([&] { return numbers(fromTools).size() == 2; }, [&] { step(); }));
  EXPECT_EQ(numbers(fromTools)[0] + numbers(fromTools)[1], 3);
}

TEST_F(ToolPortTest, AToolThatStallsLosesMessagesAndNobodyElse) {
  ASSERT_TRUE(eventually([&] { return port->tools() == 2; }, [&] { step(); }));
  MessageQueue big;
  Text text;
  text.text = std::string(100'000, 'x');
  big.write(Time{}, text);
  std::size_t arrived = 0;
  for (std::size_t i = 1; i <= 200; ++i) {
    port->send(big);
    ASSERT_TRUE(eventually([&] { return arrived >= i * big.size(); },
                           [&] {
                             port->update(fromTools);
                             toTool[0].clear();
                             tools[0]->update(toTool[0]);  // the other one does nothing
                             arrived += toTool[0].size();
                           }));
  }
  EXPECT_GT(port->dropped(), 100u);
  EXPECT_TRUE(eventually([&] { return port->tools() == 1; },
                         [&] {
                           port->update(fromTools);
                           tools[0]->update(toTool[0]);
                         }))
      << "in the end it is forgotten";
}

/// Report E.3: in real time, who was late gets the newest, and not what it missed.
TEST_F(ToolPortTest, AToolThatIsLateGetsTheNewestIfItAskedForThat) {
  tools[0]->out().write(Time{}, QueueFillRequest{QueueFillMode::replace, 0});
  ASSERT_TRUE(eventually([&] { return !fromTools.empty(); }, [&] { step(); }));
  EXPECT_EQ(numbers(toTool[0]).size(), 0u);
  for (int i = 0; i < 100; ++i) {
    sendNumbers(i, 1);
    port->update(fromTools);  // the tools do nothing
  }
  ASSERT_TRUE(
      eventually([&] { return !numbers(toTool[0]).empty() && numbers(toTool[0]).back() == 99; },
                 [&] { step(); }));
  EXPECT_LE(numbers(toTool[0]).size(), 2u) << "what was on its way, and the newest";
}

TEST_F(ToolPortTest, AToolIsToldWhatItLost) {
  ASSERT_TRUE(eventually([&] { return port->tools() == 2; }, [&] { step(); }));
  MessageQueue big;
  Text text;
  text.text = std::string(900'000, 'x');
  big.write(Time{}, text);
  for (int i = 0; i < 10; ++i) {
    port->send(big);
    port->update(fromTools);
  }
  std::uint64_t lost = 0, arrived = 0;
  const auto all = [&] {
    step();
    toTool[0].handleAllMessages([&](const Message& message) {
      DroppedMessages dropped;
      arrived += message.is<Text>();
      if (message.is<DroppedMessages>() && message.read(dropped)) lost += dropped.types[0].count;
    });
    toTool[0].clear();
    toTool[1].clear();
  };
  EXPECT_TRUE(eventually([&] { return lost + arrived == 10; }, all)) << lost << " " << arrived;
  EXPECT_GT(lost, 0u);
}

TEST_F(ToolPortTest, AToolThatFloodsOrSendsGarbageIsNotListenedTo) {
  port = *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*");
  tools[0] = *ToolConnection::open(toolNetwork, port->endpoint());
  zmq::context_t context;
  zmq::socket_t enemy{context, zmq::socket_type::dealer};
  enemy.set(zmq::sockopt::linger, 0);
  enemy.connect(port->endpoint());
  MessageQueue queue;
  for (int i = 0; i < 1000; ++i) queue.write(Time{}, NumberPackage{7});
  std::vector<std::byte> frame(Frame::headerSize);
  std::ranges::copy(frameHeader({FrameKind::package, representation<MessageQueue>().id, 1, {}, {}}),
                    frame.begin());
  frame.insert(frame.end(), queue.bytes().begin(), queue.bytes().end());
  std::size_t most = 0;
  int i = 0;
  const auto attack = [&] {
    if (i % 2 == 1) frame[frame.size() - static_cast<std::size_t>(i) % 900 - 1] ^= std::byte{0x55};
    enemy.send(zmq::buffer(frame), zmq::send_flags::dontwait);
    if (i % 10 == 0) port->update(fromTools);
    most = std::max(most, fromTools.size());
    ++i;
  };
  while (i < 3000) attack();
  // How much of it has arrived by now is up to the machine.
  EXPECT_TRUE(eventually([&] { return port->rejected() > 100; }, attack));
  EXPECT_LE(most, toolQueueSize) << "memory is bounded";
  fromTools.clear();
  tools[0]->out().write(Time{}, NumberPackage{1});
  const auto heard = [&] {
    bool found = false;
    fromTools.handleAllMessages([&](const Message& message) {
      NumberPackage package;
      if (message.is<NumberPackage>() && message.read(package)) found |= package.number == 1;
    });
    if (!found) fromTools.clear();
    return found;
  };
  EXPECT_TRUE(eventually(heard, [&] { step(); })) << "the others are";
}

/// What this program has of the memory, in MB.
double residentMemory() {
  std::ifstream file{"/proc/self/statm"};
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// A connection that sends nothing.
FileDescriptor stranger(const std::string& endpoint) {
  FileDescriptor socket{::socket(AF_INET, SOCK_STREAM, 0)};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(endpoint.substr(endpoint.rfind(':') + 1))));
  EXPECT_EQ(connect(socket.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  return socket;
}

/// A socket that speaks ZeroMQ's protocol (ZMTP 3.0) as one likes.
FileDescriptor speaker(const std::string& endpoint) {
  FileDescriptor socket = stranger(endpoint);
  std::string greeting(64, '\0');
  greeting[0] = '\xff', greeting[9] = '\x7f', greeting[10] = 3;
  greeting.replace(12, 4, "NULL");
  std::string ready = "\x05READY\x0bSocket-Type";
  ready += std::string{"\0\0\0\x06", 4} + "DEALER";
  const std::string text = greeting + '\x04' + static_cast<char>(ready.size()) + ready;
  EXPECT_EQ(send(socket.number(), text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
  // Who goes on before the other side is ready is sent away.
  std::string answer;
  char bytes[256];
  while (answer.find("ROUTER") == answer.npos) {
    const ssize_t n = recv(socket.number(), bytes, sizeof bytes, 0);
    if (n <= 0) break;
    answer.append(bytes, static_cast<std::size_t>(n));
  }
  return socket;
}

/// Where no key is needed, on this machine, only programs of the same user are let in.
TEST_F(ToolPortTest, AProgramOfAnotherUserIsNotListenedTo) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be another user";
  port = *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*");
  const auto requests = [&](uid_t user) {
    const auto before = static_cast<uid_t>(setfsuid(user));
    const FileDescriptor socket = speaker(port->endpoint());
    setfsuid(before);
    const auto header =
        frameHeader({FrameKind::request, representation<MessageQueue>().id, 1, {}, {}});
    std::string frame{'\0', static_cast<char>(header.size())};
    frame.append(reinterpret_cast<const char*>(header.data()), header.size());
    return eventually([&] { return port->tools() > 0; },
                      [&] {
                        (void)!send(socket.number(), frame.data(), frame.size(),
                                    MSG_DONTWAIT | MSG_NOSIGNAL);
                        port->update(fromTools);
                      },
                      std::chrono::milliseconds{user == 0 ? 60'000 : 500});
  };
  EXPECT_FALSE(requests(65534));
  EXPECT_TRUE(requests(0));
}

TEST_F(ToolPortTest, AMessageOfEndlesslyManyPartsIsCutOff) {
  port = *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*");
  tools[0] = *ToolConnection::open(toolNetwork, port->endpoint());
  const FileDescriptor enemy = speaker(port->endpoint());
  std::string parts;
  for (int i = 0; i < 20'000; ++i) parts += std::string{"\x01\x01x", 3};  // more; one byte
  const double before = residentMemory();
  double most = before;
  std::size_t sent = 0;
  constexpr int longEnough = 1000;  // turns in which nothing is taken
  int refused = 0;
  const auto flood = [&] {
    const std::size_t at = sent % parts.size();  // it may have taken a part of them
    const ssize_t n =
        send(enemy.number(), parts.data() + at, parts.size() - at, MSG_DONTWAIT | MSG_NOSIGNAL);
    sent += n > 0 ? static_cast<std::size_t>(n) : 0;
    refused = n > 0 ? 0 : refused + (errno == EAGAIN ? 1 : longEnough);
    port->update(fromTools);
    most = std::max(most, residentMemory());
  };
  EXPECT_TRUE(eventually([&] { return refused >= longEnough || sent > 60'000'000; }, flood));
  EXPECT_LT(sent, 20'000'000u) << "bytes of one message, those on their way too";
  EXPECT_GT(sent, toolQueueSize) << "a frame may have so many";
  EXPECT_LT(most - before, 400) << "MB";
  tools[0]->out().write(Time{}, NumberPackage{1});
  EXPECT_TRUE(eventually([&] { return numbers(fromTools).size() == 1; }, [&] { step(); }));
}

TEST_F(ToolPortTest, ACrowdOfConnectionsIsNotLetIn) {
  port = *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*");
  tools[0] = *ToolConnection::open(toolNetwork, port->endpoint());
  ASSERT_TRUE(eventually([&] { return tools[0]->connected(); }, [&] { step(); }));
  std::vector<FileDescriptor> crowd;
  for (int i = 0; i < 150; ++i) {
    crowd.push_back(speaker(port->endpoint()));
    step();
  }
  std::size_t open = 0;
  const auto count = [&] {
    open = 0;
    char ignored[256];
    for (const FileDescriptor& socket : crowd)
      while (true) {
        const ssize_t n = recv(socket.number(), ignored, sizeof ignored, MSG_DONTWAIT);
        if (n > 0) continue;
        open += n < 0 && errno == EAGAIN;
        break;
      }
    return open <= 64;
  };
  EXPECT_TRUE(eventually(count, [&] { step(); })) << open;
  fromTools.clear();
  tools[0]->out().write(Time{}, NumberPackage{1});
  EXPECT_TRUE(eventually([&] { return numbers(fromTools).size() == 1; }, [&] { step(); }));
}

/// They come again and again, too, and take no place from who has the key.
TEST_F(ToolPortTest, ACrowdThatSendsNothingKeepsNoToolOut) {
  ASSERT_TRUE(makeKeys(folder.file("keys")));
  port =
      *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*", *loadKeys(folder.file("keys/robot.key")));
  std::vector<FileDescriptor> crowd;
  for (int i = 0; i < 300; ++i) {
    crowd.push_back(stranger(port->endpoint()));
    if (i % 10 == 0) port->update(fromTools);
  }
  tools[0] =
      *ToolConnection::open(toolNetwork, port->endpoint(), *loadKeys(folder.file("keys/tool.key")));
  std::size_t next = 0;
  const auto again = [&] {
    robotNetwork.wait(0);
    step();
    crowd[next++ % crowd.size()] = stranger(port->endpoint());
  };
  ASSERT_TRUE(eventually([&] { return tools[0]->connected(); }, again));
  tools[0]->out().write(Time{}, NumberPackage{1});
  EXPECT_TRUE(eventually([&] { return numbers(fromTools).size() == 1; }, again));
}

/// As many as like may come with a key, but from one machine they do not take all places.
TEST_F(ToolPortTest, ToolsOfOneAddressLeavePlacesForOthers) {
  port = *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*");
  std::vector<std::unique_ptr<ToolConnection>> crowd;
  for (int i = 0; i < 60; ++i)
    crowd.push_back(*ToolConnection::open(toolNetwork, port->endpoint()));
  MessageQueue ignored;
  const auto all = [&] {
    port->update(fromTools);
    for (const auto& tool : crowd) tool->update(ignored);
  };
  ASSERT_TRUE(eventually(
      [&] { return port->tools() >= 16 && port->refusals()[Refusal::share] >= 28; }, all));
  EXPECT_EQ(port->tools(), 16u);
  const std::string elsewhere = "tcp://127.0.0.2:0;" + port->endpoint().substr(6);
  crowd.push_back(*ToolConnection::open(toolNetwork, elsewhere));
  EXPECT_TRUE(eventually([&] { return crowd.back()->connected(); }, all));
  EXPECT_EQ(port->takeNews(),
            std::vector<std::string>{"a tool is not let in: too many from one address"});
  EXPECT_TRUE(port->takeNews().empty()) << "once";
}

TEST_F(ToolPortTest, CountsWhoIsNotLetIn) {
  ASSERT_TRUE(makeKeys(folder.file("ours")));
  ASSERT_TRUE(makeKeys(folder.file("theirs")));
  port =
      *ToolPort::open(robotNetwork, "tcp://127.0.0.1:*", *loadKeys(folder.file("ours/robot.key")));
  const Keys theirs = *loadKeys(folder.file("theirs/tool.key"));
  Keys unknown = theirs;
  unknown.serverPublic = loadKeys(folder.file("ours/tool.key"))->serverPublic;
  const auto without = *ToolConnection::open(toolNetwork, port->endpoint()),
             wrong = *ToolConnection::open(toolNetwork, port->endpoint(), theirs),
             stranger_ = *ToolConnection::open(toolNetwork, port->endpoint(), unknown);
  {
    const FileDescriptor silent = stranger(port->endpoint());
    port->update(fromTools);
  }
  const auto all = [&] {
    robotNetwork.wait(0);
    port->update(fromTools);
  };
  EXPECT_TRUE(eventually(
      [&] {
        const Refusals refused = port->refusals();
        return refused[Refusal::wrongKey] >= 2 && refused[Refusal::unknownKey] >= 1 &&
               refused[Refusal::silent] >= 1;
      },
      all))
      << describe(port->refusals());
  EXPECT_TRUE(
      eventually([&] { return !without->trouble().empty() && !wrong->trouble().empty(); }, all));
  EXPECT_EQ(without->trouble(), "it asks for a key, and this side has none");
  EXPECT_EQ(wrong->trouble(), "the key does not fit, or the other side has none");
  EXPECT_EQ(port->takeNews().size(), 2u) << "those that the user can do something about";
  EXPECT_EQ(port->tools(), 0u);
}

TEST(Refusals, AreDescribed) {
  Refusals refusals;
  EXPECT_EQ(describe(refusals), "");
  refusals[Refusal::otherUser] = 2;
  refusals[Refusal::silent] = 3;
  EXPECT_EQ(describe(refusals), "5 refused: 2 another user's program, 3 sent nothing");
}

}  // namespace
}  // namespace gt
