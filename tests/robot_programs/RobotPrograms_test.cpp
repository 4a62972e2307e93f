#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <zmq.hpp>

#include "base/ChildProgram.h"
#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "framework/Requests.h"
#include "match/Match.h"
#include "network/ToolPort.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/BehaviorState.h"
#include "streams/mcap/Mcap.h"
#include "support/OtherMachine.h"
#include "support/ProgramFolder.h"
#include "support/RobotElsewhere.h"
#include "support/RobotOfPrograms.h"
#include "support/TestWire.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::freePort;

/// Tools that do a port all the harm they can, until they go: one that reads what the robot sends
/// and floods it, one that asks and never reads, and one that sends garbage.
class BadTools {
 public:
  explicit BadTools(const std::string& endpoint) : endpoint_{endpoint} {
    stalling_ = connect(1);
    flooding_ = connect(1000);
    sending_ = std::thread{[this] {
      for (int round = 0; !ended_; ++round) {
        attack(round);
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
      }
    }};
  }
  ~BadTools() {
    ended_ = true;
    sending_.join();
  }
  /// How many messages left.
  std::uint64_t sent() const { return sent_; }

 private:
  zmq::socket_t connect(int frames) {
    zmq::socket_t socket{context_, zmq::socket_type::dealer};
    socket.set(zmq::sockopt::linger, 0);
    socket.set(zmq::sockopt::sndhwm, frames);
    socket.set(zmq::sockopt::rcvhwm, frames);
    socket.connect(endpoint_);
    return socket;
  }
  void send(zmq::socket_t& socket, const Frame& frame, std::size_t size) {
    const auto header = frameHeader(frame);
    zmq::message_t message{header.size() + size};
    std::memset(message.data(), 0xa5, message.size());
    std::memcpy(message.data(), header.data(), header.size());
    if (socket.send(message, zmq::send_flags::dontwait)) ++sent_;
  }
  void attack(int round) {
    const std::uint32_t queue = representation<MessageQueue>().id;
    zmq::message_t ignored;
    while (flooding_.recv(ignored, zmq::recv_flags::dontwait)) continue;
    for (int i = 0; i < 20; ++i) {
      send(flooding_, {FrameKind::request, queue, 1, {}, {}}, 0);
      send(flooding_, {FrameKind::package, queue, 1, {}, {}}, 50'000);
      send(stalling_, {FrameKind::request, queue, 1, {}, {}}, 0);
    }
    // Each garbage comes from a new tool: a frame that is too large ends the connection.
    if (round % 20 == 0) garbage_ = connect(10);
    const std::string noise(static_cast<std::size_t>(round % 100), '\xff');
    if (garbage_.send(zmq::buffer(noise), zmq::send_flags::dontwait)) ++sent_;
    send(garbage_, {FrameKind::package, 0xdeadbeef, 1, {}, {}}, 100);
    if (round % 20 == 10) send(garbage_, {FrameKind::package, queue, 1, {}, {}}, 64'000'000);
  }

  std::string endpoint_;
  zmq::context_t context_;
  zmq::socket_t stalling_, flooding_, garbage_;
  std::atomic<std::uint64_t> sent_ = 0;
  std::atomic<bool> ended_ = false;
  std::thread sending_;
};

/// Tests of a robot of programs.
class RobotProgramsTest : public ::testing::Test, protected testing::RobotOfPrograms {
 protected:
  explicit RobotProgramsTest(const std::string& endpoint = "", const Keys* keys = nullptr)
      : RobotOfPrograms{endpoint, keys} {
    if (keys) return;
    for (const char* process : {"cognition", "motion", "debug"})
      processes.push_back(std::make_unique<ChildProgram>(command(process, folder)));
  }

  /// A tool gets what it asked for.
  bool answers(const std::string& endpoint) {
    Network network;
    const auto tool = *ToolConnection::open(network, endpoint);
    MessageQueue messages;
    tool->out().write({}, WatchRequest{"WalkingEngineOutput", ""});
    bool answered = false;
    return playUntil([&] {
      tool->update(messages);
      messages.handleAllMessages(
          [&](const Message& message) { answered |= message.id == hashOf("WalkingEngineOutput"); });
      messages.clear();
      return answered;
    });
  }
  /// Plays on; returns which share of the frames and of the images was without an answer in time.
  std::pair<double, double> missedWhilePlaying(std::int64_t ms) {
    const RemoteStatistics before = robot().statistics();
    play(ms);
    const RemoteStatistics& now = robot().statistics();
    const auto share = [](std::int64_t part, std::int64_t whole) {
      return static_cast<double>(part) / static_cast<double>(std::max<std::int64_t>(whole, 1));
    };
    return {share(now.missedFrames - before.missedFrames, now.frames - before.frames),
            share(now.missedPictures - before.missedPictures, now.pictures - before.pictures)};
  }
  /// Bad tools at an endpoint harm neither the robot nor its teammates nor a good tool there.
  void expectNoHarm(const std::string& endpoint, const std::vector<const ChildProgram*>& watched) {
    ASSERT_TRUE(playUntil([&] { return joined(); }));
    ASSERT_TRUE(answers(endpoint));
    std::vector<double> memory;
    for (const ChildProgram* child : watched) memory.push_back(child->memory());
    const auto heardOfIt = [&] {
      return match->simulation().input(3).team.byPlayer[2].timeReceived;
    };
    const Time heardBefore = heardOfIt();
    const std::int64_t framesBefore = robot().statistics().frames;
    // What others on this machine take from the robot is not the bad tools' doing.
    const auto [framesAlone, imagesAlone] = missedWhilePlaying(1500);
    const BadTools enemies{endpoint};
    const auto [frames, pictures] = missedWhilePlaying(3000);
    EXPECT_GT(enemies.sent(), 1000u);
    EXPECT_GT(robot().statistics().frames - framesBefore, 420);
    EXPECT_LT(frames, 0.5 + framesAlone) << framesAlone << " without bad tools";
    EXPECT_LT(pictures, 0.5 + imagesAlone) << imagesAlone << " without bad tools";
    EXPECT_TRUE(answers(endpoint)) << "a good tool beside the bad ones";
    for (const auto& process : processes) EXPECT_TRUE(process->runs());
    for (std::size_t i = 0; i < watched.size(); ++i)
      EXPECT_LT(watched[i]->memory() - memory[i], 150) << "MB more in program " << i;
    EXPECT_GT(heardOfIt().ms, heardBefore.ms) << "its team mates still hear of it";
  }
};

TEST_F(RobotProgramsTest, ARobotOfThreeProgramsPlaysInTheTeam) {
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  // In the ready state the robot walks to its place, knowing where it is.
  ASSERT_TRUE(playUntil([&] { return match->simulation().world().robot(2).walked > 100; }));
  const Vector2d truth = match->simulation().world().robot(2).pose.translation;
  EXPECT_LT((robot().belief().pose->pose.translation - truth).norm(), 500);
  ASSERT_TRUE(playUntil([&] {
    return match->simulation().input(3).team.byPlayer[2].timeReceived != never();
  })) << "its team mates hear of it";
  EXPECT_TRUE(
      playUntil([&] { return match->simulation().output(2).joints.angles[Joint::headPan] != 0; }));
  for (const auto& process : processes) {
    process->kill(SIGTERM);
    EXPECT_TRUE(WIFEXITED(process->status()) && WEXITSTATUS(process->status()) == 0);
  }
}

TEST_F(RobotProgramsTest, MotionHoldsASafeStandWithoutCognition) {
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  ASSERT_TRUE(
      playUntil([&] { return robot().belief().motion->executed.type == MotionType::walk; }));
  processes[0]->kill();
  const auto walked = [&] { return match->simulation().world().robot(2).walked; };
  // Requests grow old, and a step that was begun comes to its end.
  double stood = 0;
  ASSERT_TRUE(playUntil(
      [&] {
        const double before = std::exchange(stood, walked());
        return robot().belief().motion->executed.type == MotionType::stand && stood - before < 1;
      },
      400));
  const RemoteStatistics before = robot().statistics();
  play(800);
  const RemoteStatistics& now = robot().statistics();
  EXPECT_LT(now.missedFrames - before.missedFrames, now.frames - before.frames) << "it is there";
  EXPECT_LT(walked() - stood, 30) << "and stands";
  processes[0]->start();
  EXPECT_TRUE(playUntil([&] { return joined(); }));
}

/// A program reads only what its modules need.
TEST_F(RobotProgramsTest, ABrokenBehaviorStopsCognitionOnly) {
  auto words = command("motion", folder);
  words.insert(words.end(), {"--behavior", folder + "/broken.xabsl"});
  for (const auto& process : processes) process->kill();
  processes[1] = std::make_unique<ChildProgram>(words);
  ASSERT_TRUE(playUntil([&] { return robot().statistics().frames > 50; }));
  EXPECT_TRUE(processes[1]->runs());
  words[0] = programFolder() + "/gtrobot-cognition";
  processes[0] = std::make_unique<ChildProgram>(words);
  EXPECT_TRUE(playUntil([&] { return !processes[0]->runs(); }));
  EXPECT_EQ(WEXITSTATUS(processes[0]->status()), 2);
  EXPECT_TRUE(processes[1]->runs());
}

/// What a program prints until something is in it, or for a minute.
std::string printed(const std::vector<std::string>& words, const std::string& wanted) {
  const TemporaryFolder place;
  const std::string file = (place.path() / "printed").string();
  std::string line = "exec";
  for (const std::string& word : words) line += " " + word;
  ChildProgram program{{"/bin/sh", "-c", line + " 2>" + file}};
  std::string text;
  for (int i = 0; i < 600 && text.find(wanted) == text.npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    if (const auto read = readFile(file)) text = *read;
  }
  return text;
}

TEST(RobotPrograms, SayWhatIsWrongInALine) {
  const TemporaryFolder place;
  const std::string folder = place.path().string(), config = folder + "/config";
  const std::string waiting = "'Platform' does not answer at ipc://" + folder + "/robot.Platform";
  const std::string motion = programFolder() + "/gtrobot-motion",
                    debug = programFolder() + "/gtrobot-debug";
  EXPECT_THAT(printed({motion, "--sockets", folder, "--crashes", folder}, waiting),
              ::testing::HasSubstr("gtrobot Motion: " + waiting + "\n"));

  fs::copy("config", config, fs::copy_options::recursive);
  ASSERT_TRUE(writeFile(config + "/network.cfg", "tools 5\n"));
  EXPECT_THAT(printed({debug, "--config", config, "--crashes", folder}, "tools"),
              ::testing::HasSubstr("network.cfg: tools: network: 5: expected an endpoint"));
}

/// How many messages of a channel a log holds, up to what was written last.
std::size_t countIn(const fs::path& path, const std::string& topic) {
  auto log = McapReader::open(path.string());
  std::size_t count = 0;
  if (!log) return count;
  while (const auto message = log->next()) count += log->channel(message->channel)->topic == topic;
  return count;
}

TEST_F(RobotProgramsTest, ItsLogHoldsImagesAndWhatThePlatformTold) {
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  ASSERT_TRUE(playUntil([&] { return !logs().empty(); }));
  const fs::path log = logs().front();
  ASSERT_TRUE(playUntil([&] { return countIn(log, "/camera") >= 2; }, 500));
  processes[2]->kill(SIGTERM);
  EXPECT_LE(countIn(log, "/camera"),
            static_cast<std::size_t>(match->simulation().time().ms / 2000 + 1));
  EXPECT_GT(countIn(log, "/input/GameControlData"), 20u);
  EXPECT_GT(countIn(log, "/RobotPose"), 20u);
}

/// As an editor sends it: compiled and linked before the old behavior ends.
TEST_F(RobotProgramsTest, ABehaviorIsEditedWhileItRuns) {
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  Network network;
  const auto tool = *ToolConnection::open(network, tools);
  std::string received;
  const auto hears = [&](const std::string& text) {
    return playUntil([&] {
      MessageQueue messages;
      tool->update(messages);
      messages.handleAllMessages([&](const Message& message) {
        RequestAnswer answer;
        if (message.is<RequestAnswer>() && message.read(answer) && !answer.what.empty())
          received += answer.what + "\n";
        BehaviorState state;
        if (message.is<BehaviorState>() && message.read(state)) received += toString(state);
      });
      return received.find(text) != received.npos;
    });
  };
  const std::string edited =
      "namespace s(\"\") { behavior getup {} } agent a(\"\", lie);"
      "option lie { initial state wait { action { getup(); } } }";
  tool->out().write({}, DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0});
  EXPECT_TRUE(hears("play_soccer()"));
  tool->out().write({}, BehaviorRequest{"wrong.xabsl", {{"wrong.xabsl", "option play {"}}});
  EXPECT_TRUE(hears("wrong.xabsl"));
  tool->out().write({}, BehaviorRequest{"edited.xabsl", {{"edited.xabsl", edited}}});
  EXPECT_TRUE(hears("lie()")) << received.substr(0, 500);
  for (const auto& process : processes) EXPECT_TRUE(process->runs());
}

/// What has to be there before the match: another machine, the keys of two who know each other, and
/// those of a stranger.
struct OtherMachineSetup {
  OtherMachineSetup() {
    EXPECT_TRUE(makeKeys(keys + "/ours"));
    EXPECT_TRUE(makeKeys(keys + "/theirs"));
    listening = *loadKeys(keys + "/ours/robot.key");
  }
  const TemporaryFolder keyFolder;
  const std::string keys = keyFolder.path().string();
  Keys listening;
  const testing::OtherMachine other;
  const std::string endpoint = "tcp://" + other.here() + ":" + std::to_string(freePort());
};

class OtherMachineTest : private OtherMachineSetup, public RobotProgramsTest {
 protected:
  OtherMachineTest() : RobotProgramsTest{endpoint, &listening} {}
  /// Starts the robot's programs on the other machine.
  void start(const std::string& key) {
    processes.clear();
    for (const char* process : {"cognition", "motion", "debug"}) {
      auto words = command(process, folder + "/there");
      words.insert(words.end(), {"--at", "Platform=" + endpoint, "--connect-keys",
                                 keys + "/" + key + "/tool.key"});
      processes.push_back(std::make_unique<ChildProgram>(other.command(words)));
    }
  }
};

TEST_F(OtherMachineTest, ARobotOnAnotherMachinePlaysInTheTeamIfItHoldsTheKey) {
  start("theirs");
  play(1500);
  EXPECT_EQ(robot().statistics().frames, 0) << "a stranger";
  start("ours");
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  ASSERT_TRUE(playUntil([&] { return match->simulation().world().robot(2).walked > 100; }));
  const auto pictures = [&] {
    std::size_t count = 0;
    for (const fs::path& log : logs()) count += countIn(log, "/camera");
    return count;
  };
  EXPECT_TRUE(playUntil([&] { return pictures() >= 2; }, 500));
}

/// All of the robot, its body too, on another machine: a tool of this one reaches it with a key
/// only.
TEST(RobotElsewhere, AnswersAToolOfThisMachineThatHoldsTheKey) {
  const testing::RobotElsewhere robot{programFolder()};
  ASSERT_TRUE(robot.made());
  Network network;
  const auto tool = *ToolConnection::open(network, robot.endpoint(), *loadKeys(robot.key()));
  const auto stranger = *ToolConnection::open(network, robot.endpoint());
  tool->out().write({}, WatchRequest{"JointData", ""});
  bool answered = false;
  MessageQueue messages, none;
  EXPECT_TRUE(testing::eventually([&] { return answered; },
                                  [&] {
                                    network.wait(10);
                                    tool->update(messages);
                                    stranger->update(none);
                                    messages.handleAllMessages([&](const Message& message) {
                                      answered |= message.id == hashOf("JointData");
                                    });
                                    messages.clear();
                                  }));
  EXPECT_FALSE(stranger->connected());
}

TEST_F(RobotProgramsTest, AToolReachesTheProcesses) {
  EXPECT_TRUE(answers(tools));
}

TEST_F(RobotProgramsTest, BadToolsHarmNoRobot) {
  const std::string endpoint = testing::freeTcpEndpoint();
  std::vector<std::string> debug = command("debug", folder);
  debug.insert(debug.end(), {"--tools", endpoint});
  processes[2].reset();  // two at once would be in each other's way
  processes[2] = std::make_unique<ChildProgram>(debug);
  expectNoHarm(endpoint, {processes[0].get(), processes[1].get(), processes[2].get()});
}

TEST_F(RobotProgramsTest, BadToolsAtTheRouterHarmNoRobot) {
  const int port = freePort();
  // Tools of a robot with a name connect to the router's port + 301.
  ChildProgram router{
      {programFolder() + "/router", "red3=" + tools, "--port", std::to_string(port - 301)}};
  expectNoHarm("tcp://127.0.0.1:" + std::to_string(port), {processes[2].get(), &router});
  EXPECT_TRUE(router.runs());
}

}  // namespace
}  // namespace gt
