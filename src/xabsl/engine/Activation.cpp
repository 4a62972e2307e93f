#include "xabsl/engine/Activation.h"

namespace xabsl {

std::string toString(const std::vector<Activation>& activations) {
  std::string text;
  for (const Activation& activation : activations) {
    text.append(2 * static_cast<std::size_t>(activation.depth), ' ');
    text += activation.name + "(";
    for (const NamedValue& parameter : activation.parameters) {
      if (&parameter != &activation.parameters.front()) text += ", ";
      text += parameter.name + " = " + parameter.text;
    }
    text += ")";
    if (activation.kind == Activation::Kind::option)
      text += " " + std::to_string(activation.optionTime) + " ms: " + activation.state +
              (activation.target ? " (target) " : " ") + std::to_string(activation.stateTime) +
              " ms";
    text += "\n";
  }
  return text;
}

}  // namespace xabsl
