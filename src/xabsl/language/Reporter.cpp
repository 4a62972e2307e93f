#include "xabsl/language/Reporter.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace xabsl {

namespace {

/// Levenshtein's distance between two names, in letters.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row[b.size()];
}

}  // namespace

int Reporter::addFile(const std::string& name, std::string_view text) {
  files_.push_back(name);
  texts_.push_back(text);
  return static_cast<int>(files_.size()) - 1;
}

void Reporter::error(Location location, const std::string& message) {
  failed_ = true;
  add(Diagnostic::Severity::error, location, message);
}

void Reporter::warning(Location location, const std::string& message) {
  add(Diagnostic::Severity::warning, location, message);
}

void Reporter::fileError(const std::string& file, const std::string& message) {
  failed_ = true;
  if (full()) return;
  ++errors_;
  entries_.push_back({{-1, 0, 0}, {Diagnostic::Severity::error, file, 0, 0, message}});
}

void Reporter::add(Diagnostic::Severity severity, Location location, const std::string& message) {
  std::size_t& count = severity == Diagnostic::Severity::error ? errors_ : warnings_;
  if (count >= maximum) return;
  const bool last = ++count == maximum;
  const std::string& file = files_[at(location.file)];
  entries_.push_back({location,
                      {severity, file, location.line, location.column,
                       last ? message + " (no more are shown)" : message, line(location)}});
}

/// The line of a message's place; empty if it is too long to be read.
std::string Reporter::line(Location location) {
  constexpr std::size_t longestLine = 300;
  std::string_view text = texts_[at(location.file)];
  for (int skipped = 1; skipped < location.line; ++skipped) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find_first_of("\r\n"));
  return text.size() > longestLine ? std::string() : std::string(text);
}

std::vector<Diagnostic> Reporter::take() {
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.location.file, a.location.line, a.location.column) <
           std::tie(b.location.file, b.location.line, b.location.column);
  });
  std::vector<Diagnostic> diagnostics;
  for (Entry& entry : entries_) diagnostics.push_back(std::move(entry.diagnostic));
  entries_.clear();
  return diagnostics;
}

void Suggestion::offer(std::string_view candidate) {
  // Comparing costs the product of the lengths; a broken file may ask for very many comparisons.
  constexpr std::size_t longestName = 40;
  constexpr int mostOffers = 5000;
  if (candidate.size() > longestName || name_.size() > longestName) return;
  if (++offers_ > mostOffers) return;
  const std::size_t distance = editDistance(name_, candidate);
  if (distance >= bestDistance_ || 2 * distance > name_.size()) return;
  bestDistance_ = distance;
  best_ = candidate;
}

std::string Suggestion::text() const {
  return best_.empty() ? "" : "; did you mean '" + std::string(best_) + "'?";
}

}  // namespace xabsl
