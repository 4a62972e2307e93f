#include <cmath>

#include "console/Commands.h"
#include "logs/LogTransfer.h"
#include "session/ComparedRuns.h"

namespace gt {
namespace {

Result<void> saveLog(Console& console, const std::string& file) {
  const bool several = console.selected().size() > 1;
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    const std::string path =
        withDefaults(several ? file + "-" + robot.name() : file, "out/logs", ".mcap");
    if (auto done = robot.recorder.save(path); !done) return done;
    console.print(robot.name() + ": " + std::to_string(robot.recorder.messages()) +
                  " messages in " + path);
    return {};
  });
}

Result<void> log(Console& console, const Words& words) {
  if (words[1] == "save") return saveLog(console, words[2]);
  const std::string& what = words[1];
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (what == "start") return robot.recorder.start();
    if (what == "stop") robot.recorder.stop();
    if (what == "clear") robot.recorder.clear();
    return {};
  });
}

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

void printPlace(Console& console, ConsoleRobot& robot) {
  const LogPlayer& player = robot.onLog()->player();
  const auto seconds = [&](Time time) { return decimal(static_cast<double>(time.ms) / 1000); };
  console.print(robot.name() + ": at " + seconds(player.now()) + " of " + seconds(player.begin()) +
                " to " + seconds(player.end()) + " s, moment " + std::to_string(player.position()) +
                " of " + std::to_string(player.moments().size()) + ", " +
                (!player.playing()                ? "is paused"
                 : player.time() < player.begin() ? "waits for its begin"
                                                  : "plays") +
                ", speed " + decimal(player.speed()) + (player.loop() ? ", loops" : ""));
}

/// lp cut FILE FROM TO, and lp join FILE LOG {LOG}: of the log that a robot runs on.
Result<void> transfer(Console& console, ConsoleRobot& robot, const Words& words) {
  const std::string out = withDefaults(words[2], "out/logs", ".mcap");
  const std::string& log = robot.onLog()->player().path();
  Result<Transferred> done = Transferred{};
  if (words[1] == "cut") {
    Selection selection;
    for (const auto& [bound, word] : {std::pair{&selection.from, 3}, std::pair{&selection.to, 4}}) {
      const auto number = numberOf(words[static_cast<std::size_t>(word)]);
      if (!number) return number.error();
      *bound = *number;
    }
    done = cutLog(log, selection, out);
  } else {
    std::vector<std::string> logs{log};
    for (std::size_t i = 3; i < words.size(); ++i)
      logs.push_back(withDefaults(words[i], "out/logs", ".mcap"));
    done = joinLogs(logs, out);
  }
  if (!done) return done.error();
  for (const Error& lost : done->lost) console.print(lost.text());
  console.print(out + ": " + std::to_string(done->messages) + " messages");
  return {};
}

/// Executes `lp` for one robot on a log.
Result<void> playLog(Console& console, ConsoleRobot& robot, const Words& words) {
  LogRobot& log = *robot.onLog();
  const auto take = [&](const MessageQueue& messages) { robot.take(messages); };
  const std::string& what = words[1];
  if (what == "cut" || what == "join") return transfer(console, robot, words);
  if (what == "loop") {
    log.player().setLoop(words[2] == "on");
    return {};
  }
  if (what == "play" || what == "pause" || what == "?") {
    if (what == "play") log.player().play();
    if (what == "pause") log.player().pause();
    if (what == "?") printPlace(console, robot);
    return {};
  }
  const bool step = what == "step" || what == "back";
  const auto number = words.size() == 3 ? numberOf(words[2], 0, 1e9) : Result<double>{1.0};
  if (!number) return number.error();
  Result<void> done = wrongArguments(words);
  if (step) done = log.step(static_cast<int>(what == "back" ? -*number : *number), take);
  if (what == "time")
    done = done = log.goToTime(
        console.session().timeOnLog(log.player(), Time{std::llround(1000 * *number)}), take);
  if (what == "message") done = log.goToMessage(static_cast<std::uint64_t>(*number), take);
  if (what == "speed" && *number > 0) {
    log.player().setSpeed(*number);
    return {};
  }
  if (done) printPlace(console, robot);
  return done;
}

Result<void> lp(Console& console, const Words& words) {
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (!robot.onLog()) return Error{.field = robot.name(), .what = "does not run on a log"};
    return playLog(console, robot, words);
  });
}

/// compare LOG LOG, or LOG TASK SOLUTION SOLUTION.
Result<void> compare(Console& console, const Words& words) {
  ComparedRun a{withDefaults(words[1], "out/logs", ".mcap")}, b = a;
  if (words.size() == 3) {
    b.log = withDefaults(words[2], "out/logs", ".mcap");
  } else {
    a.replayed = b.replayed = true;
    a.task = b.task = words[2];
    a.solution = words[3];
    b.solution = words[4];
  }
  Session& session = console.session();
  const auto comparison =
      compareRuns(a, b, session.logOptions(), [&](double) { return !session.takeInterrupt(); });
  if (!comparison) return comparison.error();
  list(console, linesOf(*comparison));
  return {};
}

std::vector<std::string> compareChoices(Console&, const Words& before) {
  const auto tasks = allSolutions();
  std::vector<std::string> names;
  if (before.size() == 2)
    for (const auto& [task, solutions] : tasks) names.push_back(task);
  const auto task = before.size() > 2 ? tasks.find(before[2]) : tasks.end();
  return task == tasks.end() ? names : task->second;
}

}  // namespace

std::vector<Command> logCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {
      {Command::Kind::global, "compare", "LOG (LOG | TASK SOLUTION SOLUTION)",
       "Compares two logs at the same times, or what one log's robot computes with one solution "
       "of a task and with another. Prints which representations differ, how often, and where "
       "first.",
       compare, compareChoices},
      {kind, "log", "start | stop | clear | save FILE",
       "Records all that comes from the robots, with all that it takes to replay that; saves it to "
       "out/logs/ and with .mcap if the file has no folder and extension. Several robots get a "
       "file each.",
       log},
      {kind, "lp",
       "? | play | pause | step [NUMBER] | back [NUMBER] | time SECONDS | message NUMBER | speed "
       "FACTOR | loop (off | on) | cut FILE FROM TO | join FILE LOG {LOG}",
       "Log player: plays the logs that robots run from while time passes, forward and back by "
       "what was recorded at one time, from a time or message on, faster; prints where it is. "
       "Cuts some seconds out of the log, or joins others to it.",
       lp}};
}

}  // namespace gt
