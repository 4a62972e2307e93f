#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/File.h"
#include "base/Number.h"
#include "base/TemporaryFolder.h"
#include "console/Commands.h"
#include "console/Condition.h"
#include "match/MatchState.h"
#include "streams/Json.h"
#include "views/ViewText.h"

namespace gt {
namespace {

/// Longest time (simulated s) for which `until` waits if none is stated.
constexpr double untilAtMost = 600;
constexpr double longest = 1e6;  // s

/// Parses a duration behind a command: 30, 30 s, 30s, 500 ms, 2 min or 10 steps. Returns it in ms.
Result<std::int64_t> durationOf(const Words& words) {
  std::string digits = words[1], unit = "s";
  if (words.size() == 3) {
    unit = words[2];
  } else if (const auto end = digits.find_first_not_of("+-.0123456789e");
             end != digits.npos && end > 0) {
    unit = digits.substr(end);
    digits.resize(end);
  }
  const auto number = numberOf(digits, 0, longest);
  if (!number) return number.error();
  const double ms = unit == "s"                         ? 1000
                    : unit == "ms"                      ? 1
                    : unit == "min"                     ? 60000
                    : unit == "steps" || unit == "step" ? static_cast<double>(tickMs)
                                                        : 0;
  if (ms == 0)
    return Error{.field = unit, .what = "is no unit of time: expected s, ms, min or steps"};
  return std::llround(*number * ms);
}

/// Lets time pass until `done` returns true, or the game is over. An error if a person stops it, or
/// if no time can pass.
Result<void> pass(Console& console, const std::string& command, const std::function<bool()>& done) {
  Session& session = console.session();
  session.stop();
  const Time begin = session.time();
  const Session::RunEnd end = session.run(done);
  if (end == Session::RunEnd::interrupted)
    return Error{.field = command, .what = "stopped at " + clockText(session.time())};
  if (end == Session::RunEnd::gameOver && session.time() == begin)
    return Error{.field = command,
                 .what = "the game is over, so no time passes; gc ready or reset begins anew"};
  if (end == Session::RunEnd::gameOver)
    console.print(clockText(session.time()) + "  the game is over, so no more time passes");
  return {};
}

Result<void> passTime(Console& console, const std::string& command, std::int64_t ms) {
  const Time end = console.session().time() + ms;
  return pass(console, command, [&] { return console.session().time() >= end; });
}

Result<void> run(Console& console, const Words& words) {
  const auto ms = durationOf(words);
  return ms ? passTime(console, "run", *ms) : ms.error();
}

Result<void> step(Console& console, const Words& words) {
  const auto steps = words.size() == 2 ? numberOf(words[1], 0, 1e9) : Result<double>{1};
  if (!steps) return steps.error();
  if (*steps != std::floor(*steps)) return wrongArguments(words);
  return passTime(console, "step", std::llround(*steps) * tickMs);
}

Result<void> start(Console& console, const Words&) {
  console.session().start();
  return {};
}

Result<void> stop(Console& console, const Words&) {
  console.session().stop();
  return {};
}

/// The present pace of time, as a command that sets it.
std::string paceLine(const Pace& pace) {
  if (pace.slowness > 0) return "st off " + numberText(pace.slowness);
  return pace.factor > 0 ? "st on " + numberText(pace.factor) : "st on";
}

Result<void> st(Console& console, const Words& words) {
  Pace pace;
  if (words[1] == "?") {
    console.print(paceLine(console.session().pace()));
    return {};
  }
  if (words[1] == "on") {
    if (words.size() == 3) {
      const auto factor = numberOf(words[2], 0.01, 1000);
      if (!factor) return factor.error();
      pace.factor = *factor;
    }
  } else {
    pace = {1, 1};
    if (words.size() == 3) {
      const auto slowness = numberOf(words[2], 0.01, 1e6);
      if (!slowness) return slowness.error();
      pace.slowness = *slowness;
    }
  }
  console.session().setPace(pace);
  return {};
}

/// The condition in a line, and the seconds behind its last `within`, if any.
struct Waiting {
  Condition condition;
  double seconds = untilAtMost;
};

Result<Waiting> waitingOf(const Words& words) {
  std::string text = words.rest;
  Waiting waiting;
  if (words.size() > 3 && words[words.size() - 2] == "within") {
    const auto seconds = numberOf(words.back(), 0, longest);
    if (!seconds) return seconds.error();
    waiting.seconds = *seconds;
    text = text.substr(0, text.rfind("within"));
  }
  auto condition = Condition::parse(text);
  if (!condition) return condition.error();
  waiting.condition = std::move(*condition);
  return waiting;
}

Result<void> until(Console& console, const Words& words) {
  const auto waiting = waitingOf(words);
  if (!waiting) return waiting.error();
  const Time end = console.session().time() + std::llround(1000 * waiting->seconds);
  Result<bool> holds = false;
  const auto done = pass(console, "until", [&] {
    holds = waiting->condition.holds(console);
    return !holds || *holds || console.session().time() >= end;
  });
  if (!done) return done;
  if (!holds) return holds.error();
  if (*holds) return {};
  console.failExpectation();
  return Error{.field = "until", .what = "did not come true: " + words.rest};
}

/// Restarts the session as at the program's start: with the scene's script (report I.4).
Result<void> restart(Console& console, const MatchOptions& options) {
  if (auto done = console.session().restart(options); !done) return done;
  console.forget();
  return console.callStartScript();
}

Result<void> seed(Console& console, const Words& words) {
  const auto number = numberOf(words[1], 0, 9e15);
  if (!number) return number.error();
  MatchOptions options = console.session().options();
  options.seed = static_cast<std::uint64_t>(*number);
  return restart(console, options);
}

Result<void> scene(Console& console, const Words& words) {
  MatchOptions options = console.session().options();
  options.scene = dataFile(console, words[1], "scenes", ".scene");
  return restart(console, options);
}

Result<void> reset(Console& console, const Words&) {
  return restart(console, console.session().options());
}

Result<void> save(Console& console, const Words& words) {
  const std::string file = withDefaults(words[1], "out/states", ".state");
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  if (auto done = console.session().match().save(file); !done) return done;
  printWritten(console, file);
  return {};
}

Result<void> loadFile(Console& console, const std::string& file) {
  const auto selection = console.selection();
  console.select({});
  console.forgetBehavior();
  const auto done = console.session().load(file, [&](const std::string& line) -> Result<void> {
    const Command* command = Console::find(line.substr(0, line.find(' ')));
    if (!command || !command->changes)
      return Error{.field = line, .what = "is no command that changes something"};
    return console.execute(line);
  });
  if (!done) {
    console.select(selection);
    console.forgetBehavior();
    return done;
  }
  const auto loaded = console.selection();
  console.forget();
  console.select(loaded);
  return {};
}

Result<void> load(Console& console, const Words& words) {
  return loadFile(console, withDefaults(words[1], "out/states", ".state"));
}

Result<void> rewindTo(Console& console, const Words& words) {
  const auto time = durationOf(words);
  if (!time) return time.error();
  if (Time{*time} >= console.session().time())
    return Error{
        .field = words[1],
        .what = "is not past: it is " + std::to_string(console.session().time().ms) + " ms"};
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "past.state").string();
  if (auto done = console.session().match().save(file); !done) return done;
  auto state = readMatchState(file);
  if (!state) return state.error();
  state->time = Time{*time / tickMs * tickMs};
  state->fingerprint = 0;  // nobody knows it
  std::erase_if(state->history, [&](const Intervention& done) { return done.time > state->time; });
  if (auto done = writeFile(file, jsonText(*state)); !done) return done;
  const bool passes = console.session().started();
  console.session().stop();
  auto done = loadFile(console, file);
  if (!done && passes) console.session().start();
  return done;
}

}  // namespace

std::vector<Command> timeCommands() {
  using enum Command::Kind;
  return {
      {global, "load", "STATE", "Resumes a simulation from where it was saved.", load},
      {global, "reset", "", "Restarts, with the same scene, its script, and the same seed.", reset},
      {global, "rewind", "TIME [s | ms | min | steps]",
       "Goes back in time, to so much time after the begin: the same scene and seed begin anew, "
       "and "
       "all is done again that was done until then. Robots on logs and elsewhere are gone.",
       rewindTo},
      {global, "run", "TIME [s | ms | min | steps]",
       "Lets simulated time pass; TIME may also have its unit behind it: 30s. Ctrl-C stops it, and "
       "all is kept.",
       run},
      {global, "save", "STATE",
       "Saves the state of the simulation: scene, seed and all that was done since, which is done "
       "again when it is loaded. To out/states/ and with .state if the file has no folder and "
       "extension.",
       save},
      {global, "scene", "SCENE", "Begins with another scene, and its script.", scene},
      {global, "seed", "NUMBER", "Restarts with another seed.", seed},
      {global, "st", "? | off [SLOWNESS] | on [FACTOR]",
       "Simulated time, on by default: each step advances it by 8 ms, as fast as it goes or at "
       "most "
       "FACTOR times real time; prints a line if this computer does not reach that. Off: real "
       "time; a robot whose modules take longer loses images, as "
       "if its computer were SLOWNESS times slower than this one. With ? it prints how it is now.",
       st},
      {global, "start", "",
       "Lets time pass from now on while commands are typed. Scripts use run: what they do does "
       "not "
       "depend on how fast it is done.",
       start},
      {global, "step", "[NUMBER]", "Takes steps of 8 ms, one if there is no number.", step},
      {global, "stop", "", "Lets time stand again after start.", stop},
      {global, "until", "CONDITION [within SECONDS]",
       "Lets simulated time pass until a condition holds; fails like expect if that takes longer "
       "(600 s if no time is given).",
       until, valueChoices}};
}

}  // namespace gt
