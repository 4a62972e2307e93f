#pragma once
#include <string>

namespace motionnet {

/// An error in a motion description, with its place.
struct Diagnostic {
  std::string file{};
  int line = 0;         ///< From 1; 0 for the whole file.
  std::string field{};  ///< The word, column or name concerned; may be empty.
  std::string message{};

  /// One line: file:line: field: message.
  std::string text() const {
    std::string s = file;
    if (line > 0) s += ":" + std::to_string(line);
    s += ": ";
    if (!field.empty()) s += field + ": ";
    return s + message;
  }
};

}  // namespace motionnet
