#include "xabsl/language/Diagnostic.h"

#include <algorithm>

#include "xabsl/language/Utf8.h"

namespace xabsl {

std::string toString(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0)
    text += ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column);
  text += diagnostic.severity == Diagnostic::Severity::error ? ": " : ": warning: ";
  return text + diagnostic.message;
}

std::string toStringWithSource(const Diagnostic& diagnostic) {
  std::string text = toString(diagnostic);
  if (diagnostic.source.empty() || diagnostic.column < 1) return text;
  const std::string number = std::to_string(diagnostic.line);
  const std::string margin = std::string(number.size() + 2, ' ') + "| ";
  std::string pad;
  int column = 1;
  for (const char c : diagnostic.source) {
    if (column >= diagnostic.column) break;
    if (continuesLetter(c)) continue;  // columns count letters
    pad += c == '\t' ? '\t' : ' ';
    ++column;
  }
  return text + "\n " + number + " | " + diagnostic.source + "\n" + margin + pad + "^";
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  return "'" + std::string(text.substr(0, longest)) + (text.size() > longest ? "..." : "") + "'";
}

bool fails(const std::vector<Diagnostic>& diagnostics, bool strict) {
  return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& diagnostic) {
    return strict || diagnostic.severity == Diagnostic::Severity::error;
  });
}

}  // namespace xabsl
