#include "network/Wire.h"

#include <cmath>
#include <zmq.hpp>

#include "support/TestWire.h"

namespace gt {
namespace {

using testing::Custom;
using testing::eventually;
using testing::NumberPackage;
using testing::patience;
using testing::TestFolder;
namespace newer = testing::newer;

/// A program with one process, as on the robot.
struct Program {
  explicit Program(const std::string& name) : wire{network, name}, process{name} {}
  /// A turn of its loop.
  bool step() { return stepAt(Time{network.elapsed()}); }
  bool stepAt(Time now) {
    network.wait(0);
    wire.takeIn();
    const bool ran = process.step(now);
    wire.askForMore();
    return ran;
  }
  Network network;
  Wire wire;
  Custom process;
};

struct Source : Program {
  explicit Source(const std::string& endpoint, bool blocking = false)
      : Program{"Source"}, numbers{process, blocking} {
    EXPECT_TRUE(wire.listen(endpoint));
    wire.provide(numbers);
    process.work = [this] {
      ++numbers.number;
      numbers.send();
    };
  }
  Sender<NumberPackage> numbers;
};

struct Sink : Program {
  explicit Sink(const std::string& endpoint, const std::string& name = "Sink")
      : Program{name}, numbers{process, true} {
    EXPECT_TRUE(wire.connect("Source", endpoint));
    wire.receive("Source", numbers);
    process.pause = 0;
    process.work = [this] { printed.push_back(numbers.number); };
  }
  Receiver<NumberPackage> numbers;
  std::vector<int> printed;
};

/// Not among those that the system gives away: a router's other ports were taken by then at times.
TEST(FreePort, HasRoomForARouterBehindIt) {
  const int first = testing::freePort(), second = testing::freePort();
  EXPECT_GE(std::abs(first - second), 300);
  EXPECT_LT(std::max(first, second) + 300, 32768);
}

TEST(Wire, CarriesPackages) {
  const TestFolder folder;
  Source source{folder.endpoint("a")};
  Sink sink{folder.endpoint("a")};
  EXPECT_TRUE(eventually([&] { return sink.printed.size() >= 20; },
                         [&] {
                           source.step();
                           sink.step();
                         }));
  for (std::size_t i = 1; i < sink.printed.size(); ++i)
    EXPECT_GT(sink.printed[i], sink.printed[i - 1]) << "always a new number";
  EXPECT_EQ(source.wire.rejected() + sink.wire.rejected(), 0u);
}

/// Each of two receivers of one type is served, as in one program.
TEST(Wire, AProcessMayHaveTwoReceiversOfOneType) {
  const TestFolder folder;
  Source source{folder.endpoint("a")};
  Sink sink{folder.endpoint("a")};
  Receiver<NumberPackage> second{sink.process};
  sink.wire.receive("Source", second);
  std::vector<int> seconds;
  sink.process.work = [&] {
    sink.printed.push_back(sink.numbers.number);
    if (second.receivedNew()) seconds.push_back(second.number);
  };
  EXPECT_TRUE(eventually([&] { return sink.printed.size() >= 20 && seconds.size() >= 20; },
                         [&] {
                           source.step();
                           sink.step();
                         }));
  for (std::size_t i = 1; i < seconds.size(); ++i) EXPECT_GT(seconds[i], seconds[i - 1]);
  EXPECT_EQ(source.wire.rejected() + sink.wire.rejected(), 0u);
}

TEST(Wire, ReadsPackagesOfAnotherVersionFieldByField) {
  const TestFolder folder;
  Source source{folder.endpoint("a")};
  Program program{"Sink"};
  Receiver<newer::NumberPackage> numbers{program.process, true};
  ASSERT_TRUE(program.wire.connect("Source", folder.endpoint("a")));
  program.wire.receive("Source", numbers);
  program.process.pause = 0;
  std::vector<double> printed;
  program.process.work = [&] {
    printed.push_back(numbers.number);
    EXPECT_EQ(numbers.more, 0.5) << "what is not sent is as the type has it at the beginning";
  };
  ASSERT_TRUE(eventually([&] { return printed.size() >= 5; },
                         [&] {
                           source.step();
                           program.step();
                         }));
  for (std::size_t i = 1; i < printed.size(); ++i) EXPECT_GT(printed[i], printed[i - 1]);
  EXPECT_EQ(printed.front(), std::floor(printed.front()));
  const auto news = program.wire.takeNews();
  ASSERT_EQ(news.size(), 1u) << "reported once";
  EXPECT_EQ(news[0],
            "'Source' was built from another version: its NumberPackage is read field by field");
  EXPECT_TRUE(program.wire.takeNews().empty());
}

namespace small {

/// The package as a version has it that allows small numbers only.
struct NumberPackage {
  int number = 7;

  static constexpr auto fields() { return Fields{field<&NumberPackage::number>({0, 9})}; }
};
static_assert(complete<NumberPackage>);

}  // namespace small

TEST(Wire, RefusesPackagesOfAnotherVersionThatItsTypeDoesNotAllow) {
  const TestFolder folder;
  Source source{folder.endpoint("a")};
  source.numbers.number = 100;  // beyond what the other version allows
  Program program{"Sink"};
  Receiver<small::NumberPackage> numbers{program.process, true};
  ASSERT_TRUE(program.wire.connect("Source", folder.endpoint("a")));
  program.wire.receive("Source", numbers);
  std::vector<std::string> news;
  ASSERT_TRUE(eventually([&] { return news.size() >= 2; },
                         [&] {
                           source.step();
                           program.step();
                           for (const std::string& line : program.wire.takeNews())
                             news.push_back(line);
                         }));
  EXPECT_NE(news[1].find("'Source' sends a NumberPackage that cannot be read:"), std::string::npos)
      << news[1];
  EXPECT_EQ(numbers.number, 7);
}

/// "Note that the communication does not involve any queuing."
TEST(Wire, SlowReceiverGetsTheNewestPackage) {
  const TestFolder folder;
  Source source{folder.endpoint("a")};
  Sink sink{folder.endpoint("a")};
  ASSERT_TRUE(eventually([&] { return sink.printed.size() >= 3; },
                         [&] {
                           source.step();
                           sink.step();
                         }));
  // The receiver's process waits for its time, and takes what comes meanwhile. Its clock counts
  // turns.
  sink.process.pause = 200;
  const int before = source.numbers.number;
  const std::size_t printed = sink.printed.size();
  Time turn{sink.network.elapsed()};
  ASSERT_TRUE(eventually([&] { return sink.printed.size() >= printed + 3; },
                         [&] {
                           source.step();
                           sink.stepAt(turn = turn + 1);
                         }));
  EXPECT_GT(sink.printed.back(), before + 100) << "no queue, which would give before + 3";
}

/// A blocking sender waits for all receivers, but not for those that have ended.
TEST(Wire, BlockingSenderWaitsForAllThatAreThere) {
  const TestFolder folder;
  Source source{folder.endpoint("a"), true};
  Sink fast{folder.endpoint("a"), "Fast"};
  auto slow = std::make_unique<Sink>(folder.endpoint("a"), "Slow");
  slow->process.work = nullptr;
  ASSERT_TRUE(eventually([&] { return fast.printed.size() >= 5; },
                         [&] {
                           source.step();
                           fast.step();
                           slow->step();
                         }));
  slow->process.work = [] {};
  slow->process.pause = 1'000'000;
  const auto both = [&] {
    source.step();
    fast.step();
    slow->wire.takeIn();
    slow->wire.askForMore();
  };
  // What was on its way arrives.
  std::size_t count = 0;
  int turns = 0;  // in which nothing came
  ASSERT_TRUE(eventually([&] { return turns > 200; },
                         [&] {
                           both();
                           slow->process.step(Time{slow->network.elapsed()});
                           turns = fast.printed.size() == count ? turns + 1 : 0;
                           count = fast.printed.size();
                         }));
  eventually([] { return false; }, both, std::chrono::milliseconds{200});
  EXPECT_EQ(fast.printed.size(), count) << "the slow one has not requested";
  slow.reset();
  EXPECT_TRUE(eventually([&] { return fast.printed.size() > count + 5; },
                         [&] {
                           source.step();
                           fast.step();
                         }));
}

TEST(Wire, ProcessesRejoinWhenStartedAgain) {
  const TestFolder folder;
  auto source = std::make_unique<Source>(folder.endpoint("a"));
  auto sink = std::make_unique<Sink>(folder.endpoint("a"));
  const auto both = [&] {
    source->step();
    sink->step();
  };
  ASSERT_TRUE(eventually([&] { return sink->printed.size() >= 3; }, both));
  const auto session = sink->wire.clockOf("Source").session;
  source.reset();
  source = std::make_unique<Source>(folder.endpoint("a"));
  sink->printed.clear();
  ASSERT_TRUE(eventually([&] { return sink->printed.size() >= 3; }, both));
  EXPECT_LT(sink->printed.front(), 100) << "of the new program";
  EXPECT_NE(sink->wire.clockOf("Source").session, session);
  sink.reset();
  sink = std::make_unique<Sink>(folder.endpoint("a"));
  EXPECT_TRUE(eventually([&] { return sink->printed.size() >= 3; }, both));
}

TEST(Wire, GarbageHarmsNobody) {
  const std::string endpoint = testing::freeTcpEndpoint();
  Source source{endpoint};
  Sink sink{endpoint};
  zmq::context_t context;
  zmq::socket_t enemy{context, zmq::socket_type::dealer};
  enemy.set(zmq::sockopt::linger, 0);
  enemy.connect(endpoint);
  std::string frame(Frame::headerSize, '\0');
  frame.replace(0, 4, std::string{'G', 'T', 2, 2});
  for (int i = 0; i < 300; ++i) {
    enemy.send(
        zmq::buffer(frame.substr(0, static_cast<std::size_t>(i) % (frame.size() + 1))),
        i % 3 ? zmq::send_flags::dontwait : zmq::send_flags::dontwait | zmq::send_flags::sndmore);
    source.step();
    sink.step();
  }
  sink.printed.clear();
  EXPECT_TRUE(eventually([&] { return sink.printed.size() >= 10; },
                         [&] {
                           source.step();
                           sink.step();
                         }));
}

TEST(Network, ListensBeyondThisMachineOnlyWithKeys) {
  Network network;
  EXPECT_FALSE(network.listen("tcp://*:0"));
  EXPECT_FALSE(network.listen("tcp://0.0.0.0:0"));
  EXPECT_TRUE(network.listen("tcp://127.0.0.1:0"));
  EXPECT_FALSE(network.listen("tcp://127.0.0.1:nonsense"));
  EXPECT_FALSE(network.connect("nonsense", "me"));
  EXPECT_TRUE(isLocal("ipc:///tmp/x"));
  EXPECT_FALSE(isLocal("tcp://10.0.1.100:15100"));
}

/// For what must not come.
constexpr std::chrono::milliseconds shortTime{600};

/// Who may connect, by keys of its own: true if a package came through.
bool comesThrough(const Keys& listening, const std::optional<Keys>& connecting,
                  std::chrono::milliseconds time) {
  Network here, there;
  const auto server = here.listen("tcp://127.0.0.1:0", listening);
  EXPECT_TRUE(server);
  const auto client = there.connect((*server)->endpoint(), "", connecting);
  EXPECT_TRUE(client);
  Received received;
  return eventually([&] { return (*server)->receive(received); },
                    [&] {
                      (*client)->send("", FrameKind::request, representation<NumberPackage>(),
                                      nullptr);
                      here.wait(0);
                    },
                    time);
}

TEST(Network, LetsInOnlyWhoHoldsTheKey) {
  const TestFolder folder;
  ASSERT_TRUE(makeKeys(folder.file("ours")));
  ASSERT_TRUE(makeKeys(folder.file("theirs")));
  const Keys robot = *loadKeys(folder.file("ours/robot.key"));
  const Keys tool = *loadKeys(folder.file("ours/tool.key"));
  EXPECT_TRUE(comesThrough(robot, tool, patience));
  EXPECT_FALSE(comesThrough(robot, std::nullopt, shortTime));
  Keys stranger = *loadKeys(folder.file("theirs/tool.key"));
  EXPECT_FALSE(comesThrough(robot, stranger, shortTime));
  stranger.serverPublic = tool.serverPublic;
  EXPECT_FALSE(comesThrough(robot, stranger, shortTime)) << "who knows the robot's public key only";
}

TEST(Network, TellsThatAKeyDoesNotFit) {
  const TestFolder folder;
  ASSERT_TRUE(makeKeys(folder.file("ours")));
  ASSERT_TRUE(makeKeys(folder.file("theirs")));
  Network here, there;
  const auto server = here.listen("tcp://127.0.0.1:0", *loadKeys(folder.file("ours/robot.key")));
  ASSERT_TRUE(server);
  const auto troubled = [&](const std::optional<Keys>& keys, std::chrono::milliseconds time) {
    const auto client = there.connect((*server)->endpoint(), "", keys);
    Received received;
    return eventually([&] { return !(*client)->trouble().empty(); },
                      [&] {
                        here.wait(0);
                        (*server)->receive(received);
                      },
                      time);
  };
  EXPECT_TRUE(troubled(std::nullopt, patience));
  Keys stranger = *loadKeys(folder.file("theirs/tool.key"));
  EXPECT_TRUE(troubled(stranger, patience));
  EXPECT_FALSE(troubled(*loadKeys(folder.file("ours/tool.key")), std::chrono::milliseconds{1500}));
}

/// Who waits in vain for another program reports that, once.
TEST(Wire, TellsWhoDoesNotAnswer) {
  const TestFolder folder;
  Sink sink{folder.endpoint("a")};
  std::vector<std::string> news;
  const auto step = [&] {
    sink.step();
    for (const std::string& line : sink.wire.takeNews()) news.push_back(line);
  };
  ASSERT_TRUE(eventually([&] { return !news.empty(); }, step));
  EXPECT_EQ(news[0], "'Source' does not answer at " + folder.endpoint("a"));
  EXPECT_FALSE(eventually([&] { return news.size() > 1; }, step, std::chrono::milliseconds{300}));
  Source source{folder.endpoint("a")};
  ASSERT_TRUE(eventually([&] { return news.size() > 1; },
                         [&] {
                           source.step();
                           step();
                         }));
  EXPECT_EQ(news[1], "'Source' answers now");
}

}  // namespace
}  // namespace gt
