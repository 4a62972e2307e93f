#include "base/Findings.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace gt {

void Findings::add(Findings other) {
  std::move(other.list_.begin(), other.list_.end(), std::back_inserter(list_));
}

void Findings::sort() {
  const auto key = [](const Error& e) { return std::tie(e.file, e.line, e.field, e.what); };
  std::ranges::stable_sort(list_, {}, key);
  // clang 14 does not compile std::ranges::unique of gcc 12's library.
  const auto same = [&](const Error& a, const Error& b) { return key(a) == key(b); };
  list_.erase(std::unique(list_.begin(), list_.end(), same), list_.end());
}

Result<void> Findings::firstError() const {
  for (const Error& finding : list_)
    if (finding.severity == Severity::error) return finding;
  return {};
}

std::string Findings::text() const {
  std::string text;
  for (const Error& finding : list_) text += finding.text() + '\n';
  return text;
}

std::size_t Findings::count(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(
      list_.begin(), list_.end(), [&](const Error& e) { return e.severity == severity; }));
}

}  // namespace gt
