#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "console/Console.h"
#include "match/Match.h"
#include "robot/Solutions.h"
#include "streams/File.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// A match as the world of a console.
class MatchWorld : public ConsoleWorld {
 public:
  explicit MatchWorld(Match& match) : match_{match} {}
  std::vector<NamedRobot> robots() override {
    std::vector<NamedRobot> robots;
    for (SimulatedRobot* robot : match_.robots())
      robots.push_back({robot->name(), &robot->robot()});
    return robots;
  }
  bool step() override {
    match_.step();
    return !match_.finished();
  }
  Time time() const override { return match_.time(); }
  void print(std::string_view) override {}

 private:
  Match& match_;
};

enum class Way { console, message };

/// A running match, of which one robot is changed.
class Switching : public testing::TestWithParam<Way> {
 protected:
  Switching() {
    fs::create_directories(folder_);
    MatchOptions options;
    options.scene = "scenes/match.scene";
    options.minutes = 2;
    options.logs = folder_.string();
    auto made = Match::make(options);
    EXPECT_TRUE(made) << made.error().text();
    match_ = std::move(*made);
    world_ = std::make_unique<MatchWorld>(*match_);
    console_ = std::make_unique<Console>(*world_);
    EXPECT_TRUE(console_->execute("robot red2"));
    run(80);
  }
  ~Switching() override { fs::remove_all(folder_); }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) match_->step();
  }
  Robot& robot(std::size_t i) { return match_->robots()[i]->robot(); }
  Robot& changed() { return robot(1); }
  template <typename Request>
  void ask(const std::string& line, const Request& request) {
    if (GetParam() == Way::console) {
      const auto done = console_->execute(line);
      EXPECT_TRUE(done) << line << ": " << done.error().text();
    } else
      changed().fromTools().write(match_->time(), request);
    run(6);
  }
  static std::string solution(Robot& robot, std::string_view task) {
    for (const auto& process : robot.processes())
      if (process->solves(task)) return std::string{process->activeSolution(task)};
    return "";
  }
  static std::string parameter(Robot& robot) {
    for (const auto& process : robot.processes())
      if (process->solves("ImageProcessor"))
        return *process->parameter("ImageProcessor", "GT2003", "denseSpacing");
    return "";
  }
  void switchTo(const std::string& task, const std::string& solution) {
    ask("sr " + task + " " + solution, SolutionRequest{task, solution});
    EXPECT_EQ(this->solution(changed(), task), solution) << task;
  }
  void expectOthersAsTheyWere(const std::string& task, const std::string& solution) {
    for (std::size_t i = 0; i < match_->robots().size(); ++i)
      if (i != 1) {
        EXPECT_EQ(this->solution(robot(i), task), solution) << task << " of robot " << i;
      }
  }
  int savedFiles() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator{folder_})
      count += entry.path().filename().string().find(".saved") != std::string::npos;
    return count;
  }

  fs::path folder_ = fs::temp_directory_path() / ("gt2003-switching-" + std::to_string(getpid()));
  std::unique_ptr<Match> match_;
  std::unique_ptr<MatchWorld> world_;
  std::unique_ptr<Console> console_;
};

TEST_P(Switching, EveryTaskToEverySolutionAndBack) {
  int switches = 0;
  for (const auto& [name, task] : solutions().tasks()) {
    const std::string before = solution(changed(), name);
    if (before.empty()) continue;  // the layout has it not
    for (const Solution& other : task.solutions) switchTo(name, other.name);
    switchTo(name, "disabled");
    expectOthersAsTheyWere(name, solution(robot(0), name));
    EXPECT_EQ(solution(robot(0), name), before);
    switchTo(name, before);
    ++switches;
  }
  EXPECT_GE(switches, 10);
}

TEST_P(Switching, ParametersArrive) {
  ASSERT_EQ(parameter(changed()), "2");
  ask("set ImageProcessor.GT2003.denseSpacing 4",
      ParameterRequest{"ImageProcessor", "GT2003", "denseSpacing", "4"});
  EXPECT_EQ(parameter(changed()), "4");
  for (std::size_t i = 0; i < match_->robots().size(); ++i)
    if (i != 1) {
      EXPECT_EQ(parameter(robot(i)), "2") << i;
    }
}

TEST_P(Switching, LayoutsKeepWhatWasSwitched) {
  switchTo("BallLocator", "disabled");
  ask("set ImageProcessor.GT2003.denseSpacing 4",
      ParameterRequest{"ImageProcessor", "GT2003", "denseSpacing", "4"});
  for (const auto& [file, processes] :
       {std::pair{"layouts/single.layout", 1u}, std::pair{"layouts/pmbm.layout", 4u},
        std::pair{"layouts/cmd.layout", 2u}}) {
    ask(std::string{"layout "} + file, LayoutRequest{file, *readFile(file)});
    EXPECT_EQ(changed().processes().size(), processes) << file;
    EXPECT_EQ(solution(changed(), "BallLocator"), "disabled") << file;
    EXPECT_EQ(parameter(changed()), "4") << file;
    EXPECT_EQ(robot(0).layoutChanges(), 0);
  }
  EXPECT_EQ(changed().layoutChanges(), 3);
  EXPECT_FALSE(match_->finished());
}

TEST_P(Switching, SavedMessagesBecomeALogThatCanBeRead) {
  ask("qfr save 0.4", QueueFillRequest{QueueFillMode::save, 0.4});
  EXPECT_EQ(savedFiles(), 0) << "still collecting";
  ask("layout layouts/single.layout",
      LayoutRequest{"single", *readFile("layouts/single.layout")});  // does not lose them
  run(60);
  ASSERT_EQ(savedFiles(), 1) << "of this robot, not of the others";
  auto log = McapReader::open((folder_ / "red2.saved.mcap").string());
  ASSERT_TRUE(log) << log.error().text();
  EXPECT_TRUE(log->complete());
  int messages = 0;
  for (auto message = log->next(); message && *message; message = log->next()) ++messages;
  EXPECT_GT(messages, 20);
  ask("qfr save 0.1", QueueFillRequest{QueueFillMode::save, 0.1});
  run(20);
  EXPECT_EQ(savedFiles(), 2) << "no log is written over";
}

INSTANTIATE_TEST_SUITE_P(Both, Switching, testing::Values(Way::console, Way::message),
                         [](const auto& way) {
                           return way.param == Way::console ? "ByConsole" : "ByMessage";
                         });

}  // namespace
}  // namespace gt
