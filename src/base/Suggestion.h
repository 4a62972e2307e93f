#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gt {

/// A supplement for an error about an unknown name: "; did you mean 'x'?" with the known name of
/// the most similar spelling, or an empty text if none is similar. Ignores case.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// The names of all elements of a list; each element has a `name`.
template <typename List>
std::vector<std::string> namesIn(const List& list) {
  std::vector<std::string> names;
  for (const auto& one : list) names.emplace_back(one.name);
  return names;
}

}  // namespace gt
