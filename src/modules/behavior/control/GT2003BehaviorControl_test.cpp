#include "modules/behavior/control/GT2003BehaviorControl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "modules/behavior/testing/ImaginedWorld.h"
#include "motionnet/Compiler.h"
#include "representations/behavior/BehaviorTrace.h"
#include "streams/Config.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace gt {
namespace {

/// The special actions of a folder by name, and what the table of kicks says of them.
MotionNet kicksIn(const std::string& folder) {
  const motionnet::Rules anyAngle{std::vector<motionnet::JointRule>(
      MotionNet::jointCount, motionnet::JointRule{"joint", -10000, 10000})};
  const auto compilation = motionnet::compileFolder(folder, anyAngle);
  EXPECT_TRUE(compilation) << compilation.errors.front().text();
  MotionNet net;
  for (const std::string& name : compilation.net.motions) net.motions.push_back({name, {}});
  net.motions[0].name.clear();
  KickTable kicks;
  EXPECT_TRUE(readConfig("config/kicks.cfg", kicks));
  net.take(kicks);
  return net;
}

/// The behavior in behavior/, linked with the module and run on made-up worlds.
class GT2003BehaviorControlTest : public ::testing::Test {
 protected:
  GT2003BehaviorControlTest() {
    world.frame.time = {10000};
    world.player = {TeamColor::red, PlayerRole::striker1};
    world.self = {{0, -1000, 0}, 1};
    world.motions = motions;
  }
  static void SetUpTestSuite() {
    auto compilation = xabsl::compile("behavior/GT2003.xabsl");
    for (const auto& diagnostic : compilation.diagnostics) ADD_FAILURE() << toString(diagnostic);
    behavior = new Behavior{compilation.behavior};
    motions = kicksIn("motions");
  }
  static void TearDownTestSuite() { delete behavior; }

  void cycle(int ms = 40) {
    world.frame.time = world.frame.time + ms;
    control.update(world.state(), *behavior, {}, motionRequest, headControlMode, ledRequest,
                   soundRequest, message, debug);
  }
  void seeBall(const Vector2d& position) {
    world.ball.position = position;
    world.ball.lastSeen = world.teamBall.lastSeen = world.frame.time + 40;
    world.teamBall.position = world.self.pose * position;
  }

  static Behavior* behavior;
  static MotionNet motions;
  GT2003BehaviorControl control;
  ImaginedWorld world;
  MotionRequest motionRequest;
  HeadControlMode headControlMode;
  LedRequest ledRequest;
  SoundRequest soundRequest;
  BehaviorTeamMessage message;
  Debug debug;
};
Behavior* GT2003BehaviorControlTest::behavior = nullptr;
MotionNet GT2003BehaviorControlTest::motions;

TEST_F(GT2003BehaviorControlTest, BehaviorLinksWithTheModule) {
  auto creation = xabsl::Engine::create(*behavior->compiled, control.symbols(world.motions));
  for (const auto& diagnostic : creation.diagnostics) ADD_FAILURE() << toString(diagnostic);
  EXPECT_TRUE(creation.engine);
}

TEST_F(GT2003BehaviorControlTest, KeepsItsBehaviorWhereANewOneDoesNotLink) {
  const auto run = [&](const std::string& text) {
    const Behavior edited{xabsl::compile("a.xabsl", {{"a.xabsl", text}}).behavior};
    ASSERT_TRUE(edited.compiled);
    world.frame.time = world.frame.time + 40;
    control.update(world.state(), edited, {}, motionRequest, headControlMode, ledRequest,
                   soundRequest, message, debug);
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

TEST_F(GT2003BehaviorControlTest, SaysHowTheHeadLooksAndScans) {
  BehaviorControlRequest request;
  const auto decide = [&] {
    cycle();
    control.update(world.state(), *behavior, request, motionRequest, headControlMode, ledRequest,
                   soundRequest, message, debug);
    return headControlMode;
  };
  request.outputs = {{"head_control_mode", "look_at_point"}, {"head.point.x", "700"}};
  EXPECT_EQ(decide().pixel, (Vector2d{88, 72})) << "the middle, unless a behavior says otherwise";
  EXPECT_EQ(headControlMode.point.x(), 700);
  request.outputs.push_back({"head.pixel.x", "20"});
  request.outputs.push_back({"head.pixel.y", "130"});
  EXPECT_EQ(decide().pixel, (Vector2d{20, 130}));
  request.outputs = {{"head_control_mode", "scan_left_right"},
                     {"head.scan.tilt", "-30"},
                     {"head.scan.range", "45"}};
  EXPECT_EQ(decide().mode, HeadMode::scanLeftRight);
  EXPECT_NEAR(headControlMode.scanTilt, fromDegrees(-30), 1e-9);
  EXPECT_NEAR(headControlMode.scanRange, fromDegrees(45), 1e-9);
  request.outputs = {{"head_control_mode", "stay_as_forced"}};
  EXPECT_EQ(decide().mode, HeadMode::stayAsForced);
  EXPECT_EQ(headControlMode.scanRange, HeadControlMode{}.scanRange);
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
  world.body.state = BodyState::fallen;
  cycle();
  const auto reading = xabsl::readTraces("trace", traced());
  ASSERT_EQ(reading.traces.size(), 1u);
  std::string text;
  xabsl::forEachCycle(reading.traces[0].events, [&](const auto* first, const auto* last) {
    text += xabsl::printCycle(reading.traces[0].subject, first, last);
  });
  EXPECT_THAT(text, ::testing::HasSubstr("play_soccer(): wait -> get_up\n"));
  EXPECT_THAT(text, ::testing::HasSubstr("yes: body.fallen  (behavior/options/play_soccer.xabsl:"));
}

/// A replay reads the behavior from a temporary folder, and a team's files lie in another one.
TEST_F(GT2003BehaviorControlTest, NamesTheFilesOfATraceWhereverTheyLie) {
  debug.keys().set(*DebugKey::find("BehaviorControl/trace"), {DebugKeyMode::always, 0});
  const auto traceIn = [&](const std::string& folder) {
    const xabsl::Compilation compilation = xabsl::compile(
        folder + "a.xabsl", {{folder + "a.xabsl",
                              "namespace skills(\"Skills\") { behavior getup { } }\n"
                              "include \"options/play.xabsl\";\n"
                              "agent player(\"Player\", play);"},
                             {folder + "options/play.xabsl",
                              "option play { initial state up { action { getup(); } } }"}});
    EXPECT_TRUE(compilation.behavior);
    if (!compilation.behavior) return std::string{};
    GT2003BehaviorControl fresh;
    debug.out().clear();
    fresh.update(world.state(), Behavior{compilation.behavior}, {}, motionRequest, headControlMode,
                 ledRequest, soundRequest, message, debug);
    BehaviorTrace trace;
    debug.out().handleAllMessages(
        [&](const Message& sent) { EXPECT_TRUE(!sent.is<BehaviorTrace>() || sent.read(trace)); });
    return trace.text;
  };
  const std::string trace = traceIn("/tmp/gt2003-I1Bzj0/behavior/");
  EXPECT_THAT(trace, ::testing::HasSubstr("\nfile behavior/a.xabsl\n"));
  EXPECT_THAT(trace, ::testing::HasSubstr("\nfile behavior/options/play.xabsl\n"));
  EXPECT_EQ(trace, traceIn("behavior/"));
  EXPECT_EQ(trace, traceIn(""));
}

TEST_F(GT2003BehaviorControlTest, StandsUntilTheGameBegins) {
  for (const GameState state : {GameState::initial, GameState::set, GameState::penalized}) {
    world.game.state = state;
    seeBall({300, 0});
    cycle();
    EXPECT_EQ(motionRequest.type, MotionType::stand) << enumName(state);
  }
}

TEST_F(GT2003BehaviorControlTest, WalksToItsKickOffPosition) {
  world.game.state = GameState::ready;
  world.game.kickOff = KickOff::opponent;
  for (int i = 0; i < 2000; ++i) {
    cycle();
    if (motionRequest.type == MotionType::walk)
      world.self.pose = world.self.pose * Pose2D{motionRequest.walk.rotation * 0.04,
                                                 motionRequest.walk.translation * 0.04};
  }
  EXPECT_EQ(motionRequest.type, MotionType::stand);
  EXPECT_NEAR((world.self.pose.translation - Vector2d{-650, 0}).norm(), 0, 100);
}

TEST_F(GT2003BehaviorControlTest, GetsUpAfterAFall) {
  world.game.state = GameState::playing;
  world.body.state = BodyState::fallen;
  cycle();
  EXPECT_EQ(motionRequest.type, MotionType::getup);
}

TEST_F(GT2003BehaviorControlTest, GoesBehindTheBallAndKicksIt) {
  // A perfect robot and a ball that lies still: from everywhere around, the kick must come, and
  // towards the goal.
  world.game.state = GameState::playing;
  const Vector2d ballOnField{300, 200};
  for (double angle = -3; angle < 3; angle += 0.5) {
    world.self.pose = {angle, ballOnField + direction(angle * 2) * 700};
    bool kicked = false;
    for (int i = 0; i < 1000 && !kicked; ++i) {
      seeBall(relative(world.self.pose, ballOnField));
      cycle();
      kicked = motionRequest.type == MotionType::specialAction;
      if (motionRequest.type == MotionType::walk)
        world.self.pose = world.self.pose * Pose2D{motionRequest.walk.rotation * 0.04,
                                                   motionRequest.walk.translation * 0.04};
      EXPECT_GT((world.self.pose.translation - ballOnField).norm(), 90)
          << "must not run the ball over";
    }
    EXPECT_TRUE(kicked) << "from angle " << angle;
    if (motionRequest.specialAction == "pushStrong") {
      EXPECT_LT(
          std::abs(normalize(angleOf(Vector2d{2200, 0} - ballOnField) - world.self.pose.rotation)),
          0.4);
    }
    world.motion.executed = {};
    for (int i = 0; i < 200; ++i) cycle();  // the kick is over
  }
}

TEST_F(GT2003BehaviorControlTest, MovesTheTailAndPlaysASoundAsTheBehaviorSets) {
  world.game.state = GameState::playing;
  cycle();
  EXPECT_EQ(motionRequest.tail, TailRequest::noTailWag);
  EXPECT_EQ(soundRequest.sound, Sound::none);
  world.game.state = GameState::finished;
  world.game.ownScore = 1;
  world.self.pose.translation = {-700, 1150};
  for (int i = 0; i < 3; ++i) cycle();
  EXPECT_EQ(motionRequest.tail, TailRequest::wagHorizontalFast);
  EXPECT_EQ(soundRequest.sound, Sound::fanfare);
}

TEST_F(GT2003BehaviorControlTest, LooksAtThePointThatTheBehaviorSets) {
  const std::string text =
      "namespace symbols(\"Symbols\") {"
      "  enum head_mode output { none, look_at_point };"
      "  enum head_mode output head_control_mode;"
      "  float output head.point.x \"mm\"; float output head.point.y \"mm\";"
      "  float output head.point.z \"mm\";"
      "} namespace skills(\"Skills\") { behavior stand {} }"
      "option play { initial state look { action { stand(); head_control_mode = look_at_point;"
      "  head.point.x = 500; head.point.y = -80; head.point.z = 43; } } }"
      "agent player(\"Player\", play);";
  const auto compilation = xabsl::compile("a.xabsl", {{"a.xabsl", text}});
  ASSERT_TRUE(compilation.behavior);
  const Behavior looking{compilation.behavior};
  control.update(world.state(), looking, {}, motionRequest, headControlMode, ledRequest,
                 soundRequest, message, debug);
  EXPECT_EQ(headControlMode.mode, HeadMode::lookAtPoint);
  EXPECT_EQ(headControlMode.point, Vector3d(500, -80, 43));
}

TEST_F(GT2003BehaviorControlTest, TellsItsTeamTheRoleThatItNegotiated) {
  world.game.state = GameState::playing;
  seeBall({300, 0});
  cycle();
  EXPECT_EQ(message.role, DynamicRole::striker);
  EXPECT_NEAR(message.estimatedTimeToReachBall, 1500, 1);
}

}  // namespace
}  // namespace gt
