#include "console/Console.h"

#include <filesystem>

#include "console/Commands.h"
#include "console/Manual.h"
#include "console/TestSession.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "streams/File.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class ConsoleTest : public SessionTest {
 protected:
  std::string solution(std::size_t i, std::string_view task) {
    for (const auto& process : robot(i).processes())
      if (process->solves(task)) return process->activeSolution(task);
    return "";
  }
};

TEST(Words, KeepQuotesTogether) {
  EXPECT_EQ(*splitWords("  mr  walk 1 \"a b\" \t c"), (Words{"mr", "walk", "1", "a b", "c"}));
  EXPECT_TRUE(splitWords("")->empty());
  EXPECT_FALSE(splitWords("echo \"open"));
  EXPECT_EQ(*splitWords(R"(sl AIBO1 c:\\logs\\hallo)"), (Words{"sl", "AIBO1", R"(c:\logs\hallo)"}));
  EXPECT_EQ(splitWords("echo  what it \t is  ")->rest, "what it \t is");
}

TEST_F(ConsoleTest, EveryCommandHasHelp) {
  for (const Command& command : Console::commands()) {
    EXPECT_FALSE(command.help.empty());
    screen.printed.clear();
    expectFine("help " + std::string{command.name});
    EXPECT_GE(screen.printed.size(), 2u) << command.name;
    EXPECT_FALSE(command.topic.empty()) << command.name;
    for (const std::string& line : screen.printed) EXPECT_LE(line.size(), 100u) << line;
  }
  const auto overview = answers("help");
  EXPECT_LT(overview.size(), 40u);
  EXPECT_THAT(overview, Contains(HasSubstr("xbb")));
  EXPECT_THAT(answers("help motion"), Contains(HasSubstr("hmr TILT PAN ROLL MOUTH")));
  EXPECT_THAT(answers("help motion"), testing::Not(Contains(HasSubstr("xbb"))));
  EXPECT_GT(answers("help all").size(), 100u);
  expectError("help nonsense", "nonsense", "no such command or topic");
  expectError("nonsense", "nonsense", "no such command");
  expectError("hlep", "hlep", "did you mean 'help'?");
  expectError("picture fild a.png", "fild", "did you mean 'field'?");
  expectError("robot rad4", "rad4", "did you mean 'red4'?");
  expectFine("# a comment");
  expectFine("");
}

TEST(Manual, IsInTheDocumentation) {
  EXPECT_EQ(*readFile("docs/console.md"), consoleManual())
      << "simgt commands > docs/console.md brings it up to date";
}

TEST_F(ConsoleTest, SwitchesSolutionsOfSelectedRobots) {
  expectFine("robot red4");
  expectFine("sr BallLocator disabled");
  EXPECT_EQ(solution(0, "BallLocator"), "PIDSmoothed");
  EXPECT_EQ(solution(1, "BallLocator"), "disabled");
  expectFine("robot all");
  expectFine("sr BallLocator disabled");
  EXPECT_EQ(solution(0, "BallLocator"), "disabled");
  expectFine("sr BallLocator PIDSmoothed");
  EXPECT_EQ(solution(1, "BallLocator"), "PIDSmoothed");
  expectError("sr BallLocator Nonsense", "BallLocator", "Nonsense");
  expectError("sr Nonsense disabled", "Nonsense", "no process solves");
  expectError("robot red7", "red7", "no robot");
  expectFine("sr ?");
  EXPECT_THAT(screen.printed, Contains("BallLocator PIDSmoothed"));
  screen.printed.clear();
  expectFine("sr SelfLocator ?");
  EXPECT_THAT(screen.printed, Contains("MonteCarlo"));
  EXPECT_THAT(screen.printed, Contains("disabled"));
}

TEST_F(ConsoleTest, SetsDebugKeysAsTheReportDoes) {
  const DebugKey* key = DebugKey::find("ImageProcessor/percepts");
  ASSERT_NE(key, nullptr);
  const auto mode = [&] { return robot(0).processes()[0]->debug().keys().get(*key); };
  expectFine("dk ImageProcessor/percepts on");
  EXPECT_EQ(mode().mode, DebugKeyMode::always);
  expectFine("dk ImageProcessor/percepts 3");
  EXPECT_EQ(mode().mode, DebugKeyMode::times);
  expectFine("dk ImageProcessor/percepts every 5");
  EXPECT_EQ(mode().mode, DebugKeyMode::everyTimes);
  expectFine("dk ImageProcessor/percepts every 500 ms");
  EXPECT_EQ(mode().mode, DebugKeyMode::everyMs);
  EXPECT_EQ(mode().n, 500);
  expectFine("dk ImageProcessor/percepts off");
  EXPECT_EQ(mode().mode, DebugKeyMode::disabled);
  expectError("dk Nonsense on", "Nonsense", "no such debug key");
  expectError("dk ImageProcessor/percepts often", "often", "is no number");
  expectError("dk ImageProcessor/percepts every -3", "dk", "expected");
  expectFine("dk ?");
  EXPECT_THAT(screen.printed, Contains("ImageProcessor/percepts"));
}

TEST_F(ConsoleTest, ReadsAndSetsParametersByPath) {
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red1: 2"));
  expectFine("set ImageProcessor.GT2003.denseSpacing 4");
  screen.printed.clear();
  expectFine("get ImageProcessor.GT2003.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red4: 4"));
  const auto tooLarge = console->execute("set ImageProcessor.denseSpacing 400");
  ASSERT_FALSE(tooLarge);
  screen.printed.clear();
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red1: 4")) << "a wrong value changes nothing";
  EXPECT_FALSE(console->execute("set ImageProcessor.nonsense 4"));
  EXPECT_FALSE(console->execute("get nonsense"));
  screen.printed.clear();
  expectFine("get ?");
  EXPECT_GT(screen.printed.size(), 20u);
}

TEST_F(ConsoleTest, ChangesLayouts) {
  ASSERT_EQ(robot(0).processes().size(), 2u);
  expectFine("layout layouts/single.layout");
  expectFine("run 0.1");
  EXPECT_EQ(robot(0).processes().size(), 1u);
  EXPECT_EQ(session->time(), Time{104});
  EXPECT_FALSE(console->execute("layout layouts/nonsense.layout"));
  expectError("run soon", "soon", "is no number");
}

TEST_F(ConsoleTest, FillsTheQueueToTheToolsAsAskedFor) {
  for (const char* mode : {"queue", "replace", "reject", "collect 5", "save 2.5"})
    expectFine(std::string{"qfr "} + mode);
  expectFine("dk sendOdometryData on");
  expectFine("log start");
  const auto messagesAfter = [&](const std::string& line, const std::string& seconds) {
    expectFine(line);
    expectFine("log clear");
    expectFine("run " + seconds);
    return session->robots()[0]->recorder.messages();
  };
  expectFine("robot red1");
  EXPECT_EQ(messagesAfter("qfr reject", "0.2"), 0u);
  const auto all = messagesAfter("qfr queue", "0.2");
  EXPECT_GE(all, 50u) << "sensor data and odometry of 25 frames";
  const auto half = messagesAfter("qfr collect 0.1", "0.2");
  EXPECT_GT(half, all / 3);
  EXPECT_LT(half, all * 2 / 3);
  EXPECT_GT(messagesAfter("qfr replace", "0.2"), 0u);
  expectError("qfr sometimes", "qfr", "expected: qfr queue");
  expectError("qfr collect", "qfr", "expected");
  expectError("qfr collect -1", "qfr", "expected");
}

TEST_F(ConsoleTest, KnowsTheReportsDebugKeys) {
  const auto mode = [&](const char* key) {
    return robot(0).processes()[0]->debug().keys().get(*DebugKey::find(key)).mode;
  };
  expectFine("dk send_imageProcessor_horizon_drawing every 100 ms");
  EXPECT_EQ(mode("ImageProcessor/horizon"), DebugKeyMode::everyMs);
  expectFine("dk send_selfLocatorField_drawing on");
  EXPECT_EQ(mode("SelfLocator/samples"), DebugKeyMode::always);
  expectFine("dk sendXabsl2DebugMessages on");
  expectFine("dk sendJPEGImage on");
  expectFine("dk sendRobotPose on");
  expectError("dk sendNothing on", "Nothing", "no process");
  expectFine("log start");
  expectFine("run 1");
  const auto* behavior = session->robots()[0]->observed().newest<BehaviorState>();
  ASSERT_TRUE(behavior);
  EXPECT_FALSE(behavior->activations.empty());
  expectFine("robot red1");
  expectFine("log save " + file("seen"));
  EXPECT_GT(std::filesystem::file_size(file("seen.mcap")), 10'000u);
  // What was recorded can be replayed into the modules again.
  expectFine("robot all");
  expectFine("sl LOG1 " + file("seen.mcap"));
  expectFine("robot LOG1");
  expectFine("sr SensorDataProcessor disabled");
  expectFine("sr ImageProcessor GT2003");
  expectFine("run 1");
  const auto picture = session->find("LOG1")->observed().value<Image>();
  ASSERT_TRUE(picture) << picture.error().text();
  EXPECT_EQ((*picture)->info.width, 176);
  expectError("sl LOG1 " + file("seen.mcap"), "LOG1", "already");
  EXPECT_FALSE(console->execute("sl LOG2 " + file("nothing")));
}

TEST_F(ConsoleTest, MovesRobotsByHand) {
  expectFine("sr BehaviorControl disabled");
  expectFine("hcm none");
  expectFine("hmr -20 40 0 -10");
  expectFine("mr normal 100 0 0");
  expectFine("tr wagHorizontalFast");
  expectFine("run 2 s");
  EXPECT_NEAR(robot(0).provided<HeadMotionRequest>()->pan, fromDegrees(40), 1e-9);
  EXPECT_EQ(robot(0).provided<MotionInfo>()->executed.type, MotionType::walk);
  EXPECT_EQ(robot(0).provided<MotionRequest>()->tail, TailRequest::wagHorizontalFast);
  EXPECT_GT(session->simulation().world().robot(0).pose.translation.x(), -1950);
  expectFine("mr leftHeadKick");
  expectFine("run 200 ms");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->specialAction, "headLeft");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->tail, TailRequest::wagHorizontalFast);
  EXPECT_THAT(answers("mr ?"), Contains("normal"));
  EXPECT_THAT(answers("tr ?"), Contains("noTailWag"));
  EXPECT_THAT(answers("hcm ?"), Contains("searchForLandmarks"));
  expectFine("hcm lookAtPoint 1000 -200 30");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<HeadControlMode>()->point, (Vector3d{1000, -200, 30}));
  EXPECT_THAT(answers("hmr 0 10 0 0"), Contains(HasSubstr("head control mode is lookAtPoint")));
  expectFine("hcm none");
  EXPECT_THAT(answers("hmr 0 10 0 0"), testing::IsEmpty());
  expectError("hcm lookAtPoint", "hcm", "expected");
  expectError("hcm searchForBall 1 2 3", "hcm", "expected");
  expectError("mr normal 1 2", "mr", "expected");
  expectError("mr fly", "fly", "no such motion");
  expectError("hmr 0 0 0 900", "900", "is not from");
  expectError("tr nod", "nod", "no such tail request");
  expectError("hcm nod", "nod", "no such head control mode");
  expectFine("sr BehaviorControl GT2003-soccer");
  EXPECT_EQ(answers("mr stand").size(), 2u) << "both robots are warned that the behavior decides";
}

/// Report 5.2: to simulated robot, to all simulated robots, from simulated robot.
TEST_F(ConsoleTest, SendsToMessageQueues) {
  const auto spacing = [&](const char* robot) {
    return *session->find(robot)->observed().get("ImageProcessor.GT2003.denseSpacing");
  };
  expectFine("robot red4");
  expectFine("to allSimulatedRobots set ImageProcessor.GT2003.denseSpacing 4");
  EXPECT_EQ(spacing("red1") + spacing("red4"), "44");
  expectFine("to simulatedRobot set ImageProcessor.GT2003.denseSpacing 3");
  EXPECT_EQ(spacing("red1") + spacing("red4"), "43") << "red4 is the connected one";
  EXPECT_EQ(console->selection(), std::vector<std::string>{"red4"});
  expectFine("robot all");
  expectFine("from simulatedRobot log start");
  EXPECT_TRUE(session->find("red1")->recorder.recording());
  EXPECT_FALSE(session->find("red4")->recorder.recording());
  EXPECT_THAT(console->selection(), testing::IsEmpty());
  expectError("to physicalRobot log stop", "physicalRobot", "there is no such robot");
  expectError("from allSimulatedRobots log stop", "from", "expected: from (physicalRobot");
  expectError("to nobody log stop", "to", "expected: to (physicalRobot");
  expectError("to simulatedRobot run 1", "run", "no command for selected robots");
  expectError("to simulatedRobot sr Poet Rilke", "Poet", "no process solves this task");
  EXPECT_THAT(console->selection(), testing::IsEmpty());
}

TEST_F(ConsoleTest, LeadsTheGame) {
  const Referee& referee = session->simulation().referee();
  expectFine("gc kickOff red 2 1");
  EXPECT_EQ(referee.state(), GameState::set);
  EXPECT_EQ(referee.score(TeamColor::blue), 2);
  EXPECT_EQ(referee.score(TeamColor::red), 1);
  EXPECT_EQ(referee.dataFor(0).kickOff, KickOff::own);
  expectFine("gc playing");
  EXPECT_EQ(referee.state(), GameState::playing);
  expectFine("robot red4");
  expectFine("pr obstruction");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::obstruction);
  EXPECT_EQ(referee.dataFor(0).penalty, Penalty::none);
  expectFine("pr continue");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::none);
  expectFine("pr ballHolding");
  expectFine("gc ready");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::none) << "report J.2.6";
  expectFine("gc reset");
  EXPECT_EQ(referee.score(TeamColor::blue), 0);
  expectFine("gc final");
  EXPECT_EQ(referee.state(), GameState::finished);
  expectError("run 1", "run", "the game is over");
  expectError("gc kickOff green", "gc", "expected");
  expectError("gc kickOff red 1", "gc", "expected");
  expectError("pr nothing", "pr", "expected");
}

TEST_F(ConsoleTest, ShowsAndChangesWhatTheBehaviorDoes) {
  expectFine("xlb gt03");
  EXPECT_THAT(answers("xlb ?"), Contains("GT2003"));
  expectFine("dk sendXabsl2DebugMessages on");
  expectFine("xis ball.seen.distance on");
  expectFine("xis ball.time-since-last-seen on");
  expectFine("xos head-control-mode on");
  expectFine("xos head-control-mode head-control-mode.search-for-ball");
  expectFine("xbb go-to-point 1600 0 0");
  expectFine("run 1");
  BehaviorState state;
  const auto look = [&] { state = *session->robots()[0]->observed().newest<BehaviorState>(); };
  look();
  ASSERT_EQ(state.activations.size(), 1u);
  EXPECT_EQ(state.activations[0].name, "go_to_point");
  EXPECT_EQ(state.activations[0].parameters[0].value, "1600");
  ASSERT_EQ(state.inputs.size(), 2u);
  EXPECT_EQ(state.inputs[0].unit, "mm");
  ASSERT_EQ(state.outputs.size(), 1u);
  EXPECT_EQ(state.outputs[0].value, "search_for_ball");
  EXPECT_EQ(robot(0).provided<HeadControlMode>()->mode, HeadMode::searchForBall);
  expectFine("xos head-control-mode unchanged");
  expectFine("xis ball.seen.distance off");
  expectFine("xo go-to-kickoff-position 2000 0");  // as report I.5.3 prints it
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].name, "go_to_kickoff_position");
  EXPECT_EQ(state.activations[0].parameters[0].value, "2000");
  EXPECT_EQ(state.activations[1].name, "go_to_point");
  EXPECT_EQ(state.activations[1].parameters[0].value, "2000");
  EXPECT_EQ(state.inputs.size(), 1u);
  EXPECT_EQ(state.outputs.size(), 1u);
  expectFine("xbb perform-special-action sit");
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].parameters[0].value, "sit");
  expectError("xbb perform-special-action sat", "sat", "did you mean 'sit'?");
  expectFine("xo unchanged");
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].name, "play_soccer");
  EXPECT_THAT(answers("xos ?"), Contains("head_control_mode"));
  EXPECT_THAT(answers("xos head-control-mode ?"), Contains("look_left"));
  EXPECT_THAT(answers("xis ?"), Contains("ball.seen.angle"));
  EXPECT_THAT(answers("xo ?"), Contains("play_soccer"));
  EXPECT_THAT(answers("xbb ?"), Contains(HasSubstr("go_to_point x")));
  expectError("xbb fly", "fly", "none of this name");
  expectError("xbb go-to-point 1 2 3 4 5 6", "go_to_point", "parameters");
  expectError("xos head-control-mode nod", "nod", "is no value");
  expectError("xos nothing on", "nothing", "no such output symbol");
  expectError("xis nothing on", "nothing", "no such input symbol");
  EXPECT_FALSE(console->execute("xlb nothing"));
}

TEST_F(ConsoleTest, LetsRobotsLiveOnTheOracle) {
  expectFine("ci off");
  expectFine("sr SelfLocator disabled");
  expectFine("sr BallLocator disabled");
  expectFine("run 1");
  const auto error = [&] {
    return (robot(1).provided<RobotPose>()->pose.translation -
            session->simulation().world().robot(1).pose.translation)
        .norm();
  };
  EXPECT_LT(error(), 20);
  expectFine("so off");
  expectFine("place red4 1000 1000");
  expectFine("run 1");
  EXPECT_GT(error(), 500);
  expectFine("so on");
  expectFine("run 100 ms");
  EXPECT_LT(error(), 20);
}

TEST_F(ConsoleTest, LosesImagesOnlyIfAskedTo) {
  expectFine("run 400 ms");
  EXPECT_EQ(session->match().robots()[0]->lostImages(), 0);
  expectFine("st off 100000");
  expectFine("run 400 ms");
  EXPECT_GT(session->match().robots()[0]->lostImages(), 5);
  expectFine("st on 2");
  EXPECT_EQ(session->pace().factor, 2);
  expectFine("st on");
  const auto lost = session->match().robots()[0]->lostImages();
  expectFine("run 400 ms");
  EXPECT_EQ(session->match().robots()[0]->lostImages(), lost);
  expectError("st maybe", "st", "expected");
}

TEST_F(ConsoleTest, FollowsAJoystick) {
  expectFine("sr BehaviorControl disabled");
  expectFine("jhc tilt");
  expectFine("jbc 1 mr headLeft");
  expectFine("jbc 32 echo a  b");
  EXPECT_THAT(answers("joystick press 32"), Contains("a  b"));
  expectFine("joystick release 32");
  expectFine("joystick press 1");
  expectFine("joystick y -1");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->specialAction, "headLeft")
      << "no walking while a button is pressed";
  expectFine("joystick release 1");
  expectFine("joystick accelerator -0.5");
  expectFine("run 100 ms");
  EXPECT_GT(robot(0).provided<MotionRequest>()->walk.translation.x(), 100);
  expectError("jbc 33 sit", "33", "is not from 1 to 32");
  expectError("jbc 1 fly", "fly", "no such command");
  expectError("jhc ear", "jhc", "expected");
}

TEST_F(ConsoleTest, RobotCommandsNeedARobot) {
  const std::string root = std::filesystem::current_path().string();
  std::ofstream{file("empty.scene")} << "<scene field='" << root
                                     << "/models/field2003.xml' config='" << root
                                     << "/config'><game referee='false'/></scene>";
  expectFine("scene " + file("empty.scene"));
  for (const char* line : {"dk ImageProcessor/horizon on", "mr stand", "hcm none", "log start"})
    expectError(line, "robot", "there is none");
}

TEST_F(ConsoleTest, QuestionsAreNotDoneAgain) {
  expectFine("xos head-control-mode ?");
  expectFine("sr SelfLocator ?");
  expectFine("robot ?");
  EXPECT_TRUE(session->match().history().empty());
  expectFine("robot red1");
  EXPECT_EQ(session->match().history().size(), 1u);
}

TEST_F(ConsoleTest, BeginsAnewWithTheScenesScript) {
  const std::string scene = *readFile(session->options().scene);
  std::ofstream{file("own.con")} << "place ball 70 80\nrobot red4\n";
  std::ofstream{file("own.scene")} << "<scene script='own.con'" << scene.substr(6);
  expectFine("scene " + file("own.scene"));
  EXPECT_THAT(answers("get ball.x"), testing::ElementsAre("70"));
  expectFine("place ball 0 0");
  expectFine("robot all");
  expectFine("reset");
  EXPECT_THAT(answers("get ball.x"), testing::ElementsAre("70"));
  EXPECT_EQ(console->selection(), std::vector<std::string>{"red4"});
  expectFine("seed 3");
  EXPECT_THAT(answers("get ball.y"), testing::ElementsAre("80"));
}

TEST_F(ConsoleTest, RecordsAsOftenAsAskedFor) {
  expectFine("plot ball.x on");
  expectFine("plot ball.x off");
  expectFine("plot ball.x on");
  expectFine("plot ball.x on");
  expectFine("run 1");
  EXPECT_EQ(console->recorder().series().at("ball.x").size(), 25u);
  expectFine("film start " + file("a.mp4") + " field");
  expectError("film start " + file("b.mp4"), "film", "a.mp4 is being made");
  expectFine("run 200 ms");
  EXPECT_THAT(answers("reset"), Contains("written: " + file("a.mp4")));
  EXPECT_GT(std::filesystem::file_size(file("a.mp4")), 500u);
  expectError("film stop", "film", "none is being made");
  EXPECT_TRUE(console->recorder().series().empty());
  // What has recorded may be gone before the session goes on.
  expectFine("plot ball.x on");
  console.reset();
  EXPECT_TRUE(session->step());
}

TEST_F(ConsoleTest, ViewsAreDefinedByWhatIsPainted) {
  expectFine("view plain field fieldLines flags");
  expectFine("view mine image image imageProcessor_horizon");
  EXPECT_THAT(answers("view ?"), Contains("plain  defined: plain field fieldLines flags"));
  EXPECT_THAT(answers("picture plain " + file("plain.svg")),
              testing::ElementsAre("written: " + file("plain.svg")));
  const std::string svg = *readFile(file("plain.svg"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("#1e6e32"))) << "no grass without fieldPolygons";
  EXPECT_THAT(svg, HasSubstr("#fa5aaa")) << "flags are pink";
  EXPECT_THAT(console->completions("picture pla"), testing::ElementsAre("plain"));
  expectFine("view plain off");
  expectError("picture plain a.png", "plain", "no such view");
  expectError("view plain off", "plain", "no view was defined");
  expectError("view field field flags", "field", "is a view already");
  expectError("view new field nonsense", "nonsense", "no such drawing");
  expectError("view new cube flags", "view", "expected");
  expectError("picture image", "picture", "expected");
}

TEST_F(ConsoleTest, CompletesWhatIsTyped) {
  EXPECT_THAT(console->completions("x"), testing::ElementsAre("xbb", "xis", "xlb", "xo", "xos"));
  EXPECT_THAT(console->completions("dk send_self"), Contains("send_selfLocator_drawing"));
  EXPECT_THAT(console->completions("sr SelfLocator M"), testing::ElementsAre("MonteCarlo"));
  EXPECT_THAT(console->completions("xbb go_to_p"), testing::ElementsAre("go_to_point"));
  EXPECT_THAT(console->completions("xis ball.seen.d"), testing::ElementsAre("ball.seen.distance"));
  EXPECT_THAT(console->completions("get red4.x"), testing::ElementsAre("red4.x"));
  EXPECT_THAT(console->completions("robot red"), testing::ElementsAre("red1", "red4"));
  EXPECT_THAT(console->completions("layout layouts/cm"),
              testing::ElementsAre("layouts/cmd.layout"));
  EXPECT_THAT(console->completions("layout cm"), testing::ElementsAre("cmd"));
  EXPECT_THAT(console->completions("nonsense \"open"), testing::IsEmpty());
  EXPECT_THAT(console->completions("hmr "), testing::IsEmpty());
  EXPECT_THAT(console->completions("dk ImageProcessor/percepts e"), testing::ElementsAre("every"));
  EXPECT_THAT(console->completions("gc k"), testing::ElementsAre("kickOff"));
  EXPECT_THAT(console->completions("gc kickOff r"), testing::ElementsAre("red"));
  EXPECT_THAT(console->completions("jbc 1 xo play_s"), testing::ElementsAre("play_soccer"));
  EXPECT_THAT(console->completions("jbc "), testing::IsEmpty());
  EXPECT_THAT(console->completions("until red4.x > 100 wi"), testing::ElementsAre("within"));
  EXPECT_THAT(console->completions("film start x fiel"), testing::ElementsAre("field"));
  EXPECT_THAT(console->completions("help vie"), testing::ElementsAre("view", "views"));
}

TEST_F(ConsoleTest, SendsGenericDebugData) {
  expectFine("sg defaultObstaclesLocator 1 0 2000");
  expectFine("sg BallLocator 0.25");
  expectError("sg BallLocator one", "one", "is no number");
  expectError("sg numberOfFourierCoefficients 1", "numberOfFourierCoefficients", "no such id");
}

TEST_F(ConsoleTest, ScriptsTellFileAndLineOfTheirErrors) {
  const std::string inner = file("inner.con"), outer = file("outer.con");
  std::ofstream{inner} << "# inner\necho in\nsr BallLocator nonsense\necho never\n";
  std::ofstream{outer} << "echo out\n\ncall " << inner << "\n";
  const auto done = console->call(outer);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().file, inner);
  EXPECT_EQ(done.error().line, 3);
  EXPECT_EQ(screen.printed, (std::vector<std::string>{"out", "in"}));
  std::ofstream{outer} << "call " << outer << "\n";
  EXPECT_FALSE(console->call(outer)) << "a script that calls itself";
  EXPECT_FALSE(console->call(file("nothing.con")));
}

}  // namespace
}  // namespace gt
