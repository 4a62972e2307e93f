#include "ConsoleProgram.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>

#include "JoystickDevice.h"
#include "LineEditor.h"
#include "TerminalScreen.h"
#include "views/ViewText.h"

namespace gt {
namespace {

/// How long the simulation runs at most before the keyboard is looked at again, and how long it
/// rests if it stands.
constexpr std::chrono::milliseconds updateTime{20}, restTime{10};

constexpr int statusInterrupted = 128 + SIGINT;

/// Interrupts the session when a person presses Ctrl-C, for as long as this object exists. Who
/// presses it again and again while nothing happens ends the program.
class InterruptKey {
 public:
  explicit InterruptKey(Session& session) {
    interrupted = &session;
    presses = 0;
    struct sigaction action {};
    action.sa_handler = press;
    sigaction(SIGINT, &action, &before_);
  }
  ~InterruptKey() {
    sigaction(SIGINT, &before_, nullptr);
    interrupted = nullptr;
  }
  InterruptKey(const InterruptKey&) = delete;
  InterruptKey& operator=(const InterruptKey&) = delete;

  /// The program has done what was asked for.
  static void release() { presses = 0; }
  static bool wasPressed() { return presses > 0; }

 private:
  static constexpr int impatient = 3;
  static void press(int) {
    if (++presses >= impatient) _exit(statusInterrupted);
    if (interrupted) interrupted->interrupt();
  }

  static inline Session* interrupted = nullptr;
  static inline std::atomic<int> presses = 0;
  struct sigaction before_ {};
};

/// One program with its console, screen and joystick.
class ConsoleProgram {
 public:
  explicit ConsoleProgram(Session& session, TerminalScreen& screen)
      : console_{session}, screen_{screen}, interruptKey_{session} {}
  ~ConsoleProgram() { console_.session().setInput({}); }
  ConsoleProgram(const ConsoleProgram&) = delete;
  ConsoleProgram& operator=(const ConsoleProgram&) = delete;

  /// Reads a joystick while time passes.
  Result<void> connect(const std::string& joystick) {
    auto device = JoystickDevice::open(joystick);
    if (!device) return device.error();
    joystick_ = std::move(*device);
    console_.session().setInput([this] { joystick_->update(console_); });
    return {};
  }
  /// Scripts and commands of the command line; the first error ends them.
  Result<void> runAll(const ConsoleOptions& options) {
    if (auto done = console_.callStartScript(); !done) return done;
    for (const std::string& script : options.scripts)
      if (auto done = console_.call(script); !done) return done;
    for (const std::string& command : options.commands) {
      if (console_.ended()) break;
      if (auto done = console_.execute(command); !done) {
        const Error& error = done.error();
        return error.file.empty() ? Error{.file = "-c \"" + command + "\"",
                                          .field = error.field,
                                          .what = error.what}
                                  : error;
      }
    }
    return {};
  }
  /// Lines that are piped in: as a script, up to the first error.
  Result<void> runPiped() {
    int number = 0;
    for (std::string line; !console_.ended() && std::getline(std::cin, line);) {
      ++number;
      if (auto done = console_.execute(line); !done) {
        const Error& error = done.error();
        return error.file.empty() ? Error{.file = "input",
                                          .line = number,
                                          .field = error.field,
                                          .what = error.what}
                                  : error;
      }
    }
    return {};
  }
  /// Lines that are typed: errors are printed, and the next line is asked for. Meanwhile time
  /// passes if the session was started, and robots elsewhere are listened to.
  void runTyped() {
    LineEditor editor{console_};
    screen_.setEditor(&editor);
    screen_.print("Type help for the commands, tab to complete them, exit to end.");
    while (!console_.ended()) {
      std::string line;
      prompt_ = screen_.prompt(console_);
      const auto key = editor.read(
          line, prompt_, [&] { return update(editor); },
          [&] { return console_.session().takeInterrupt(); });
      InterruptKey::release();
      if (key == LineEditor::Key::end) break;
      if (key == LineEditor::Key::interrupt) stop();
      if (key != LineEditor::Key::line) continue;
      const auto done = console_.execute(line);
      InterruptKey::release();
      screen_.end();
      if (!done) screen_.printError(done.error().text());
    }
    screen_.setEditor(nullptr);
  }
  bool ended() const { return console_.ended(); }
  int status() const {
    return InterruptKey::wasPressed() ? statusInterrupted : console_.expectationFailed() ? 1 : 2;
  }

 private:
  int update(LineEditor& editor) {
    Session& session = console_.session();
    session.update(updateTime);
    std::string prompt = screen_.prompt(console_);
    if (prompt != prompt_) editor.setPrompt(prompt);
    prompt_ = std::move(prompt);
    return session.started() ? 0 : static_cast<int>(restTime.count());
  }
  void stop() {
    Session& session = console_.session();
    if (session.started()) screen_.print("stopped at " + clockText(session.time()));
    session.stop();
  }

  Console console_;
  TerminalScreen& screen_;
  InterruptKey interruptKey_;
  std::unique_ptr<JoystickDevice> joystick_;
  std::string prompt_;
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
  Result<void> done = options.joystick.empty() ? Result<void>{} : program.connect(options.joystick);
  if (done && !options.foxglove.endpoint.empty())
    done = (*session)->serveFoxglove(options.foxglove);
  if (done) done = program.runAll(options);
  const bool scripted = !options.scripts.empty() || !options.commands.empty();
  if (done && !scripted && !program.ended()) {
    if (isatty(STDIN_FILENO))
      program.runTyped();
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
