#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/File.h"
#include "console/Console.h"
#include "debug/Drawing.h"
#include "match/Match.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/BehaviorState.h"
#include "robot/Solutions.h"
#include "streams/Binary.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Prints nothing.
class NoScreen : public Screen {
 public:
  void print(std::string_view) override {}
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
    auto made = Session::make(options, screen_);
    EXPECT_TRUE(made) << made.error().text();
    session_ = std::move(*made);
    match_ = &session_->match();
    console_ = std::make_unique<Console>(*session_);
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
  NoScreen screen_;
  std::unique_ptr<Session> session_;
  Match* match_ = nullptr;
  std::unique_ptr<Console> console_;
};

TEST_P(Switching, EveryTaskToEverySolutionAndBack) {
  ASSERT_TRUE(console_->execute("so on")) << "for solutions that read the truth";
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
  while (const auto message = log->next()) ++messages;
  EXPECT_GT(messages, 20);
  ask("qfr save 0.1", QueueFillRequest{QueueFillMode::save, 0.1});
  run(20);
  EXPECT_EQ(savedFiles(), 2) << "no log is written over";
}

/// A robot that plays on while somebody edits a copy of its behavior.
class Editing : public Switching {
 protected:
  Editing() {
    fs::copy("behavior", copy_, fs::copy_options::recursive);
    EXPECT_TRUE(
        changed().request(DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0}));
    run(250);
  }

  void write(const std::string& file, const std::string& text) {
    EXPECT_TRUE(writeFile((copy_ / file).string(), text));
  }
  void replace(const std::string& file, const std::string& old, const std::string& text) {
    std::string all = *readFile((copy_ / file).string());
    ASSERT_NE(all.find(old), std::string::npos) << file;
    write(file, all.replace(all.find(old), old.size(), text));
  }

  /// Asks the robot to go on with the copy: to read it, or with all of it in a message.
  Result<void> reload() {
    const std::string path = (copy_ / "GT2003.xabsl").string();
    if (GetParam() == Way::console) return console_->execute("behavior " + path);
    BehaviorRequest request{path, {}};
    for (const auto& entry : fs::recursive_directory_iterator{copy_})
      if (entry.path().extension() == ".xabsl")
        request.files.push_back({entry.path().string(), *readFile(entry.path().string())});
    EXPECT_GT(request.files.size(), 10u);
    fs::remove_all(copy_ / "symbols");  // the robot has no such files
    changed().fromTools().write(match_->time(), request);
    return {};
  }

  struct Logged {
    std::vector<std::pair<std::int64_t, BehaviorState>> states;  // with the time in ms
    std::string texts;
  };
  /// What the robot wrote to its log, once the match is over.
  Logged logged() {
    EXPECT_TRUE(match_->close());
    Logged found;
    auto log = McapReader::open((folder_ / "red2.mcap").string());
    EXPECT_TRUE(log) << log.error().text();
    while (const auto message = log->next()) {
      const std::string& topic = log->channel(message->channel)->topic;
      BehaviorState state;
      Text text;
      if (topic == "/BehaviorState" && decode(message->data, state))
        found.states.emplace_back(message->time / 1'000'000, std::move(state));
      if (topic == "/Text" && decode(message->data, text)) found.texts += text.text + "\n";
      RequestAnswer answer;
      if (topic == "/RequestAnswer" && decode(message->data, answer))
        found.texts += answer.what + "\n";
    }
    return found;
  }

  static const BehaviorState::Activation* find(const BehaviorState& state,
                                               const std::string& name) {
    for (const auto& activation : state.activations)
      if (activation.name == name) return &activation;
    return nullptr;
  }

  fs::path copy_ = folder_ / "behavior";
};

TEST_P(Editing, TheRobotPlaysOn) {
  // An option of its own, called by the root option.
  const std::string greet =
      "option greet {\n  initial state hello {\n    action { led.middle_left = on; }\n  }\n}\n";
  write("options/greet.xabsl", greet);
  replace("GT2003.xabsl", "include \"options/roles/playing.xabsl\";",
          "include \"options/roles/playing.xabsl\";\ninclude \"options/greet.xabsl\";");
  replace("options/play_soccer.xabsl", "show_role();", "show_role();\n    greet();");
  const std::int64_t edited = match_->time().ms;
  ASSERT_TRUE(reload());
  run(100);
  fs::copy("behavior/symbols", copy_ / "symbols",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);

  // An edit with an error, in the third line.
  std::string wrong = greet;
  write("options/greet.xabsl", wrong.replace(wrong.find("on;"), 3, "sparkling;"));
  const auto refused = reload();
  run(100);
  const Logged log = logged();
  const std::string message = GetParam() == Way::console ? refused.error().text() : log.texts;
  EXPECT_NE(message.find("options/greet.xabsl:3"), std::string::npos) << message;
  EXPECT_NE(message.find("sparkling"), std::string::npos) << message;

  ASSERT_GT(log.states.size(), 60u);
  const std::pair<std::int64_t, BehaviorState>* before = nullptr;
  std::size_t continued = 0;
  for (const auto& now : log.states) {
    const auto* root = find(now.second, "play_soccer");
    ASSERT_TRUE(root);
    if (now.first <= edited || now.first > edited + 40) {
      EXPECT_EQ(find(now.second, "greet") != nullptr, now.first > edited) << now.first;
    }
    if (before)
      for (const auto& option : now.second.activations) {
        const auto* old = find(before->second, option.name);
        if (!old || option.state.empty()) continue;
        EXPECT_EQ(option.optionTime - old->optionTime, now.first - before->first) << option.name;
        if (option.state == old->state) {
          EXPECT_EQ(option.stateTime - old->stateTime, now.first - before->first);
        }
        ++continued;
      }
    before = &now;
  }
  EXPECT_GT(continued, 2 * log.states.size());
  EXPECT_GT(find(log.states.back().second, "play_soccer")->optionTime, 2000);
  EXPECT_FALSE(find(log.states.back().second, "greet")->state.empty());
}

INSTANTIATE_TEST_SUITE_P(Both, Editing, testing::Values(Way::console, Way::message),
                         [](const auto& way) {
                           return way.param == Way::console ? "ByConsole" : "ByMessage";
                         });

INSTANTIATE_TEST_SUITE_P(Both, Switching, testing::Values(Way::console, Way::message),
                         [](const auto& way) {
                           return way.param == Way::console ? "ByConsole" : "ByMessage";
                         });

}  // namespace
}  // namespace gt
