#pragma once
#include <functional>
#include <optional>
#include <string>

#include "console/Console.h"

namespace gt {

/// Reads lines from a terminal with editing, history (kept in the user's folder for state; with the
/// commands that scripts echo) and completion, by readline. What happens meanwhile may print above
/// the line that is being typed, and change its prompt. One at a time.
class LineEditor {
 public:
  explicit LineEditor(Console& console);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// What a person may do instead of typing a line.
  enum class Key { line, end, interrupt };
  /// Waits for the next line. Calls `update` again and again meanwhile, which returns soon, with
  /// the ms until it has to be called again. Returns early if `interrupted` returns true.
  Key read(std::string& line, const std::string& prompt, const std::function<int()>& update,
           const std::function<bool()>& interrupted);

  /// Takes the line that is being typed from the terminal, and puts it there again.
  void hide();
  void show();
  /// Changes the prompt while a line is read.
  void setPrompt(const std::string& prompt);
};

}  // namespace gt
