// What a robot of programs survives, and how long it takes until all plays again. GT_FAULTS sets
// how many faults of each kind there are (1); with it the limits are strict, without it they are
// those of a busy machine.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "chaos/Cable.h"
#include "chaos/ChaosReport.h"
#include "chaos/Strangers.h"
#include "framework/RepresentationDefinition.h"
#include "framework/Requests.h"
#include "network/ToolPort.h"
#include "streams/mcap/Mcap.h"
#include "support/ProgramFolder.h"
#include "support/RobotOfPrograms.h"
#include "support/TestViewer.h"
#include "support/TestWire.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::Cable;
using testing::freePort;

int faultsOfAKind() {
  const char* wanted = std::getenv("GT_FAULTS");
  return wanted ? std::atoi(wanted) : 1;
}
/// Until all plays again, in s.
double patience() {
  return std::getenv("GT_FAULTS") ? 2 : 30;
}
/// What a log may lack before a fault, in s: it is written once a second, and not faster than the
/// machine lets it.
double inFlight() {
  return std::getenv("GT_FAULTS") ? 1.2 : 10;
}
/// Another log is begun after a second at most, and holds something after one more, in ms.
constexpr std::int64_t afterLog = 2200;

ChaosReport& report() {
  static ChaosReport all;
  return all;
}

/// Reads a log to its last whole chunk; returns the times (s) of what the platform sent.
std::vector<double> readLog(const fs::path& path, ChaosOutcome& outcome) {
  std::vector<double> times;
  auto log = McapReader::open(path.string());
  if (!log) {
    ADD_FAILURE() << log.error().text();
    return times;
  }
  ++outcome.logs;
  const std::size_t damaged = log->damage().size();
  while (const auto message = log->next()) {
    ++outcome.messages;
    if (log->channel(message->channel)->topic.starts_with("/input/"))
      times.push_back(static_cast<double>(message->time) / 1e9);
  }
  EXPECT_EQ(log->damage().size(), damaged) << log->damage().back().text();
  return times;
}

/// A robot of three programs, and a router to which its tools connect.
class ChaosTest : public ::testing::Test, protected testing::RobotOfPrograms {
 protected:
  explicit ChaosTest(const std::string& endpoint = "", const Keys* keys = nullptr)
      : RobotOfPrograms{endpoint, keys} {
    if (keys) return;
    start("cognition", {});
    start("motion", {});
    start("debug", {"--tools", at(toolPort)});
    startRouter(at(toolPort), {});
  }

  static std::string at(int port) { return "tcp://127.0.0.1:" + std::to_string(port); }
  void start(const std::string& process, const std::vector<std::string>& more) {
    auto words = command(process, folder);
    words.insert(words.end(), {"--crashes", folder});
    words.insert(words.end(), more.begin(), more.end());
    processes.push_back(std::make_unique<ChildProgram>(words));
  }
  void startRouter(const std::string& debug, const std::vector<std::string>& more) {
    const std::string program = programFolder() + "/router";
    // Tools of a robot with a name connect to the router's port + 301.
    std::vector<std::string> words{program,      "red3=" + debug,
                                   "--port",     std::to_string(routerPort - 301),
                                   "--foxglove", std::to_string(viewerPort)};
    words.insert(words.end(), more.begin(), more.end());
    processes.push_back(std::make_unique<ChildProgram>(words));
  }
  /// Each in turn, Debug first, which records the log.
  ChildProgram& nextProcess() { return *processes[++turn % processes.size()]; }
  double now() const { return static_cast<double>(match->time().ms) / 1000; }

  /// Plays until joints and team get commands again, and a tool at the router gets what Motion and
  /// Cognition have made since; returns how long that took, in s.
  double playAgain() {
    using Clock = std::chrono::steady_clock;
    constexpr double longest = 40;
    constexpr int ticksOfALook = 15;
    const auto begin = Clock::now();
    const Time since = match->time();
    Network network;
    const auto tool = *ToolConnection::open(network, at(routerPort));
    MessageQueue messages;
    bool walking = false, located = false, seen = false;
    double elapsed = 0;
    while (elapsed < longest) {
      if (!walking) tool->out().write({}, WatchRequest{"WalkingEngineOutput", ""});
      if (!located) tool->out().write({}, WatchRequest{"RobotPose", ""});
      const RemoteStatistics before = robot().statistics();
      for (int i = 0; i < ticksOfALook; ++i) {
        play(8);
        tool->update(messages);
      }
      messages.handleAllMessages([&](const Message& message) {
        if (message.time < since) return;
        walking |= message.id == hashOf("WalkingEngineOutput");
        located |= message.id == hashOf("RobotPose");
      });
      messages.clear();
      if (!seen)
        seen = testing::TestViewer::connect(static_cast<std::uint16_t>(viewerPort)).has_value();
      const RemoteStatistics& after = robot().statistics();
      elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
      const bool plays =
          2 * (after.missedFrames - before.missedFrames) < ticksOfALook &&
          after.pictures - after.missedPictures > before.pictures - before.missedPictures;
      if (plays && walking && located && seen) return elapsed;
    }
    ADD_FAILURE() << "does not play again: commands " << robot().statistics().frames
                  << ", Motion's messages " << walking << ", Cognition's " << located
                  << ", viewers " << seen;
    return elapsed;
  }

  /// Suffers a fault again and again, and reads the logs in the end. Programs that end are started
  /// again, as on a robot.
  template <typename Fault>
  void suffer(const std::string& kind, Fault fault) {
    ChaosOutcome& outcome = report().add(kind);
    std::vector<std::pair<double, double>> times;
    playAgain();
    logsBegin = now();
    play(200);
    for (int i = 0; i < faultsOfAKind(); ++i) {
      play(between + static_cast<std::int64_t>(random.index(400)));
      const RemoteStatistics before = robot().statistics();
      const double begin = now();
      fault(i);
      for (const auto& process : processes)
        if (!process->runs()) process->start();
      times.emplace_back(begin, now());
      outcome.again.push_back(playAgain());
      EXPECT_LT(outcome.again.back(), patience()) << kind << ", fault " << i;
      const RemoteStatistics& after = robot().statistics();
      outcome.commands += static_cast<double>(after.missedFrames - before.missedFrames) * 0.008;
      outcome.images += after.missedPictures - before.missedPictures;
    }
    play(between);
    processes[2]->kill(SIGTERM);
    readLogs(times, outcome);
  }
  void readLogs(const std::vector<std::pair<double, double>>& faults, ChaosOutcome& outcome) {
    std::vector<double> times;
    for (const fs::path& log : logs()) {
      const auto more = readLog(log, outcome);
      times.insert(times.end(), more.begin(), more.end());
    }
    std::ranges::sort(times);
    if (!keepsLogs) return;
    ASSERT_FALSE(times.empty());
    for (const auto& [begin, end] : faults) {
      const auto after = std::ranges::lower_bound(times, end);
      ASSERT_NE(after, times.end()) << "the log does not go on after " << end << " s";
      EXPECT_LT(*after - end, patience());
      outcome.gaps.push_back(*after - end);
      const auto next = std::ranges::upper_bound(times, begin);
      const double before = begin - (next == times.begin() ? logsBegin : *std::prev(next));
      EXPECT_LT(before, inFlight()) << "the log was lost before " << begin << " s";
      outcome.gaps.back() += before;
    }
  }
  std::vector<fs::path> logs() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{logFolder})
      if (entry.path().extension() == ".mcap") files.push_back(entry.path());
    return files;
  }

  Random random{7};
  std::string logFolder = folder;
  bool keepsLogs = true;       ///< Whether no fault destroys a log.
  std::int64_t between = 100;  ///< Faults, at least, in ms.
  double logsBegin = 0;        ///< s
  std::size_t turn = 1;
  const int toolPort = freePort(), routerPort = freePort(), viewerPort = freePort();
};

TEST_F(ChaosTest, ProgramsAreKilled) {
  suffer("killed", [&](int) {
    ChildProgram& killed = nextProcess();
    killed.kill();
    play(8 + static_cast<std::int64_t>(random.index(400)));
  });
}

TEST_F(ChaosTest, ProgramsAreStopped) {
  suffer("stopped for 0.1 to 3 s", [&](int) {
    const pid_t stopped = nextProcess().id();
    kill(stopped, SIGSTOP);
    play(100 + static_cast<std::int64_t>(random.index(2900)));
    kill(stopped, SIGCONT);
  });
}

TEST_F(ChaosTest, ProgramsAreSlowed) {
  suffer("slowed to a sixth for 1 s", [&](int) {
    const pid_t slowed = nextProcess().id();
    for (int i = 0; i < 21; ++i) {
      kill(slowed, SIGSTOP);
      play(40);
      kill(slowed, SIGCONT);
      play(8);
    }
  });
}

/// A program that needs more memory than it may have ends, and is started again. On a busy machine
/// not always: once it did not play again within 40 s, why is not known.
TEST_F(ChaosTest, MemoryIsLimited) {
  if (!std::getenv("GT_FAULTS")) GTEST_SKIP() << "only with GT_FAULTS";
  suffer("no more memory for 0.5 s", [&](int) {
    const pid_t limited = nextProcess().id();
    std::ifstream file{"/proc/" + std::to_string(limited) + "/statm"};
    rlim_t pages = 0;
    file >> pages;
    const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)), RLIM_INFINITY};
    ASSERT_EQ(prlimit(limited, RLIMIT_AS, &limit, nullptr), 0);
    // Who connects needs memory, and so does what it asks for.
    Network network;
    const auto tool = *ToolConnection::open(network, at(routerPort));
    tool->out().write({}, WatchRequest{"Image", ""});
    MessageQueue images;
    for (int i = 0; i < 60; ++i) {
      play(8);
      tool->update(images);
      images.clear();
    }
    tool->out().write({}, WatchRequest{"Image", "", DebugKeyMode::disabled});
    tool->update(images);
    const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
    prlimit(limited, RLIMIT_AS, &none, nullptr);
  });
}

/// The log lies on a disk of its own, which another program fills.
TEST_F(ChaosTest, TheDiskIsFull) {
  const std::string disk = folder + "/disk";
  fs::create_directory(disk);
  auto words = command("debug", folder);
  words.back() = disk;
  std::string line = "mount -t tmpfs -o size=64m none " + disk + " && exec";
  for (const std::string& word : words) line += " " + word;
  line += " --crashes " + folder + " --tools " + at(toolPort);
  processes[2].reset();  // two at once would be in each other's way
  processes[2] = std::make_unique<ChildProgram>(std::vector<std::string>{
      "/usr/bin/unshare", geteuid() == 0 ? "-m" : "-Urm", "/bin/sh", "-c", line});
  // An open file keeps the disk after the program's end.
  FileDescriptor kept;
  const std::string seen = "/proc/" + std::to_string(processes[2]->id()) + "/root" + disk;
  playUntil([&] { return fs::exists(seen + "/red3.mcap") || !processes[2]->runs(); });
  if (!processes[2]->runs()) GTEST_SKIP() << "no disk can be mounted here";
  kept = FileDescriptor{open(seen.c_str(), O_PATH | O_CLOEXEC)};
  logFolder = "/proc/self/fd/" + std::to_string(kept.number());
  between = afterLog;
  suffer("disk full for 1.5 to 3 s", [&](int) {
    const std::string filler = logFolder + "/filler";
    {
      std::ofstream file{filler, std::ios::binary};
      const std::string block(4096, 'x');
      while (file.write(block.data(), 4096).flush()) continue;
    }
    play(1500 + static_cast<std::int64_t>(random.index(1500)));
    fs::remove(filler);
  });
}

TEST_F(ChaosTest, LogsAreTruncatedWhileTheyAreWritten) {
  keepsLogs = false;
  between = afterLog;
  std::vector<std::pair<fs::path, std::size_t>> cut;
  const auto messagesOf = [](const fs::path& log) {
    ChaosOutcome read;
    readLog(log, read);
    return read.messages;
  };
  suffer("log truncated", [&](int) {
    const auto files = logs();
    EXPECT_EQ(files.size(), cut.size() + 1) << "the log did not go on";
    const fs::path log = *std::ranges::max_element(
        files, {}, [](const fs::path& file) { return fs::last_write_time(file); });
    EXPECT_TRUE(
        playUntil([&] { return McapReader::open(log.string()) && messagesOf(log) > 0; }, 200))
        << log;
    constexpr std::uintmax_t header = 100;  // without it, it is no log
    fs::resize_file(log, header + random.index(fs::file_size(log) - header));
    cut.emplace_back(log, messagesOf(log));
  });
  for (const auto& [log, messages] : cut) EXPECT_EQ(messagesOf(log), messages) << log;
}

/// Thousands of connections to each port and socket on which the robot or its router listens.
TEST_F(ChaosTest, StrangersConnectByTheThousand) {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  for (const auto& process : processes) {
    const rlimit usual{1024, files.rlim_max};
    ASSERT_EQ(prlimit(process->id(), RLIMIT_NOFILE, &usual, nullptr), 0);
  }
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
  std::vector<std::vector<FileDescriptor>> strangers;
  suffer("2000 connections each", [&](int) {
    strangers.clear();
    for (const int port : {toolPort, routerPort, viewerPort})
      strangers.push_back(connectMany(port));
    for (const char* process : {"/red3.Cognition", "/red3.Motion", "/red3.Debug"})
      strangers.push_back(connectMany(folder + process));
    play(300);  // they stay while all has to play again
  });
}

namespace newer {

/// The request as another version of Cognition sends it.
struct MotionRequest {
  double more = 0.5;
  Time time;
  Pose2D walk;
  MotionType type = MotionType::walk;

  static constexpr auto fields() {
    return Fields{field<&MotionRequest::more>(), field<&MotionRequest::time>(),
                  field<&MotionRequest::walk>(), field<&MotionRequest::type>()};
  }
};
static_assert(complete<MotionRequest>);

/// As another version of a tool asks.
struct WatchRequest {
  int more = 5;
  std::string representation;

  static constexpr auto fields() {
    return Fields{field<&WatchRequest::more>(), field<&WatchRequest::representation>()};
  }
};
static_assert(complete<WatchRequest>);

}  // namespace newer

TEST_F(ChaosTest, ProgramsAreOfAnotherVersion) {
  const Vocabulary vocabulary{{&representation<newer::WatchRequest>()}};
  suffer("Cognition and a tool of another version", [&](int) {
    processes[0]->kill();
    Network network;
    Wire wire{network, "Cognition"};
    ASSERT_TRUE(wire.listen("ipc://" + folder + "/red3.Cognition"));
    testing::Custom process{"Cognition"};
    Sender<newer::MotionRequest> request{process};
    wire.provide(request);
    process.work = [&] {
      request.time = match->time();
      request.walk = {0, {100, 0}};
      request.send();
    };
    const auto tool = *ToolConnection::open(network, at(toolPort), {}, &vocabulary);
    MessageQueue messages;
    for (int i = 0; i < 100; ++i) {
      play(8);
      network.wait(0);
      wire.takeIn();
      process.step(match->time());
      wire.askForMore();
      tool->out().write({}, newer::WatchRequest{5, "RobotPose"});
      tool->update(messages);
      messages.clear();
    }
    EXPECT_EQ(robot().belief().motion->executed.type, MotionType::walk) << "read field by field";
  });
}

/// What has to be there before the match.
struct ElsewhereSetup {
  ElsewhereSetup() {
    EXPECT_TRUE(makeKeys(keyFolder.path().string()));
    listening = *loadKeys(key("robot"));
  }
  std::string key(const std::string& name) const {
    return (keyFolder.path() / (name + ".key")).string();
  }
  const TemporaryFolder keyFolder;
  Keys listening;
  Cable cable;
  const std::string endpoint = "tcp://" + cable.here() + ":" + std::to_string(freePort());
};

/// The robot's programs are on another machine.
class NetworkChaosTest : private ElsewhereSetup, public ChaosTest {
 protected:
  NetworkChaosTest()
      : ChaosTest{cable.works() ? endpoint : "", cable.works() ? &listening : nullptr} {
    if (!cable.works()) return;
    between = 1000;  // what was on its way arrives
    const std::string debug = "tcp://" + cable.there() + ":15000";
    for (const char* process : {"cognition", "motion", "debug"}) {
      auto words = command(process, folder + "/there");
      words.insert(words.end(), {"--at", "Platform=" + endpoint, "--crashes", folder,
                                 "--connect-keys", key("tool")});
      if (std::string{process} == "debug")
        words.insert(words.end(), {"--tools", debug, "--keys", key("robot")});
      processes.push_back(std::make_unique<ChildProgram>(cable.command(words)));
    }
    startRouter(debug, {"--connect-keys", key("tool")});
  }
  void SetUp() override {
    if (!std::getenv("GT_FAULTS")) GTEST_SKIP() << "only with GT_FAULTS";
    if (!cable.works()) GTEST_SKIP() << "no network namespace can be made here";
  }
  void sufferFromCable(const std::string& kind, const Cable::Fault& fault, std::int64_t shortest,
                       std::uint64_t more) {
    suffer(kind, [&](int) {
      cable.set(fault);
      play(shortest + static_cast<std::int64_t>(random.index(more)));
      cable.set({});
    });
  }
};

TEST_F(NetworkChaosTest, TheNetworkIsCut) {
  sufferFromCable("network cut for 0.2 to 5 s", {.lost = 1}, 200, 4800);
}

TEST_F(NetworkChaosTest, TheNetworkLosesPackets) {
  sufferFromCable("a tenth of packets lost, 2 s", {.lost = 0.1}, 2000, 1);
}

TEST_F(NetworkChaosTest, TheNetworkIsDelayed) {
  using std::chrono::milliseconds;
  sufferFromCable("packets 100 to 300 ms late, 2 s",
                  {.delay = milliseconds{100}, .jitter = milliseconds{200}}, 2000, 1);
}

TEST_F(NetworkChaosTest, TheNetworkDuplicatesPackets) {
  sufferFromCable("half of packets doubled, 2 s",
                  {.jitter = std::chrono::milliseconds{5}, .duplicated = 0.5}, 2000, 1);
}

}  // namespace
}  // namespace gt
