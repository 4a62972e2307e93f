#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <regex>

#include "base/File.h"
#include "console/Console.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/LinesPercept.h"
#include "support/ProgramFolder.h"
#include "support/RobotElsewhere.h"

namespace gt {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Keeps what was printed.
class TextScreen : public Screen {
 public:
  void print(std::string_view line) override { text += std::string{line} + "\n"; }
  std::string text;
};

/// A console at whose prompt commands are typed. Simulated time stands unless a command lets it
/// pass.
class ConsoleAt {
 public:
  explicit ConsoleAt(const std::string& scene, const std::optional<Keys>& keys = {}) {
    MatchOptions options;
    options.scene = scene;
    options.keys = keys;
    auto made = Session::make(options, screen_);
    EXPECT_TRUE(made) << made.error().text();
    session_ = std::move(*made);
    console_ = std::make_unique<Console>(*session_);
  }

  /// What a line prints, or its error.
  std::string answer(const std::string& line) {
    screen_.text.clear();
    const auto done = console_->execute(line);
    return done ? screen_.text : "error: " + done.error().text() + "\n";
  }
  void expectFine(const std::string& line) {
    const auto done = console_->execute(line);
    EXPECT_TRUE(done) << line << ": " << done.error().text();
  }
  void script(const std::string& lines) {
    std::istringstream text{lines};
    for (std::string line; std::getline(text, line);) expectFine(line);
  }
  /// Waits at the prompt until something holds.
  bool waitFor(const std::function<bool()>& holds) {
    return session_->waitFor(holds, std::chrono::minutes{1});
  }
  ObservedRobot& robot(const std::string& name) { return session_->find(name)->observed(); }
  Session& session() { return *session_; }

 private:
  TextScreen screen_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Console> console_;
};

/// The number by which `sc` names a robot.
std::string nameOf(const testing::RobotElsewhere& robot) {
  return robot.address().substr(robot.address().rfind('.') + 1);
}

std::optional<Keys> keyOf(const testing::RobotElsewhere& robot) {
  const auto keys = loadKeys(robot.key());
  return keys ? std::optional{*keys} : std::nullopt;
}

/// A script as the report prints it, with the address of a robot that is there.
std::string printed(const std::string& script, const std::string& address) {
  return std::regex_replace(script, std::regex{"172\\.21\\.3\\.201"}, address);
}

const std::string recordingScript = R"(# connect to a robot
sc 172.21.3.201
# suppress messages
msg off
# disable everything but sensor data processor and head control
sr SensorDataProcessor Default
sr ImageProcessor disabled
sr SelfLocator disabled
sr BallLocator disabled
sr PlayersLocator disabled
sr RobotStateDetector disabled
sr BehaviorControl disabled
sr HeadControl GT2003
# stop motion
mr normal 0 0 0
hcm none
hmr 0 0 0 0
# queue real-time mode, send JPEG images and odometry
qfr replace
dk sendJPEGImage on
dk sendOdometryData on)";

const std::string replayScript = R"(# suppress messages
msg off
# simulation time on, otherwise log data may be skipped
st on
# configure modules. Important: sensor data processor disabled
sr SensorDataProcessor disabled
sr ImageProcessor GT2003
sr SelfLocator GT2003
sr BallLocator PIDSmoothed
sr PlayersLocator GO2003
sr RobotStateDetector disabled
sr BehaviorControl disabled
sr HeadControl disabled
# request some drawings
dk send_imageProcessor_horizon_drawing on
dk send_imageProcessor_scanLines_drawing on
dk send_selfLocator_drawing on
dk send_selfLocatorField_drawing on)";

TEST(RobotElsewhere, IsKnownAndChangedAtThePrompt) {
  const testing::RobotElsewhere elsewhere{programFolder()};
  ASSERT_TRUE(elsewhere.made());
  ConsoleAt console{"scenes/empty.scene", keyOf(elsewhere)};
  console.expectFine("sc " + elsewhere.address());
  ObservedRobot& robot = console.robot(nameOf(elsewhere));
  ASSERT_TRUE(console.waitFor([&] { return robot.value<Image>() && robot.times(); }));
  EXPECT_EQ((*robot.value<Image>())->pixels.size(), 176u * 144u);
  const Time before = (*robot.value<SensorDataBuffer>())->newest().time;
  EXPECT_TRUE(
      console.waitFor([&] { return (*robot.value<SensorDataBuffer>())->newest().time > before; }));
  EXPECT_THAT(console.answer("get RobotPose.pose.rotation"), HasSubstr(nameOf(elsewhere) + ": "));
  EXPECT_THAT(console.answer("get Player.teamColor"), HasSubstr("red"));
  console.expectFine("set ImageProcessor.GT2003.denseSpacing 4");
  EXPECT_THAT(console.answer("get ImageProcessor.denseSpacing"), HasSubstr(": 4"));
  EXPECT_THAT(console.answer("set ImageProcessor.denseSpacing 400"), HasSubstr("error"));
  console.expectFine("to allPhysicalRobots sr BallLocator disabled");
  EXPECT_THAT(console.answer("to simulatedRobot sr ?"), HasSubstr("there is no such robot"));
  EXPECT_THAT(console.answer("from physicalRobot sr ?"),
              AllOf(HasSubstr("BallLocator disabled"), HasSubstr("SelfLocator Kalman")));
  console.expectFine("set BallModel.position.x 1234");
  EXPECT_THAT(console.answer("get BallModel.position.x"), HasSubstr(": 1234"));
  console.expectFine("dk ImageProcessor/horizon on");
  EXPECT_TRUE(console.waitFor([&] { return robot.drawings().contains("ImageProcessor/horizon"); }));
  EXPECT_THAT(console.answer("dk ImageProcessor/poem on"), HasSubstr("no such debug key"));
  EXPECT_THAT(console.answer("sr Poet Rilke"), HasSubstr("error"));
  EXPECT_THAT(console.answer("graph"), HasSubstr("WalkingEngine"));
  EXPECT_EQ((*robot.times())->size(), 2u);
  EXPECT_EQ(console.session().time(), Time{}) << "time stood";
}

/// Report I.6.1 and I.6.2, as printed.
TEST(RobotElsewhere, IsRecordedAndItsLogReplayed) {
  const testing::RobotElsewhere elsewhere{programFolder()};
  ASSERT_TRUE(elsewhere.made());
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "myLogFile.mcap").string();
  {
    ConsoleAt console{"scenes/empty.scene", keyOf(elsewhere)};
    console.expectFine("sc " + elsewhere.address());
    ObservedRobot& robot = console.robot(nameOf(elsewhere));
    ASSERT_TRUE(console.waitFor([&] { return static_cast<bool>(robot.value<Image>()); }));
    std::istringstream lines{printed(recordingScript, elsewhere.address())};
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("sc ")) console.expectFine(line);
    console.expectFine("log start");
    auto& recorder = console.session().find(nameOf(elsewhere))->recorder;
    EXPECT_TRUE(console.waitFor([&] { return recorder.messages() > 400; }));
    console.expectFine("log stop");
    console.expectFine("log save " + log);
  }
  ConsoleAt console{"scenes/empty.scene"};
  console.expectFine("sl LOG1 " + log);
  console.script(replayScript);
  ObservedRobot& robot = console.robot("LOG1");
  bool sawLines = false;
  for (int i = 0; i < 20; ++i) {
    console.expectFine("run 100 ms");
    const auto percept = robot.value<LinesPercept>();
    ASSERT_TRUE(percept) << percept.error().text();
    for (const auto& points : (*percept)->points) sawLines |= !points.empty();
  }
  EXPECT_TRUE(sawLines);
  EXPECT_TRUE(robot.drawings().contains("ImageProcessor/horizon"));
  const auto role = robot.get("Player.playerRole");
  ASSERT_TRUE(role) << role.error().text();
  EXPECT_EQ(*role, "striker1");
}

/// What is asked of each robot, and is not of the moment.
const std::vector<std::string> questions{"sr ?",
                                         "sr ImageProcessor ?",
                                         "get Player.teamColor",
                                         "get Player.playerRole",
                                         "get ImageProcessor.GT2003.denseSpacing",
                                         "set ImageProcessor.GT2003.denseSpacing 4",
                                         "get ImageProcessor.denseSpacing",
                                         "set ImageProcessor.denseSpacing 400",
                                         "set ImageProcessor.nonsense 4",
                                         "get Nonsense.value",
                                         "sr SelfLocator Poet",
                                         "sr Poet Rilke",
                                         "sr PlayersLocator disabled",
                                         "sr ?",
                                         "set PlayersCollection.time 77",
                                         "get PlayersCollection.time",
                                         "dk ImageProcessor/horizon on",
                                         "dk ImageProcessor/poem on",
                                         "dk sendPoem on",
                                         "dk sendRobotPose on",
                                         "sg ImageProcessor.GT2003 2",
                                         "get ImageProcessor.denseSpacing",
                                         "qfr replace",
                                         "graph",
                                         "get FieldDimensions.ballRadius",
                                         "lp play"};

/// The answers of one robot, with its name as ROBOT.
std::vector<std::string> answersOf(ConsoleAt& console, const std::string& name) {
  console.expectFine("robot " + name);
  // Not each number 1, if that is its name: the last one of its address.
  const std::regex named{"(^|\n|error: |\\(| of )" + name + "\\b"};
  std::vector<std::string> answers;
  for (const std::string& question : questions)
    answers.push_back(question + "\n" +
                      std::regex_replace(console.answer(question), named, "$1ROBOT"));
  return answers;
}

TEST(ThreeRobots, GiveTheSameAnswers) {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "red3.mcap").string();
  std::vector<std::string> simulated, logged, programs;
  {
    ConsoleAt console{"scenes/match.scene"};
    console.expectFine("robot red3");
    console.expectFine("run 0.2");
    console.expectFine("log start");
    console.expectFine("run 1");
    console.expectFine("log save " + log);
    console.expectFine("log stop");
    simulated = answersOf(console, "red3");
  }
  {
    ConsoleAt console{"scenes/empty.scene"};
    console.expectFine("sl LOG1 " + log);
    console.expectFine("run 0.5");
    logged = answersOf(console, "LOG1");
  }
  const testing::RobotElsewhere elsewhere{programFolder()};
  ASSERT_TRUE(elsewhere.made());
  ConsoleAt console{"scenes/empty.scene", keyOf(elsewhere)};
  console.expectFine("sc " + elsewhere.address());
  ObservedRobot& robot = console.robot(nameOf(elsewhere));
  ASSERT_TRUE(console.waitFor([&] { return robot.value<Image>() && robot.times(); }));
  programs = answersOf(console, nameOf(elsewhere));
  for (std::size_t i = 0; i < questions.size(); ++i) {
    std::printf("--- %sin the simulator, as programs, on its log: ", simulated[i].c_str());
    const bool onLog = questions[i].starts_with("lp ");
    EXPECT_EQ(programs[i], simulated[i]);
    if (onLog)
      EXPECT_THAT(simulated[i], HasSubstr("does not run on a log"));
    else
      EXPECT_EQ(logged[i], simulated[i]);
    std::printf("%s\n", programs[i] == simulated[i] && (onLog || logged[i] == simulated[i])
                            ? "the same"
                            : "different");
  }
}

}  // namespace
}  // namespace gt
