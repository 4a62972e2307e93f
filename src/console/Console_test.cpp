#include "console/Console.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "console/Commands.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Two robots without a simulator, and a clock.
class TestWorld : public ConsoleWorld {
 public:
  TestWorld() {
    const auto configuration = loadConfiguration({});
    EXPECT_TRUE(configuration) << configuration.error().text();
    for (const PlayerRole role : {PlayerRole::goalie, PlayerRole::striker1}) {
      auto robot = Robot::make(
          {*configuration, *loadLayout("layouts/cmd.layout"), {TeamColor::red, role}, 1});
      EXPECT_TRUE(robot) << robot.error().text();
      robots_.push_back(std::move(*robot));
    }
  }
  std::vector<NamedRobot> robots() override {
    return {{"red1", robots_[0].get()}, {"red4", robots_[1].get()}};
  }
  bool step() override {
    time_ = time_ + 8;
    SensorDataBuffer sensors;
    SensorData frame;
    frame.time = time_;
    sensors.push(frame);
    for (const auto& robot : robots_) {
      robot->send(sensors);
      robot->step(time_);
    }
    return time_.ms < 10'000;
  }
  Time time() const override { return time_; }
  void print(std::string_view line) override { printed.emplace_back(line); }

  Robot& robot(std::size_t i) { return *robots_[i]; }

  std::vector<std::string> printed;

 private:
  std::vector<std::unique_ptr<Robot>> robots_;
  Time time_;
};

class ConsoleTest : public ::testing::Test {
 protected:
  void expectError(const std::string& line, const std::string& field, const std::string& what) {
    const auto done = console.execute(line);
    ASSERT_FALSE(done) << line;
    EXPECT_EQ(done.error().field, field) << line;
    EXPECT_THAT(done.error().what, HasSubstr(what)) << line;
  }
  std::string solution(std::size_t robot, std::string_view task) {
    for (const auto& process : world.robot(robot).processes())
      if (process->solves(task)) return process->activeSolution(task);
    return "";
  }
  void expectFine(const std::string& line) {
    const auto done = console.execute(line);
    EXPECT_TRUE(done) << line << ": " << done.error().text();
  }

  TestWorld world;
  Console console{world};
};

TEST(Words, KeepQuotesTogether) {
  EXPECT_EQ(*splitWords("  mr  walk 1 \"a b\" \t c"), (Words{"mr", "walk", "1", "a b", "c"}));
  EXPECT_TRUE(splitWords("")->empty());
  EXPECT_FALSE(splitWords("echo \"open"));
}

TEST_F(ConsoleTest, EveryCommandHasHelp) {
  for (const Command& command : Console::commands()) {
    EXPECT_FALSE(command.help.empty());
    world.printed.clear();
    expectFine("help " + std::string{command.name});
    EXPECT_EQ(world.printed.size(), 2u) << command.name;
  }
  expectError("help nonsense", "nonsense", "no such command");
  expectError("nonsense", "nonsense", "no such command");
  expectFine("# a comment");
  expectFine("");
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
  EXPECT_THAT(world.printed, Contains("BallLocator PIDSmoothed"));
  world.printed.clear();
  expectFine("sr SelfLocator ?");
  EXPECT_THAT(world.printed, Contains("MonteCarlo"));
  EXPECT_THAT(world.printed, Contains("disabled"));
}

TEST_F(ConsoleTest, SetsDebugKeysAsTheReportDoes) {
  const DebugKey* key = DebugKey::find("ImageProcessor/percepts");
  ASSERT_NE(key, nullptr);
  const auto mode = [&] { return world.robot(0).processes()[0]->debug().keys().get(*key); };
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
  EXPECT_THAT(world.printed, Contains("ImageProcessor/percepts"));
}

TEST_F(ConsoleTest, ReadsAndSetsParametersByPath) {
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(world.printed, Contains("red1: 2"));
  expectFine("set ImageProcessor.GT2003.denseSpacing 4");
  world.printed.clear();
  expectFine("get ImageProcessor.GT2003.denseSpacing");
  EXPECT_THAT(world.printed, Contains("red4: 4"));
  const auto tooLarge = console.execute("set ImageProcessor.denseSpacing 400");
  ASSERT_FALSE(tooLarge);
  world.printed.clear();
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(world.printed, Contains("red1: 4")) << "a wrong value changes nothing";
  EXPECT_FALSE(console.execute("set ImageProcessor.nonsense 4"));
  EXPECT_FALSE(console.execute("get nonsense"));
  world.printed.clear();
  expectFine("get ?");
  EXPECT_GT(world.printed.size(), 20u);
}

TEST_F(ConsoleTest, ChangesLayouts) {
  ASSERT_EQ(world.robot(0).processes().size(), 2u);
  expectFine("layout layouts/single.layout");
  expectFine("run 0.1");
  EXPECT_EQ(world.robot(0).processes().size(), 1u);
  EXPECT_EQ(world.time(), Time{104});
  EXPECT_FALSE(console.execute("layout layouts/nonsense.layout"));
  expectError("run soon", "soon", "is no number");
}

TEST_F(ConsoleTest, FillsTheQueueToTheToolsAsAskedFor) {
  for (const char* mode : {"queue", "replace", "reject", "collect 5", "save 2.5"})
    expectFine(std::string{"qfr "} + mode);
  expectFine("qfr queue");
  for (const std::size_t i : {0u, 1u}) ASSERT_TRUE(world.robot(i).watch("OdometryData"));
  /// In bytes.
  const auto messagesAfter = [&](const std::string& line, const std::string& seconds) {
    expectFine(line);
    world.robot(0).toTools().clear();
    expectFine("run " + seconds);
    return world.robot(0).toTools().size();
  };
  expectFine("robot red1");
  EXPECT_EQ(messagesAfter("qfr reject", "0.2"), 0u);
  const std::size_t all = messagesAfter("qfr queue", "0.2");
  EXPECT_GT(all, 0u);
  const std::size_t newest = messagesAfter("qfr replace", "0.2");
  EXPECT_GT(newest, 0u);
  EXPECT_LT(newest, all / 5);
  const std::size_t collected = messagesAfter("qfr collect 0.1", "0.2");
  EXPECT_GT(collected, 0u);
  EXPECT_LT(collected, all);
  std::size_t saved = 0;
  world.robot(0).onSave([&](const MessageQueue& queue) { saved = queue.size(); });
  EXPECT_EQ(messagesAfter("qfr save 0.1", "0.05"), 0u);
  EXPECT_EQ(saved, 0u) << "not yet";
  expectFine("run 0.1");
  EXPECT_GT(saved, newest);
  EXPECT_GT(world.robot(1).toTools().size(), 0u) << "the other robot was not asked";
  expectError("qfr sometimes", "qfr", "expected: qfr queue");
  expectError("qfr collect", "qfr", "expected");
  expectError("qfr collect -1", "qfr", "expected");
}

TEST_F(ConsoleTest, SendsGenericDebugData) {
  expectFine("sg ImageProcessor/percepts 1 2.5");
  expectError("sg ImageProcessor/percepts one", "one", "is no number");
}

TEST_F(ConsoleTest, ScriptsTellFileAndLineOfTheirErrors) {
  const auto folder = std::filesystem::temp_directory_path() / "gt2003-console-test";
  std::filesystem::create_directories(folder);
  const std::string inner = (folder / "inner.con").string(),
                    outer = (folder / "outer.con").string();
  std::ofstream{inner} << "# inner\necho in\nsr BallLocator nonsense\necho never\n";
  std::ofstream{outer} << "echo out\n\ncall " << inner << "\n";
  const auto done = console.call(outer);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().file, inner);
  EXPECT_EQ(done.error().line, 3);
  EXPECT_EQ(world.printed, (std::vector<std::string>{"out", "in"}));
  std::ofstream{outer} << "call " << outer << "\n";
  EXPECT_FALSE(console.call(outer)) << "a script that calls itself";
  EXPECT_FALSE(console.call((folder / "nothing.con").string()));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gt
