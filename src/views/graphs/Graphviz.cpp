#include "views/graphs/Graphviz.h"

#include <filesystem>

#include "base/Program.h"

namespace gt {

std::string dotQuoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

Result<void> writeSvg(const std::string& drawing, const std::string& file) {
  const auto dot = runProgram({"dot", "-Tsvg", "-o" + file}, drawing);
  if (!dot)
    return Error{.file = file, .what = "cannot be drawn: Graphviz's program dot is missing"};
  if (dot->status == 0) return {};
  std::error_code ignored;  // there may be none
  std::filesystem::remove(file, ignored);
  const std::string reason = dot->errors.substr(0, dot->errors.find('\n'));
  return Error{.file = file,
               .what = "cannot be drawn: " + (reason.empty() ? "dot failed" : reason)};
}

}  // namespace gt
