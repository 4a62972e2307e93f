#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace xabsl {

/// A place in a source file. Lines and columns count from 1; the file is an index into a list of
/// names.
struct Location {
  int file = 0;
  int line = 1;
  int column = 1;
};

/// One message of the compiler, the linker or the running engine about one place in a source file.
struct Diagnostic {
  enum class Severity { warning, error };

  Severity severity = Severity::error;
  std::string file;
  int line = 0;  ///< 0: the message is about the file as a whole
  int column = 0;
  std::string message;
  std::string source = {};  ///< the text of the line, if it is known
};

/// One line: `file:line:column: message`, with `warning: ` before the message of a warning.
std::string toString(const Diagnostic& diagnostic);

/// Like toString, followed by the line of the source with a caret under the place.
std::string toStringWithSource(const Diagnostic& diagnostic);

/// A name or a part of the source for a message: in quotes, and cut after 80 bytes.
std::string inQuotes(std::string_view text);

/// Returns whether there is an error, or, if `strict`, any message.
bool fails(const std::vector<Diagnostic>& diagnostics, bool strict = false);

}  // namespace xabsl
