#include "match/LockstepRobot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <limits>
#include <set>
#include <thread>

namespace gt {
namespace {

constexpr std::chrono::minutes patience{1};
constexpr std::chrono::milliseconds impatience{100};  // for answers that never come

/// A robot's program that the test writes: what it sends first, and how it answers.
class LockstepRobotTest : public ::testing::Test {
 protected:
  explicit LockstepRobotTest(std::chrono::milliseconds waiting = patience) {
    int ends[2];
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    robot = std::make_unique<LockstepRobot>("red1", FileDescriptor{ends[0]}, waiting);
    program.emplace(FileDescriptor{ends[1]}, lockstepVocabulary(), lockstepQueueSize, patience);
    joints.angles[Joint::headPan] = 0.5;
  }
  template <typename... T>
  static MessageQueue queueOf(const T&... messages) {
    MessageQueue queue;
    (queue.write(Time{}, messages), ...);
    return queue;
  }
  /// The robot's greeting is answered by its first queue, which is empty.
  void greet() {
    MessageQueue messages{lockstepQueueSize};
    EXPECT_TRUE(program->introduce(
        queueOf(LockstepGreeting{lockstepProtocol, "abc", {"kick"}}, CameraSettings{})));
    const auto done = robot->greet();
    EXPECT_TRUE(done) << done.error().text();
    EXPECT_TRUE(program->receive(messages) && messages.empty());
  }
  std::string errorOfGreeting(const MessageQueue& messages) {
    EXPECT_TRUE(program->introduce(messages));
    const auto done = robot->greet();
    return done ? "" : done.error().text();
  }
  void cycle() {
    robot->cycle(input, output);
    robot->finish(output);
  }
  std::string failure() const { return robot->failure() ? robot->failure()->text() : ""; }

  std::unique_ptr<LockstepRobot> robot;
  std::optional<QueueStream> program;
  RobotInput input;
  RobotOutput output;
  JointData joints;
};

TEST_F(LockstepRobotTest, SendsWhatIsMeasuredAndTakesTheAnswerOfTheSameTick) {
  greet();
  EXPECT_EQ(robot->greeting().kicks, std::vector<std::string>{"kick"});
  input.now = Time{16};
  ASSERT_TRUE(program->send(queueOf(joints, BallModel{})));  // it is taken after the question
  cycle();
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(output.joints.angles[Joint::headPan], 0.5);
  EXPECT_TRUE(robot->belief().ball);
  EXPECT_FALSE(robot->belief().pose) << "it provides none";
  MessageQueue asked{lockstepQueueSize};
  ASSERT_TRUE(program->receive(asked));
  int messages = 0;
  asked.handleAllMessages([&](const Message& message) {
    EXPECT_TRUE(message.is<SensorDataBuffer>());
    EXPECT_EQ(message.time, Time{16});
    ++messages;
  });
  EXPECT_EQ(messages, 1) << "there is no image in this tick";
}

/// Another version's program would use whatever it gets.
TEST_F(LockstepRobotTest, SendsNoTruth) {
  greet();
  Image image;
  image.allocate();
  input.image = &image;
  ASSERT_TRUE(program->send(queueOf(joints)));
  cycle();
  MessageQueue asked{lockstepQueueSize};
  ASSERT_TRUE(program->receive(asked));
  std::set<std::uint32_t> sent;
  asked.handleAllMessages([&](const Message& message) { sent.insert(message.id); });
  EXPECT_TRUE(sent.contains(messageId<Image>()));
  EXPECT_FALSE(sent.contains(messageId<OracledWorldState>()));
}

TEST_F(LockstepRobotTest, SendsATeamMessageWithEachThirdImage) {
  greet();
  Image image;
  image.allocate();
  MessageQueue asked{lockstepQueueSize};
  std::vector<bool> sent;
  for (int i = 0; i < 7; ++i) {
    input.image = i == 4 ? nullptr : &image;
    ASSERT_TRUE(program->send(queueOf(joints, TeamMessage{})));
    output.message.reset();
    cycle();
    ASSERT_TRUE(program->receive(asked));
    sent.push_back(output.message.has_value());
  }
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(sent, (std::vector<bool>{false, false, true, false, false, false, true}));
}

TEST_F(LockstepRobotTest, StandsAsItStoodOnceItsProgramHasEnded) {
  greet();
  ASSERT_TRUE(program->send(queueOf(joints)));
  cycle();
  program.reset();
  cycle();
  EXPECT_EQ(failure(), "red1: its program has ended");
  cycle();
  EXPECT_EQ(output.joints.angles[Joint::headPan], 0.5);
}

class ImpatientLockstepRobotTest : public LockstepRobotTest {
 protected:
  ImpatientLockstepRobotTest() : LockstepRobotTest{impatience} {}
};

TEST_F(ImpatientLockstepRobotTest, DoesNotWaitForeverForAnAnswer) {
  greet();
  cycle();
  EXPECT_EQ(failure(), "red1: its program has not answered for 100 ms");
}

TEST_F(LockstepRobotTest, RefusesWhatNoBodyCanDo) {
  greet();
  joints.angles[Joint::headTilt] = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(program->send(queueOf(joints)));
  cycle();
  EXPECT_THAT(failure(), ::testing::StartsWith("red1: "));
  EXPECT_EQ(output.joints.angles[Joint::headTilt], 0);
}

TEST_F(LockstepRobotTest, RefusesAMessageOfOpponentsThatAreNowhere) {
  greet();
  TeamMessage message;
  message.opponents.back().position.x() = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(program->send(queueOf(joints, message)));
  cycle();
  EXPECT_THAT(failure(), ::testing::StartsWith("red1: "));
}

TEST_F(LockstepRobotTest, RefusesAnAnswerWithoutJoints) {
  greet();
  ASSERT_TRUE(program->send(queueOf(BallModel{})));
  cycle();
  EXPECT_EQ(failure(), "red1: its program commands no joints");
}

TEST_F(LockstepRobotTest, ReportsWhyAProgramCannotPlay) {
  const LockstepFailure failure{
      .file = "config/a.cfg", .line = 3, .column = 8, .element = "gain", .what = "is no number"};
  EXPECT_EQ(errorOfGreeting(queueOf(failure)), "config/a.cfg:3:8: gain: is no number");
}

TEST_F(LockstepRobotTest, RefusesAnotherProtocol) {
  EXPECT_EQ(errorOfGreeting(queueOf(LockstepGreeting{7, "abc", {}})),
            "red1: its program of commit 'abc' takes turns by protocol 7; this one by 1");
}

}  // namespace
}  // namespace gt
