#include "ConsoleProgram.h"

#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "JoystickDevice.h"
#include "LineEditor.h"
#include "TerminalScreen.h"

namespace gt {
namespace {

/// The script that a scene begins with: its own, or scenes/console.con if there is one (report
/// I.4).
std::string startScript(const SceneDescription& scene) {
  if (!scene.script.empty()) return scene.resolve(scene.script);
  const std::string usual = scene.resolve("console.con");
  return std::filesystem::is_regular_file(usual) ? usual : "";
}

/// One program with its console, screen and joystick.
class ConsoleProgram {
 public:
  explicit ConsoleProgram(Session& session, TerminalScreen& screen)
      : console_{session}, screen_{screen} {}

  /// Scripts and commands of the command line; the first error ends them.
  Result<void> runAll(const ConsoleOptions& options) {
    const std::string start = startScript(console_.session().simulation().scene());
    if (!start.empty())
      if (auto done = console_.call(start); !done) return done;
    for (const std::string& script : options.scripts)
      if (auto done = console_.call(script); !done) return done;
    for (const std::string& command : options.commands)
      if (auto done = console_.execute(command); !done) return done;
    return {};
  }
  /// Lines that are piped in: as a script, up to the first error.
  Result<void> runPiped() {
    int number = 0;
    for (std::string line; std::getline(std::cin, line);) {
      ++number;
      if (auto done = console_.execute(line); !done) {
        const Error& error = done.error();
        return error.file.empty() ? Error{"input", number, error.field, error.what} : error;
      }
    }
    return {};
  }
  /// Lines that are typed: errors are told, and the next line is asked for. Meanwhile the
  /// simulation stands, unless it runs by itself (`run` without an end).
  void runTyped(const std::string& joystick) {
    LineEditor editor{console_};
    JoystickDevice device{joystick};
    screen_.print("Type help for the commands, tab to complete them, exit to end.");
    while (const auto line = editor.read([&] { device.update(console_); })) {
      if (*line == "exit" || *line == "quit") return;
      const auto done = console_.execute(*line);
      screen_.end();
      if (!done) screen_.printError(done.error().text());
    }
  }
  int status() const { return console_.expectationFailed() ? 1 : 2; }

 private:
  Console console_;
  TerminalScreen& screen_;
};

}  // namespace

int runConsole(const ConsoleOptions& options) {
  TerminalScreen screen;
  auto session = Session::make(options.match, screen);
  if (!session) {
    screen.printError("simgt: " + session.error().text());
    return 2;
  }
  screen.watch(**session);
  ConsoleProgram program{**session, screen};
  Result<void> done = program.runAll(options);
  const bool scripted = !options.scripts.empty() || !options.commands.empty();
  if (done && !scripted) {
    if (isatty(STDIN_FILENO))
      program.runTyped(options.joystick);
    else
      done = program.runPiped();
  }
  screen.end();
  if (done) done = (*session)->match().close();
  if (done) return 0;
  screen.printError("simgt: " + done.error().text());
  return program.status();
}

}  // namespace gt
