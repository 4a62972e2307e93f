#pragma once
#include <functional>
#include <optional>
#include <string>

#include "console/Console.h"

namespace gt {

/// Reads lines from a terminal with editing, history (kept in out/console_history; with the
/// commands that scripts echo) and completion of commands, keys, tasks, symbols, values and paths,
/// by readline. One at a time.
class LineEditor {
 public:
  explicit LineEditor(Console& console);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// The next line; nothing at the end of the input. Calls `idle` some times a second meanwhile.
  std::optional<std::string> read(std::function<void()> idle);
};

}  // namespace gt
