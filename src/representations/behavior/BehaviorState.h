#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// A symbol or parameter of a behavior and its value, as text.
struct BehaviorValue {
  std::string name;
  std::string value;
  std::string unit{};

  static constexpr auto fields() {
    return Fields{field<&BehaviorValue::name>(), field<&BehaviorValue::value>(),
                  field<&BehaviorValue::unit>("unit as declared in the behavior")};
  }
};

/// Executed options and symbol values of the behavior in one cycle (report I.3.3.3, J.5.1), for
/// tools. Sent by BehaviorControl while its debug key `BehaviorControl/activations` is active.
struct BehaviorState {
  /// An option or basic behavior that was executed.
  struct Activation {
    std::string name;
    std::string state;
    int depth = 0;
    std::int64_t optionTime = 0;
    std::int64_t stateTime = 0;
    std::vector<BehaviorValue> parameters;

    static constexpr auto fields() {
      return Fields{
          field<&Activation::name>(),
          field<&Activation::state>("active state of an option; empty for a basic behavior"),
          field<&Activation::depth>("depth in the call stack; 0 for the root"),
          field<&Activation::optionTime>(Unit::ms,
                                         "time since the option or basic behavior became active"),
          field<&Activation::stateTime>(Unit::ms, "time since the state became active"),
          field<&Activation::parameters>()};
    }
  };

  std::string agent;
  std::vector<Activation> activations;
  std::vector<BehaviorValue> inputs;
  std::vector<BehaviorValue> outputs;

  static constexpr auto fields() {
    return Fields{field<&BehaviorState::agent>(),
                  field<&BehaviorState::activations>("in the order of execution"),
                  field<&BehaviorState::inputs>("values of the requested input symbols"),
                  field<&BehaviorState::outputs>("output symbols that were asked for")};
  }
};

/// Formats the state: one line for each option and basic behavior, indented by depth, times in ms.
inline std::string toString(const BehaviorState& state) {
  std::string text;
  for (const BehaviorState::Activation& a : state.activations) {
    text.append(2 * static_cast<std::size_t>(a.depth), ' ').append(a.name).append("(");
    for (const BehaviorValue& p : a.parameters)
      text.append(&p == a.parameters.data() ? "" : ", ").append(p.name + " = " + p.value);
    text += ")";
    if (!a.state.empty())
      text += " " + std::to_string(a.optionTime) + " ms: " + a.state + " " +
              std::to_string(a.stateTime) + " ms";
    text += "\n";
  }
  return text;
}

}  // namespace gt
