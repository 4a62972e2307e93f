#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>

#include "base/File.h"
#include "base/InParallel.h"
#include "console/Commands.h"
#include "console/Condition.h"

namespace gt {
namespace {

constexpr double mostRuns = 100'000;

/// A screen that discards its output.
class NoScreen : public Screen {
 public:
  void print(std::string_view) override {}
};

/// The result of one of many runs.
struct Outcome {
  int run = 0;  ///< From 1.
  std::uint64_t seed = 0;
  std::string result;  ///< Which target, timeout, or who has won.
  double seconds = 0;
  int red = 0, blue = 0;
  Vector2d ball = Vector2d::Zero();
};

/// The simulation that is run many times: the scene with other seeds, and all interventions in this
/// simulation at their times.
struct Series {
  MatchOptions options;
  std::vector<Intervention> history;
  Time begin;  ///< How far this simulation has come.
  int runs = 1;
  double timeout = 0;  ///< s; 0: until the game is over.
  std::vector<std::string> targetTexts;
  std::vector<Condition> targets;
  std::function<bool()> interrupted;
};

Result<std::string> reached(const Series& series, Console& console) {
  for (std::size_t i = 0; i < series.targets.size(); ++i) {
    const auto holds = series.targets[i].holds(console);
    if (!holds) return holds.error();
    if (*holds) return series.targetTexts[i];
  }
  return std::string{};
}

std::string winner(const Outcome& outcome) {
  return outcome.red > outcome.blue ? "red" : outcome.red < outcome.blue ? "blue" : "draw";
}

Result<Outcome> runOnce(const Series& series, int index) {
  NoScreen screen;
  MatchOptions options = series.options;
  options.seed += static_cast<std::uint64_t>(index);
  options.threads = 1;
  options.logs.clear();
  options.images = 0;
  auto session = Session::make(options, screen);
  if (!session) return session.error();
  Console console{**session};
  const auto repeated = (*session)->match().repeat(
      series.history, series.begin,
      [&](Match&, const std::string& line) { return console.executeWithin(line); },
      series.interrupted);
  if (!repeated && !(*session)->match().finished()) return repeated.error();
  Outcome outcome;
  outcome.run = index + 1;
  outcome.seed = options.seed;
  // A game lasts from its beginning on.
  const Time begin = series.targets.empty() ? Time{} : series.begin;
  const auto end = static_cast<std::int64_t>(std::llround(1000 * series.timeout));
  while (outcome.result.empty()) {
    if (series.interrupted()) return Error{.what = "stopped"};
    auto target = reached(series, console);
    if (!target) return target.error();
    outcome.result = std::move(*target);
    if (!outcome.result.empty()) break;
    if ((end > 0 && (*session)->time() - begin >= end) || (*session)->match().finished() ||
        !(*session)->step())
      break;
  }
  if (const auto done = (*session)->match().soundness(); !done) return done.error();
  const Simulation& simulation = (*session)->simulation();
  outcome.seconds = static_cast<double>((*session)->time() - begin) / 1000;
  outcome.red = simulation.referee().score(TeamColor::red);
  outcome.blue = simulation.referee().score(TeamColor::blue);
  if (simulation.world().ballCount() > 0) outcome.ball = simulation.world().ball(0).position;
  if (outcome.result.empty()) outcome.result = series.targets.empty() ? winner(outcome) : "timeout";
  return outcome;
}

/// The results of many runs.
struct Outcomes {
  std::vector<Outcome> ended;  ///< In the order of their seeds.
  std::optional<Error> error;  ///< After which no more were begun.
};

/// Executes the runs, distributed over the threads; the order of the results does not depend on
/// that.
Outcomes runAll(const Series& series) {
  Outcomes all;
  std::mutex mutex;  // of the error
  std::atomic<bool> failed = false;
  auto results =
      inParallel(static_cast<std::size_t>(series.runs),
                 static_cast<unsigned>(std::min<std::size_t>(series.options.threads, 64)),
                 [&](std::size_t i) -> Result<Outcome> {
                   if (failed) return Error{.what = "was not begun"};
                   auto outcome = guarded([&] { return runOnce(series, static_cast<int>(i)); });
                   if (outcome || failed.exchange(true)) return outcome;
                   const std::lock_guard lock{mutex};
                   all.error = outcome.error();
                   return outcome;
                 });
  for (Result<Outcome>& result : results)
    if (result) all.ended.push_back(*std::move(result));
  return all;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  return result + "\"";
}

Result<void> writeCsv(const std::string& file, const std::vector<Outcome>& outcomes) {
  std::string text = "run,seed,result,seconds,red,blue,ballX,ballY\n";
  for (const Outcome& o : outcomes) {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, ",%.3f,%d,%d,%.1f,%.1f\n", o.seconds, o.red, o.blue,
                  o.ball.x(), o.ball.y());
    text += std::to_string(o.run) + "," + std::to_string(o.seed) + "," + quoted(o.result) + numbers;
  }
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  return writeFile(file, text);
}

void printSummary(Console& console, const std::vector<Outcome>& outcomes) {
  std::map<std::string, std::pair<int, double>> results;
  int red = 0, blue = 0;
  for (const Outcome& outcome : outcomes) {
    auto& [count, seconds] = results[outcome.result];
    ++count;
    seconds += outcome.seconds;
    red += outcome.red;
    blue += outcome.blue;
  }
  char line[64];
  for (const auto& [result, sum] : results) {
    std::snprintf(line, sizeof line, ": %d of %zu, after %.1f s", sum.first, outcomes.size(),
                  sum.second / sum.first);
    console.print(result + line);
  }
  console.print("goals red " + std::to_string(red) + " : " + std::to_string(blue) + " blue");
}

/// A last word that names a CSV file.
std::optional<std::string> takeFile(std::vector<std::string>& words) {
  if (!words.back().ends_with(".csv")) return std::nullopt;
  std::string file = withDefaults(words.back(), "out", ".csv");
  words.pop_back();
  return file;
}

constexpr std::pair<Posture, const char*> thrown[] = {{Posture::onLeftSide, "left"},
                                                      {Posture::onRightSide, "right"},
                                                      {Posture::onNose, "nose"},
                                                      {Posture::onBack, "back"},
                                                      {Posture::sitting, "sitting"}};

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Commands that restore the present situation: game, robots and balls.
std::string situationOf(Console& console) {
  Session& session = console.session();
  Simulation& simulation = session.simulation();
  const Referee& referee = simulation.referee();
  const World& world = simulation.world();
  // A scene of ours is named so that the test also works elsewhere.
  const std::filesystem::path path = std::filesystem::absolute(session.options().scene);
  std::error_code failed;
  const bool ours = std::filesystem::equivalent(path.parent_path(),
                                                session.options().root.path("scenes"), failed);
  const std::string scene = ours ? path.stem().string() : path.string();
  std::string text =
      formatted("# What was on the field at %.3f s.\n",
                static_cast<double>(session.time().ms) / 1000) +
      "scene \"" + scene + "\"\nseed " + std::to_string(session.options().seed) + "\n" +
      formatted("gc kickOff %s %d %d\n", std::string{enumName(referee.kickOff())}.c_str(),
                referee.score(TeamColor::blue), referee.score(TeamColor::red));
  // A kick-off is prepared by gc kickOff itself.
  const std::pair<GameState, const char*> orders[] = {{GameState::initial, "reset"},
                                                      {GameState::ready, "ready"},
                                                      {GameState::playing, "playing"},
                                                      {GameState::finished, "final"}};
  for (const auto& [state, order] : orders)
    if (referee.state() == state) text += std::string{"gc "} + order + "\n";
  const auto robots = simulation.scene().allRobots();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const RobotBody& body = world.robot(i);
    const std::string& name = robots[i]->name;
    text += formatted("place %s %.1f %.1f %.1f\n", name.c_str(), body.pose.translation.x(),
                      body.pose.translation.y(), toDegrees(body.pose.rotation));
    for (const auto& [posture, how] : thrown)
      if (body.posture == posture) text += "throw " + name + " " + how + "\n";
  }
  for (std::size_t i = 0; i < world.ballCount(); ++i) {
    const BallState& ball = world.ball(i);
    text += formatted("place ball%zu %.1f %.1f %.1f %.1f\n", i, ball.position.x(),
                      ball.position.y(), ball.speed.x(), ball.speed.y());
  }
  return text;
}

/// test save SCRIPT [SECONDS CONDITION]
Result<void> saveSituation(Console& console, const Words& words) {
  std::string text = situationOf(console);
  if (words.size() > 4) {
    const auto seconds = numberOf(words[3], 0.008, 1e6);
    if (!seconds) return seconds.error();
    if (const auto condition = Condition::parse(words[4]); !condition) return condition.error();
    text += "until " + words[4] + " within " + words[3] + "\n";
  }
  const std::string file = withDefaults(words[2], "out/tests", ".con");
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  if (auto done = writeFile(file, text); !done) return done;
  printWritten(console, file);
  return {};
}

Result<void> test(Console& console, const Words& words) {
  if (words.size() > 2 && words[1] == "save") return saveSituation(console, words);
  std::vector<std::string> rest{words.begin(), words.end()};
  const std::string file = takeFile(rest).value_or("out/test.csv");
  if (rest.size() < 3) return wrongArguments(words);
  Session& session = console.session();
  Series series{session.options(), session.match().history(), session.time(), 1, 0, {}, {}, {}};
  std::atomic<bool> interrupted = false;
  series.interrupted = [&] {
    if (session.takeInterrupt()) interrupted = true;
    return interrupted.load();
  };
  const auto runs = numberOf(rest[2], 1, mostRuns);
  if (!runs) return runs.error();
  if (*runs != std::floor(*runs)) return wrongArguments(words);
  series.runs = static_cast<int>(*runs);
  if (rest[1] == "game" && rest.size() == 3) {
  } else if (rest[1] == "situation" && rest.size() > 4) {
    const auto timeout = numberOf(rest[3], 0.008, 1e6);
    if (!timeout) return timeout.error();
    series.timeout = *timeout;
    for (std::size_t i = 4; i < rest.size(); ++i) {
      auto target = Condition::parse(rest[i]);
      if (!target) return target.error();
      series.targets.push_back(std::move(*target));
      series.targetTexts.push_back(rest[i]);
    }
  } else {
    return wrongArguments(words);
  }
  const Outcomes outcomes = runAll(series);
  if (outcomes.error && outcomes.ended.empty()) return *outcomes.error;
  printSummary(console, outcomes.ended);
  if (auto done = writeCsv(file, outcomes.ended); !done) return done;
  console.print("results: " + file);
  return outcomes.error ? Result<void>{*outcomes.error} : Result<void>{};
}

}  // namespace

std::vector<Command> testCommands() {
  return {{Command::Kind::global, "test",
           "game N [TABLE] | situation N TIMEOUT CONDITION {CONDITION} [TABLE] | save TEST "
           "[SECONDS CONDITION]",
           "Plays N games, or N times up to TIMEOUT seconds until one of the conditions holds (in "
           "quotes if it has spaces), each with the next seed. Each plays up to now first, and all "
           "that was done so far is done at its time; only then TIMEOUT begins. Prints how they "
           "ended; the results go to a table (.csv), out/test.csv if "
           "none is "
           "named. Or saves what is on the field now, with score and state of the game, as a "
           "script that puts it up again and fails if the condition does not hold within SECONDS; "
           "to out/tests/ and with .con if the file has no folder and extension.",
           test, valueChoices}};
}

}  // namespace gt
