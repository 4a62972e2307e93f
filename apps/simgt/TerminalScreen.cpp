#include "TerminalScreen.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

#include "views/ViewText.h"

namespace gt {
namespace {

constexpr std::chrono::milliseconds interval{200};
constexpr const char* clearLine = "\r\033[K";
constexpr const char* plain = "\033[0m";

/// Prints without an error: a match does not end because its terminal is gone or the disk is full.
/// At the program's end, CommandLine reports what could not be printed.
void put(std::FILE* file, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), file);
}

/// The color in which a line is printed; empty: none.
const char* colorOf(std::string_view line) {
  if (line.find("Goal for") != line.npos) return "\033[1;33m";
  if (line.find("  Kick-off") != line.npos || line.find("  Half time") != line.npos)
    return "\033[36m";
  const std::size_t colon = line.find(": ");
  return colon != line.npos && line.find(' ') > colon ? "\033[2m" : "";
}

}  // namespace

TerminalScreen::TerminalScreen() : terminal_{isatty(STDOUT_FILENO) != 0}, shown_{Clock::now()} {}

void TerminalScreen::watch(Session& session) {
  session_ = &session;
  shownTime_ = session.time();
}

std::string TerminalScreen::prompt(Console& console) const {
  constexpr std::size_t mostNames = 3;
  const auto& selection = console.selection();
  std::string text = "simgt";
  if (selection.size() > mostNames)
    text += fmt::format(" {} robots", selection.size());
  else
    for (const std::string& robot : selection) text += " " + robot;
  if (session_ && session_->started()) text += " " + clockText(session_->time());
  return text + "> ";
}

void TerminalScreen::printLine(std::string_view line, const char* color, std::FILE* file) {
  if (editor_) editor_->hide();
  if (!live_.empty()) put(stdout, clearLine);
  std::fflush(stdout);
  put(file, fmt::format("{}{}{}\n", color, line, *color ? plain : ""));
  put(stdout, live_);
  std::fflush(stdout);
  if (editor_) editor_->show();
}

void TerminalScreen::print(std::string_view line) {
  printLine(line, terminal_ ? colorOf(line) : "", stdout);
}

void TerminalScreen::printError(std::string_view line) {
  end();
  printLine(line, isatty(STDERR_FILENO) ? "\033[31m" : "", stderr);
}

void TerminalScreen::clear() {
  if (terminal_) put(stdout, "\033[2J\033[H");
}

void TerminalScreen::stepped() {
  const auto now = Clock::now();
  if (!terminal_ || !session_ || now < shown_ + interval) return;
  const std::chrono::duration<double, std::milli> real = now - shown_;
  const double factor = static_cast<double>(session_->time() - shownTime_) / real.count();
  shown_ = now;
  shownTime_ = session_->time();
  if (editor_ && session_->started()) return;
  const Referee& referee = session_->simulation().referee();
  live_ = fmt::format("{}\033[7m {:>5}  {}:{}  {:4.1f} times real time \033[0m", clearLine,
                      clockText(session_->time()), referee.score(TeamColor::red),
                      referee.score(TeamColor::blue), factor);
  put(stdout, live_);
  std::fflush(stdout);
}

void TerminalScreen::end() {
  if (!live_.empty()) put(stdout, clearLine);
  live_.clear();
  std::fflush(stdout);
}

}  // namespace gt
