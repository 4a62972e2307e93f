#include "ConsoleProgram.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <optional>

#include "LineEditor.h"
#include "TerminalScreen.h"
#include "base/EndSignals.h"
#include "base/Lines.h"
#include "views/ViewText.h"

namespace gt {
namespace {

/// How long the simulation runs at most before the keyboard is looked at again, and how long it
/// rests if it stands.
constexpr std::chrono::milliseconds updateTime{20}, restTime{10};

/// Lines of the standard input.
class InputLines {
 public:
  /// The next line; empty at the end, and once a signal has come.
  std::optional<std::string> next(const EndSignals& signals) {
    std::array<char, 4096> bytes;
    for (;;) {
      if (const auto end = text_.find('\n'); end != text_.npos) return take(end, end + 1);
      const auto count = signals.waitFor(STDIN_FILENO)
                             ? ::read(STDIN_FILENO, bytes.data(), bytes.size())
                             : ssize_t{-1};
      if (count > 0)
        text_.append(bytes.data(), static_cast<std::size_t>(count));
      else
        return count < 0 || text_.empty() ? std::nullopt : take(text_.size(), text_.size());
    }
  }

 private:
  std::optional<std::string> take(std::size_t length, std::size_t withEnd) {
    const std::string line = text_.substr(0, length);
    text_.erase(0, withEnd);
    return std::string{LineReader{line}.next().value_or("")};
  }

  std::string text_;
};

/// One program with its console and screen.
class ConsoleProgram {
 public:
  explicit ConsoleProgram(Session& session, TerminalScreen& screen)
      : console_{session}, screen_{screen}, signals_{[&session] { session.interrupt(); }} {}
  ConsoleProgram(const ConsoleProgram&) = delete;
  ConsoleProgram& operator=(const ConsoleProgram&) = delete;

  /// Scripts and commands of the command line; the first error ends them.
  Result<void> runAll(const ConsoleOptions& options) {
    if (auto done = console_.callStartScript(); !done) return done;
    for (const std::string& script : options.scripts) {
      if (ended()) break;
      if (auto done = console_.call(script); !done) return done;
    }
    for (const std::string& command : options.commands) {
      if (ended()) break;
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
    InputLines lines;
    for (int number = 1; !ended(); ++number) {
      const auto line = lines.next(signals_);
      if (!line) break;
      if (auto done = console_.execute(*line); !done) {
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
    while (!ended()) {
      std::string line;
      prompt_ = screen_.prompt(console_);
      const auto key = editor.read(
          line, prompt_, [&] { return update(editor); },
          [&] { return console_.session().takeInterrupt(); });
      forgetCtrlC();
      // A terminal that is closed ends the lines, perhaps before its signal comes.
      terminalClosed_ = key == LineEditor::Key::end && !isatty(STDIN_FILENO);
      if (key == LineEditor::Key::end) break;
      if (key == LineEditor::Key::interrupt) stop();
      if (key != LineEditor::Key::line || ended()) continue;
      const auto done = console_.execute(line);
      forgetCtrlC();
      screen_.end();
      if (!done) screen_.printError(done.error().text());
    }
    screen_.setEditor(nullptr);
  }
  bool ended() const { return console_.ended() || signals_.received() != 0; }
  /// What a signal ends the program with; 0 if none came.
  int statusOfSignal() const {
    if (signals_.received() != 0) return signals_.status();
    return terminalClosed_ ? 128 + SIGHUP : 0;
  }
  /// Of a program that an error ended.
  int statusOfError() const { return console_.expectationFailed() ? 1 : 2; }

  /// Ends the film, and after a signal saves recordings that nobody can save any more.
  void close() {
    if (statusOfSignal() == 0) return console_.recorder().clear(console_);
    for (const auto& kept : console_.keepRecordings())
      if (kept)
        screen_.print(*kept);
      else
        screen_.printError(kept.error().text());
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
  /// In a terminal, Ctrl-C ends what runs, but not the program.
  void forgetCtrlC() {
    if (signals_.received() == SIGINT) signals_.forget();
  }
  void stop() {
    Session& session = console_.session();
    if (session.started()) screen_.print("stopped at " + clockText(session.time()));
    session.stop();
  }

  Console console_;
  TerminalScreen& screen_;
  EndSignals signals_;
  std::string prompt_;
  bool terminalClosed_ = false;
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
  Result<void> done;
  if (!options.foxglove.endpoint.empty()) done = (*session)->serveFoxglove(options.foxglove);
  if (done) done = program.runAll(options);
  const bool scripted = !options.scripts.empty() || !options.commands.empty();
  if (done && !scripted && !program.ended()) {
    if (isatty(STDIN_FILENO))
      program.runTyped();
    else
      done = program.runPiped();
  }
  screen.end();
  program.close();
  if (const auto closed = (*session)->match().close(); done) done = closed;
  if (!done) screen.printError("simgt: " + done.error().text());
  if (const int status = program.statusOfSignal(); status != 0) return status;
  return done ? 0 : program.statusOfError();
}

}  // namespace gt
