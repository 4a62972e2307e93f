#pragma once
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// Overrides the behavior, for debugging (report H.8, I.5.3: xbb, xo, xis, xos): the newest
/// request holds, an empty one lets the engine go. Names as in the behavior. Sent by tools.
struct BehaviorControlRequest {
  /// An output symbol that keeps a value, whatever the behavior sets.
  struct Output {
    std::string symbol;
    std::string value;

    bool operator==(const Output&) const = default;
    static constexpr auto fields() {
      return Fields{field<&Output::symbol>(), field<&Output::value>()};
    }
  };

  std::string root;
  bool basicBehavior = false;
  std::vector<std::string> parameters;
  std::vector<Output> outputs;
  std::vector<std::string> shown;

  bool operator==(const BehaviorControlRequest&) const = default;
  static constexpr auto fields() {
    using R = BehaviorControlRequest;
    return Fields{
        field<&R::root>("executed instead of the agent's root option; empty: that"),
        field<&R::basicBehavior>("whether the root is one, not an option"),
        field<&R::parameters>(
            "of the root, in the order of its declaration: numbers, true, false, elements"),
        field<&R::outputs>("that keep a value"),
        field<&R::shown>("symbols whose values BehaviorState tells")};
  }
};

}  // namespace gt
