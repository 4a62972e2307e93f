#include "LineEditor.h"

#include <readline/history.h>
#include <readline/readline.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace gt {
namespace {

constexpr const char* historyFile = "out/console_history";
constexpr int historyLines = 1000;

// Readline calls plain functions, so what they work on lies here while an editor lives.
Console* console = nullptr;
std::function<void()>* idleWork = nullptr;
std::vector<std::string> choices;

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

int idle() {
  if (idleWork && *idleWork) (*idleWork)();
  return 0;
}

}  // namespace

LineEditor::LineEditor(Console& of) {
  console = &of;
  rl_readline_name = "simgt";
  rl_attempted_completion_function = completeLine;
  rl_completer_word_break_characters = " \t";
  rl_event_hook = idle;
  using_history();
  stifle_history(historyLines);
  read_history(historyFile);
}

LineEditor::~LineEditor() {
  std::error_code ignored;
  std::filesystem::create_directories("out", ignored);
  write_history(historyFile);
  rl_event_hook = nullptr;
  idleWork = nullptr;
  console = nullptr;
}

std::optional<std::string> LineEditor::read(std::function<void()> work) {
  idleWork = &work;
  for (const std::string& line : console->takeOffers()) add_history(line.c_str());
  char* typed = readline("simgt> ");
  idleWork = nullptr;
  if (!typed) return std::nullopt;
  std::string line{typed};
  std::free(typed);
  if (line.find_first_not_of(" \t") != line.npos) add_history(line.c_str());
  return line;
}

}  // namespace gt
