#include "base/Result.h"

namespace gt {

std::string Error::text() const {
  std::string s = file;
  if (line > 0) s += ":" + std::to_string(line);
  if (line > 0 && column > 0) s += ":" + std::to_string(column);
  if (!s.empty()) s += ": ";
  if (severity == Severity::warning) s += "warning: ";
  if (!field.empty()) s += field + ": ";
  return s + what;
}

}  // namespace gt
