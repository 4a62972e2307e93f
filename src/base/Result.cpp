#include "base/Result.h"

#include <string_view>

#include "base/Column.h"

namespace gt {
namespace {

constexpr std::string_view columnBegins = " (column ";

/// Takes the column off what is wrong, and returns it; empty if there is none.
std::string takeColumn(std::string& what) {
  const std::size_t begin = what.rfind(columnBegins);
  if (begin == what.npos || what.back() != ')') return {};
  const std::size_t first = begin + columnBegins.size();
  const std::string column = what.substr(first, what.size() - 1 - first);
  if (column.empty() || column.find_first_not_of("0123456789") != column.npos) return {};
  what.erase(begin);
  return column;
}

}  // namespace

std::string withColumn(const std::string& what, int column) {
  return column > 0 ? what + std::string{columnBegins} + std::to_string(column) + ")" : what;
}

std::string Error::text() const {
  std::string s = file, wrong = what;
  if (line > 0) {
    s += ":" + std::to_string(line);
    if (const std::string column = takeColumn(wrong); !column.empty()) s += ":" + column;
  }
  if (!s.empty()) s += ": ";
  if (severity == Severity::warning) s += "warning: ";
  if (!field.empty()) s += field + ": ";
  return s + wrong;
}

}  // namespace gt
