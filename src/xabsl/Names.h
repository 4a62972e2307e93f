#pragma once

#include <map>
#include <string_view>

#include "xabsl/Syntax.h"

namespace xabsl {

/// Finds what was declared by its name; the values are indices into the lists of the Model.
struct Names {
  using Table = std::map<std::string_view, int>;

  Table enumerations;
  Table symbols;
  Table behaviors;
  Table options;
  Table constants;

  /// The index of a name, or -1.
  static int find(const Table& table, std::string_view name) {
    const auto found = table.find(name);
    return found == table.end() ? -1 : found->second;
  }
};

}  // namespace xabsl
