#pragma once

#include <map>
#include <string_view>

#include "xabsl/language/Syntax.h"

namespace xabsl {

/// Tables of the declared names; the values are indices into the lists of the Model. An input
/// symbol, an output or internal symbol and a constant may have the same name.
struct Names {
  using Table = std::map<std::string_view, int>;

  Table enumerations;
  Table inputs;
  Table outputs;  ///< and internal symbols
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
