#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "match/Match.h"
#include "network/ToolPort.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// A program that ends with the test, however that ends.
class Child {
 public:
  explicit Child(std::vector<std::string> command) : command_{std::move(command)} { start(); }
  ~Child() { kill(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void start() {
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    std::vector<char*> arguments;
    for (std::string& argument : command_) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  bool runs() {
    if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) != 0) pid_ = -1;
    return pid_ > 0;
  }
  void kill(int signal = SIGKILL) {
    if (pid_ <= 0) return;
    ::kill(pid_, signal);
    waitpid(pid_, &status_, 0);
    pid_ = -1;
  }
  int status() const { return status_; }

 private:
  std::vector<std::string> command_;
  pid_t pid_ = -1;
  int status_ = 0;
};

/// A match in real time in which red3 consists of three programs.
class RobotProgramsTest : public ::testing::Test {
 protected:
  RobotProgramsTest() {
    std::string path = (fs::temp_directory_path() / "gt2003-XXXXXX").string();
    folder = mkdtemp(path.data());
    MatchOptions options;
    options.remote = {"red3"};
    options.sockets = folder;
    auto made = Match::make(options);
    EXPECT_TRUE(made) << made.error().text();
    match = std::move(*made);
    for (const char* process : {"cognition", "motion", "debug"})
      processes.push_back(std::make_unique<Child>(std::vector<std::string>{
          std::string{GT_PROGRAMS "/gtrobot-"} + process, "--robot", "red3", "--team", "red",
          "--role", "striker1", "--sockets", folder, "--logs", folder}));
  }
  ~RobotProgramsTest() override {
    processes.clear();
    fs::remove_all(folder);
  }

  const RemoteRobot& robot() const { return *match->remoteRobots().front(); }
  /// Plays on for some ms.
  void play(std::int64_t ms) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::int64_t t = 8; t <= ms; t += 8) {
      match->step();
      std::this_thread::sleep_until(begin + std::chrono::milliseconds{t});
    }
  }
  /// Plays until something holds; false if it does not in some seconds.
  template <typename Condition>
  bool playUntil(Condition condition) {
    for (int i = 0; i < 200; ++i) {
      if (condition()) return true;
      play(48);
    }
    return false;
  }
  /// The robot answers in time, as far as a busy machine lets it.
  bool joined() {
    const RemoteStatistics before = robot().statistics();
    play(400);
    const RemoteStatistics& now = robot().statistics();
    return now.frames > before.frames && now.pictures > before.pictures &&
           now.missedFrames - before.missedFrames < 25 &&
           now.missedPictures - before.missedPictures < 5;
  }
  std::vector<fs::path> logs() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{folder})
      if (entry.path().extension() == ".mcap") files.push_back(entry.path());
    return files;
  }

  std::string folder;
  std::unique_ptr<Match> match;
  std::vector<std::unique_ptr<Child>> processes;
};

TEST_F(RobotProgramsTest, ARobotOfThreeProgramsPlaysInTheTeam) {
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  // In the ready state the robot walks to its place, knowing where it is.
  ASSERT_TRUE(playUntil([&] { return match->simulation().world().robot(2).walked > 100; }));
  const Vector2d truth = match->simulation().world().robot(2).pose.translation;
  EXPECT_LT((robot().pose()->pose.translation - truth).norm(), 500);
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
  ASSERT_TRUE(playUntil([&] { return robot().motion()->executed.type == MotionType::walk; }));
  processes[0]->kill();
  play(1500);  // requests grow old, and a step that was begun comes to its end
  EXPECT_EQ(robot().motion()->executed.type, MotionType::stand);
  const RemoteStatistics before = robot().statistics();
  const double walked = match->simulation().world().robot(2).walked;
  play(800);
  EXPECT_LT(robot().statistics().missedFrames - before.missedFrames, 50) << "it is still there";
  EXPECT_LT(match->simulation().world().robot(2).walked - walked, 30) << "and stands";
  processes[0]->start();
  EXPECT_TRUE(playUntil([&] { return joined(); }));
}

TEST_F(RobotProgramsTest, AToolReachesTheProcesses) {
  Network network;
  const auto tool = *ToolConnection::open(network, "ipc://" + folder + "/red3.Tools");
  MessageQueue messages;
  tool->out().write({}, WatchRequest{"WalkingEngineOutput", "", true});
  bool answered = false;
  EXPECT_TRUE(playUntil([&] {
    tool->update(messages);
    messages.handleAllMessages(
        [&](const Message& message) { answered |= message.id == hashOf("WalkingEngineOutput"); });
    messages.clear();
    return answered;
  }));
}

/// Kills each process at random moments; GT_KILLS says how often (3).
TEST_F(RobotProgramsTest, AnyProcessMayEndAtAnyMoment) {
  const char* wanted = std::getenv("GT_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 3;
  Random random{static_cast<std::uint64_t>(kills)};
  ASSERT_TRUE(playUntil([&] { return joined(); }));
  for (int i = 0; i < kills * 3; ++i) {
    const auto killed = static_cast<std::size_t>(i) % processes.size();
    play(8 + static_cast<std::int64_t>(random() % 400));
    processes[killed]->kill();
    play(8 + static_cast<std::int64_t>(random() % 400));
    for (std::size_t p = 0; p < processes.size(); ++p)
      ASSERT_EQ(processes[p]->runs(), p != killed) << "kill " << i;
    const std::size_t logsBefore = logs().size();
    processes[killed]->start();
    ASSERT_TRUE(playUntil([&] { return joined(); })) << "kill " << i;
    const std::size_t expected = logsBefore + (killed == 2 ? 1 : 0);
    EXPECT_TRUE(playUntil([&] { return logs().size() == expected; }));
  }
  play(1200);
  processes[2]->kill();
  std::size_t messages = 0;
  for (const fs::path& path : logs()) {
    auto log = McapReader::open(path.string());
    ASSERT_TRUE(log) << log.error().text();
    for (auto message = log->next(); message && *message; message = log->next()) ++messages;
  }
  EXPECT_EQ(logs().size(), static_cast<std::size_t>(kills) + 1);
  EXPECT_GT(messages, 100u);
}

}  // namespace
}  // namespace gt
