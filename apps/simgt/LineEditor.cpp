#include "LineEditor.h"

#include <fcntl.h>
#include <poll.h>
#include <readline/history.h>
#include <readline/readline.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "base/UserFolder.h"

namespace gt {
namespace {

constexpr int historyLines = 1000;

// Readline calls plain functions, so what they work on lies here while an editor exists.
Console* console = nullptr;
std::vector<std::string> choices;
bool reading = false, lineTaken = false;
std::optional<std::string> typed;

char* nextChoice(const char*, int state) {
  return static_cast<std::size_t>(state) < choices.size()
             ? strdup(choices[static_cast<std::size_t>(state)].c_str())
             : nullptr;
}

char** completeLine(const char* text, int, int end) {
  rl_attempted_completion_over = 1;
  choices = console->completions(std::string_view{rl_line_buffer, static_cast<std::size_t>(end)});
  if (choices.size() == 1 && choices.front().ends_with('/')) rl_completion_append_character = '\0';
  return rl_completion_matches(text, nextChoice);
}

void takeLine(char* line) {
  rl_callback_handler_remove();
  reading = false;
  lineTaken = true;
  if (line) typed = line;
  std::free(line);
}

/// Whether something was typed; waits a moment.
bool keyPressed(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, milliseconds) > 0;
}

/// Where lines are kept from one console to the next; empty if the user has no folder for that.
std::string historyFile() {
  const std::string folder = userFolder(UserFolder::state);
  return folder.empty() ? "" : folder + "/console_history";
}

/// Reads a key without waiting for it: Ctrl-C empties the terminal's queue, and with it what
/// keyPressed found. The key 0 (set-mark) changes nothing.
int readKey(FILE*) {
  const int flags = fcntl(STDIN_FILENO, F_GETFL);
  fcntl(STDIN_FILENO, F_SETFL, flags | O_NONBLOCK);
  unsigned char key = 0;
  const auto count = ::read(STDIN_FILENO, &key, 1);
  const bool gone = count < 0 && (errno == EAGAIN || errno == EINTR);
  fcntl(STDIN_FILENO, F_SETFL, flags);
  return count > 0 || gone ? key : EOF;
}

}  // namespace

LineEditor::LineEditor(Console& of) {
  console = &of;
  rl_readline_name = "simgt";
  rl_attempted_completion_function = completeLine;
  rl_completer_word_break_characters = " \t";
  rl_catch_signals = 0;
  rl_getc_function = readKey;
  using_history();
  stifle_history(historyLines);
  if (const std::string file = historyFile(); !file.empty()) read_history(file.c_str());
}

LineEditor::~LineEditor() {
  if (const std::string file = historyFile(); !file.empty()) {
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
    write_history(file.c_str());
  }
  console = nullptr;
}

LineEditor::Key LineEditor::read(std::string& line, const std::string& prompt,
                                 const std::function<int()>& update,
                                 const std::function<bool()>& interrupted) {
  for (const std::string& offer : console->takeOffers()) add_history(offer.c_str());
  typed.reset();
  lineTaken = false;
  reading = true;
  rl_callback_handler_install(prompt.c_str(), takeLine);
  while (!lineTaken) {
    const bool pressed = keyPressed(update());
    if (interrupted()) {
      rl_callback_sigcleanup();
      rl_free_line_state();
      rl_crlf();
      rl_callback_handler_remove();
      reading = false;
      return Key::interrupt;
    }
    if (pressed) do
        rl_callback_read_char();
      while (!lineTaken && keyPressed(0));
  }
  if (!typed) return Key::end;
  line = *typed;
  if (line.find_first_not_of(" \t") != line.npos) add_history(line.c_str());
  return Key::line;
}

void LineEditor::hide() {
  if (reading) rl_clear_visible_line();
}

void LineEditor::show() {
  if (!reading) return;
  rl_on_new_line();
  rl_redisplay();
}

void LineEditor::setPrompt(const std::string& prompt) {
  if (!reading) return;
  rl_set_prompt(prompt.c_str());
  rl_redisplay();
}

}  // namespace gt
