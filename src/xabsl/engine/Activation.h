#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xabsl/language/Language.h"

namespace xabsl {

/// The value of a symbol or a parameter in readable form.
struct NamedValue {
  std::string name;
  ValueKind kind = ValueKind::number;
  double number = 0;
  std::string text;  ///< `1.5`, `true`, or the name of an element
};

/// One option or basic behavior that the engine executed in its last cycle (report H.8).
struct Activation {
  enum class Kind { option, behavior };

  Kind kind = Kind::option;
  int depth = 0;  ///< of the call; the root option is at 0
  std::string name;
  std::string state;            ///< of an option: its active state
  bool target = false;          ///< whether that is a target state
  std::int64_t optionTime = 0;  ///< ms since the option became active
  std::int64_t stateTime = 0;   ///< ms since the state became active
  std::vector<NamedValue> parameters;
};

/// Formats a line for each option and basic behavior, indented by depth.
std::string toString(const std::vector<Activation>& activations);

}  // namespace xabsl
