#include "base/Suggestion.h"

#include <algorithm>

namespace gt {
namespace {

constexpr std::size_t longestName = 60;
constexpr std::size_t slips = 3;  // of the fingers, at most

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The number of letters that must be changed, added or left out (Levenshtein).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > longestName) return {};
  std::size_t least = slips + 1;
  std::string_view best;
  for (const std::string& candidate : known) {
    if (candidate.size() > name.size() + slips) continue;
    const std::size_t distance = editDistance(name, candidate);
    if (distance >= least || 2 * distance > name.size()) continue;
    least = distance;
    best = candidate;
  }
  return best.empty() ? "" : "; did you mean '" + std::string{best} + "'?";
}

}  // namespace gt
