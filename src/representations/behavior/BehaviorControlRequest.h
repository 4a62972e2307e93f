#pragma once
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// Overrides the behavior, for debugging (report H.8, I.5.3: xbb, xo, xis, xos). The newest request
/// is valid; an empty one ends the override. Uses the names of the behavior. Sent by tools.
struct BehaviorControlRequest {
  /// An output symbol that keeps a value, regardless of the behavior.
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
        field<&R::root>(
            "name of the option or basic behavior to execute; empty: the agent's root option"),
        field<&R::basicBehavior>("whether the root is a basic behavior instead of an option"),
        field<&R::parameters>(
            "parameters of the root, in the order of declaration: numbers, true, false, "
            "enumeration elements"),
        field<&R::outputs>("output symbols that keep a value, regardless of the behavior"),
        field<&R::shown>("symbols whose values BehaviorState reports")};
  }
};

}  // namespace gt
