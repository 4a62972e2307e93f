#pragma once
#include <optional>

#include "xabsl/language/Behavior.h"

namespace gt {

/// The behavior that BehaviorControl executes, compiled from XABSL. Configuration.
struct Behavior {
  std::optional<xabsl::Behavior> compiled;
};

}  // namespace gt
