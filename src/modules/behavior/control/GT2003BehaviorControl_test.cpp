#include "modules/behavior/control/GT2003BehaviorControl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "motionnet/Compiler.h"
#include "representations/behavior/BehaviorTrace.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace gt {
namespace {

/// The special actions of a folder by name, and where they play the ball.
MotionNet kicksIn(const std::string& folder) {
  const motionnet::Rules anyAngle{std::vector<motionnet::JointRule>(
      MotionNet::jointCount, motionnet::JointRule{"joint", -10000, 10000})};
  const auto compilation = motionnet::compileFolder(folder, anyAngle);
  EXPECT_TRUE(compilation) << compilation.errors.front().text();
  MotionNet net;
  for (const auto& from : compilation.net.motions) {
    auto& motion = net.motions.emplace_back(MotionNet::Motion{from.name, {}});
    if (!from.kick) continue;
    motion.kick.x = from.kick->x;
    motion.kick.y = from.kick->y;
    motion.kick.direction = from.kick->direction;
    for (const auto& [nearest, farthest, rightmost, leftmost, spread] : from.kick->reach)
      motion.kick.reach.push_back(
          {1. * nearest, 1. * farthest, 1. * rightmost, 1. * leftmost, 1. * spread});
  }
  net.motions[0].name.clear();
  return net;
}

/// The behavior in behavior/, linked with the module and run on made-up worlds.
class GT2003BehaviorControlTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto compilation = xabsl::compile("behavior/GT2003.xabsl");
    for (const auto& diagnostic : compilation.diagnostics) ADD_FAILURE() << toString(diagnostic);
    behavior = new Behavior{compilation.behavior};
  }
  static void TearDownTestSuite() { delete behavior; }

  void cycle(int ms = 40) {
    frame.time = frame.time + ms;
    control.update(frame, *behavior, {}, player, field, game, self, ball, teamBall, obstacles,
                   players, body, team, motion, motions, motionRequest, headControlMode, ledRequest,
                   message, debug);
  }
  void seeBall(const Vector2d& position) {
    ball.position = position;
    ball.lastSeen = teamBall.lastSeen = frame.time + 40;
    teamBall.position = self.pose * position;
  }

  static Behavior* behavior;
  GT2003BehaviorControl control;
  FrameInfo frame{{10000}};
  Player player{TeamColor::red, PlayerRole::striker1};
  FieldDimensions field;
  GameControlData game;
  RobotPose self{{0, -1000, 0}, 1};
  BallModel ball;
  TeamBallModel teamBall;
  ObstaclesModel obstacles;
  PlayersCollection players;
  RobotState body;
  TeamMessages team;
  MotionInfo motion;
  MotionNet motions = kicksIn("motions");
  MotionRequest motionRequest;
  HeadControlMode headControlMode;
  LedRequest ledRequest;
  BehaviorTeamMessage message;
  Debug debug;
};
Behavior* GT2003BehaviorControlTest::behavior = nullptr;

TEST_F(GT2003BehaviorControlTest, BehaviorLinksWithTheModule) {
  auto creation = xabsl::Engine::create(*behavior->compiled, control.symbols(motions));
  for (const auto& diagnostic : creation.diagnostics) ADD_FAILURE() << toString(diagnostic);
  EXPECT_TRUE(creation.engine);
}

TEST_F(GT2003BehaviorControlTest, KeepsItsBehaviorWhereANewOneDoesNotLink) {
  const auto run = [&](const std::string& text) {
    const Behavior edited{xabsl::compile("a.xabsl", {{"a.xabsl", text}}).behavior};
    ASSERT_TRUE(edited.compiled);
    frame.time = frame.time + 40;
    control.update(frame, edited, {}, player, field, game, self, ball, teamBall, obstacles, players,
                   body, team, motion, motions, motionRequest, headControlMode, ledRequest, message,
                   debug);
  };
  const auto calling = [](const std::string& name) {
    return "namespace skills(\"Skills\") { behavior " + name + " { } }" +
           "option play { initial state " + name + " { action { " + name + "(); } } }" +
           "agent player(\"Player\", play);";
  };
  cycle();
  const xabsl::Model* old = &control.engine()->model();
  for (int i = 0; i < 3; ++i) {
    run(calling("fly"));
    EXPECT_EQ(&control.engine()->model(), old);
  }
  run(calling("getup"));
  EXPECT_EQ(control.engine()->activations().back().name, "getup");
  EXPECT_EQ(motionRequest.type, MotionType::getup);
}

TEST_F(GT2003BehaviorControlTest, TellsWhatItDecidedWhileTheKeyIsActive) {
  const auto traced = [&] {
    std::string text;
    debug.out().handleAllMessages([&](const Message& sent) {
      BehaviorTrace part;
      if (sent.is<BehaviorTrace>() && sent.read(part)) text += part.text;
    });
    debug.out().clear();
    return text;
  };
  cycle();
  EXPECT_EQ(traced(), "");
  debug.keys().set(*DebugKey::find("BehaviorControl/trace"), {DebugKeyMode::always, 0});
  cycle();
  body.state = BodyState::fallen;
  cycle();
  const auto reading = xabsl::readTraces("trace", traced());
  ASSERT_EQ(reading.traces.size(), 1u);
  std::string text;
  xabsl::forEachCycle(reading.traces[0].events, [&](const auto* first, const auto* last) {
    text += xabsl::printCycle(reading.traces[0].subject, first, last);
  });
  EXPECT_THAT(text,
              ::testing::HasSubstr("play_soccer(): wait -> get_up\n"
                                   "      yes: body.fallen  (behavior/options/play_soccer.xabsl:"));
}

TEST_F(GT2003BehaviorControlTest, StandsUntilTheGameBegins) {
  for (const GameState state :
       {GameState::initial, GameState::set, GameState::penalized, GameState::finished}) {
    game.state = state;
    seeBall({300, 0});
    cycle();
    EXPECT_EQ(motionRequest.type, MotionType::stand) << enumName(state);
  }
}

TEST_F(GT2003BehaviorControlTest, WalksToItsKickOffPosition) {
  game.state = GameState::ready;
  game.kickOff = KickOff::opponent;
  for (int i = 0; i < 2000; ++i) {
    cycle();
    if (motionRequest.type == MotionType::walk)
      self.pose = self.pose *
                  Pose2D{motionRequest.walk.rotation * 0.04, motionRequest.walk.translation * 0.04};
  }
  EXPECT_EQ(motionRequest.type, MotionType::stand);
  EXPECT_NEAR((self.pose.translation - Vector2d{-650, 0}).norm(), 0, 100);
}

TEST_F(GT2003BehaviorControlTest, GetsUpAfterAFall) {
  game.state = GameState::playing;
  body.state = BodyState::fallen;
  cycle();
  EXPECT_EQ(motionRequest.type, MotionType::getup);
}

TEST_F(GT2003BehaviorControlTest, GoesBehindTheBallAndKicksIt) {
  // A perfect robot and a ball that lies still: from everywhere around, the kick must come, and
  // towards the goal.
  game.state = GameState::playing;
  const Vector2d ballOnField{300, 200};
  for (double angle = -3; angle < 3; angle += 0.5) {
    self.pose = {angle, ballOnField + direction(angle * 2) * 700};
    bool kicked = false;
    for (int i = 0; i < 1000 && !kicked; ++i) {
      seeBall(relative(self.pose, ballOnField));
      cycle();
      kicked = motionRequest.type == MotionType::specialAction;
      if (motionRequest.type == MotionType::walk)
        self.pose = self.pose * Pose2D{motionRequest.walk.rotation * 0.04,
                                       motionRequest.walk.translation * 0.04};
      EXPECT_GT((self.pose.translation - ballOnField).norm(), 90) << "must not run the ball over";
    }
    EXPECT_TRUE(kicked) << "from angle " << angle;
    if (motionRequest.specialAction == "chestKick") {
      EXPECT_LT(std::abs(normalize(angleOf(Vector2d{2200, 0} - ballOnField) - self.pose.rotation)),
                0.4);
    }
    motion.executed = {};
    for (int i = 0; i < 200; ++i) cycle();  // the kick is over
  }
}

TEST_F(GT2003BehaviorControlTest, NearestRobotIsTheStriker) {
  game.state = GameState::playing;
  seeBall({300, 0});
  auto& mate = team.byPlayer[1];
  mate.message.playerNumber = 2;
  mate.timeReceived = frame.time;
  mate.message.behavior = {DynamicRole::offensiveSupporter, 30000};
  cycle();
  EXPECT_EQ(message.role, DynamicRole::striker);
  mate.timeReceived = frame.time;
  mate.message.behavior = {DynamicRole::striker, 100};
  mate.message.robotPose = {0, 1000, 0};
  seeBall({300, 0});
  cycle();
  EXPECT_EQ(message.role, DynamicRole::offensiveSupporter);
  seeBall({300, 0});
  cycle(3000);
  EXPECT_EQ(message.role, DynamicRole::striker) << "the mate has not been heard for three seconds";
}

TEST_F(GT2003BehaviorControlTest, NeverPlaysTheBallAtTheOwnGoal) {
  WorldState world;
  world.now = world.ball.lastSeen = {1000};
  for (double y = -1250; y <= 1250; y += 50)
    for (double x = -2000; x < 2000; x += 50) {
      world.ball.position = {x, y};
      // Where the ball would cross the own ground line.
      const Vector2d way = direction(kickDirection(world));
      if (way.x() >= 0) continue;
      const double crossing = y + way.y() / way.x() * (-2100 - x);
      EXPECT_GT(std::abs(crossing), 250) << x << ' ' << y;
    }
}

// Report 3.8.2: the kick depends on the obstacle model and on the free part of the goal.
TEST_F(GT2003BehaviorControlTest, PlaysTheBallPastObstacles) {
  WorldState world;
  world.now = world.ball.lastSeen = {1000};
  world.self.pose = {0, 1000, 0};
  world.ball.position = {200, 0};
  const Vector2d ballOnField{1200, 0};
  // The keeper stands on the left: the middle of what is free lies on the right.
  for (const double y : {0., 60., 120., 180.})
    world.obstacles.enter(relative(world.self.pose, {1950, y}), true, world.now);
  const double crossing = std::tan(kickDirection(world)) * (2100 - ballOnField.x());
  EXPECT_LT(crossing, -70);
  EXPECT_GT(crossing, -300);
  // Far from the goal: past the opponent right before the ball, whichever way is shorter.
  world.obstacles = {};
  world.self.pose = {0, -1000, 0};
  const double free = kickDirection(world);
  for (const double y : {-80., -40., 0., 40.}) world.obstacles.enter({550, y}, true, world.now);
  EXPECT_GT(kickDirection(world), free + fromDegrees(10));
  EXPECT_LT(kickDirection(world), free + fromDegrees(40));
  // One behind does not matter.
  world.obstacles = {};
  world.obstacles.enter({-300, 0}, true, world.now);
  EXPECT_EQ(kickDirection(world), free);
}

TEST_F(GT2003BehaviorControlTest, FindsRoomBehindABallAtTheWall) {
  WorldState world;
  world.now = world.ball.lastSeen = {1000};
  for (const Vector2d& place :
       {Vector2d{494, 1269}, Vector2d{-1723, -1272}, Vector2d{1584, -1109}}) {
    world.ball.position = place;
    const Vector2d behind = place - direction(kickDirection(world)) * 280;
    EXPECT_LT(std::abs(behind.y()), 1350) << place.transpose();
    EXPECT_LT(std::abs(behind.x()), 2100) << place.transpose();
  }
}

}  // namespace
}  // namespace gt
