#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gt {

/// What follows an error about an unknown name: "; did you mean 'x'?" with the known name that is
/// spelled most like it, or nothing if none is. Capitals and small letters count as alike.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// The names of a list of things that have one.
template <typename List>
std::vector<std::string> namesIn(const List& list) {
  std::vector<std::string> names;
  for (const auto& one : list) names.emplace_back(one.name);
  return names;
}

}  // namespace gt
