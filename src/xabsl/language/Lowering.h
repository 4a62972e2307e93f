#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/language/Model.h"

/// Transformations of expressions by the public compilers, for intermediate code and XML.
namespace xabsl {

/// `d name`, `b name` or `e enumeration name`.
std::string typedName(const Model& model, Type type, const std::string& name);

/// The indices of the elements that `wanted` accepts, sorted by their names without regard to case.
template <typename Element, typename Wanted>
std::vector<int> sortedByName(const std::vector<Element>& elements, Wanted wanted) {
  std::vector<std::pair<std::string, int>> names;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!wanted(elements[i])) continue;
    std::string name = elements[i].name;
    for (char& c : name)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    names.emplace_back(std::move(name), static_cast<int>(i));
  }
  std::sort(names.begin(), names.end());
  std::vector<int> indices;
  for (const auto& [name, index] : names) indices.push_back(index);
  return indices;
}

/// The indices of all elements, sorted by their names without regard to case.
template <typename Element>
std::vector<int> sortedByName(const std::vector<Element>& elements) {
  return sortedByName(elements, [](const Element&) { return true; });
}

/// Formats a number: whole numbers without a point, others with as many digits as needed.
std::string decimalText(double number);

/// The value of a negated literal number. Nothing for other operands, for which the sign is a
/// subtraction from 0.
std::optional<double> signedNumber(const Model& model, const Expression& negation);

/// The operands of `&&` or `||` together with those of the same operator below it.
std::vector<int> flattened(const Model& model, int connection);

}  // namespace xabsl
