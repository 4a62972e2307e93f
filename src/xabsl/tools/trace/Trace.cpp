#include "xabsl/tools/trace/Trace.h"

#include <charconv>

#include "xabsl/language/ModelText.h"

namespace xabsl {

namespace {

/// Whether the engine records the value of such an expression.
bool isRead(Operator operation) {
  switch (operation) {
    case Operator::parameter:
    case Operator::input:
    case Operator::variable:
    case Operator::stateTime:
    case Operator::optionTime:
    case Operator::actionDone:
    case Operator::conflict:
      return true;
    default:
      return false;
  }
}

TraceSubject::Read readOf(const Model& model, std::size_t index) {
  const Expression& expression = model.expressions[index];
  TraceSubject::Read read;
  if (!isRead(expression.operation)) return read;
  read.text = expressionText(model, static_cast<int>(index));
  const auto a = static_cast<std::size_t>(expression.a);
  if (expression.operation == Operator::parameter) {
    read.type = model.options[a].parameters[at(expression.b)].type;
  } else if (expression.operation == Operator::input ||
             expression.operation == Operator::variable) {
    read.type = model.symbols[a].type;
    read.symbol = expression.a;
  } else if (expression.operation == Operator::actionDone ||
             expression.operation == Operator::conflict) {
    read.type.kind = ValueKind::boolean;
  }
  return read;
}

}  // namespace

TraceSubject TraceSubject::of(const Engine& engine) {
  TraceSubject subject;
  const Model& model = engine.model();
  for (std::size_t i = 0; i < model.enumerations.size(); ++i)
    subject.elementValues.push_back(engine.elementValues(static_cast<int>(i)));
  for (const Decision& decision : model.decisions)
    subject.conditions.push_back({expressionText(model, decision.condition),
                                  model.expressionLocations[at(decision.condition)]});
  for (std::size_t i = 0; i < model.expressions.size(); ++i)
    subject.reads.push_back(readOf(model, i));
  subject.model.files = model.files;
  subject.model.enumerations = model.enumerations;
  subject.model.symbols = model.symbols;
  subject.model.behaviors = model.behaviors;
  subject.model.options = model.options;
  subject.model.states = model.states;
  subject.model.decisions = model.decisions;
  return subject;
}

std::string TraceSubject::valueText(Type type, double value) const {
  if (type.kind == ValueKind::boolean) return value != 0 ? "true" : "false";
  if (type.kind == ValueKind::enumeration) {
    const auto enumeration = static_cast<std::size_t>(type.enumeration);
    for (std::size_t i = 0; i < elementValues[enumeration].size(); ++i)
      if (elementValues[enumeration][i] == value)
        return model.enumerations[enumeration].elements[i].name;
  }
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr};
}

std::string TraceSubject::place(Location location) const {
  return model.files[at(location.file)] + ":" + std::to_string(location.line);
}

int TraceSubject::optionOf(int state) const {
  for (std::size_t i = 0; i < model.options.size(); ++i) {
    const Span states = model.options[i].states;
    if (state >= states.first && state < states.first + states.count) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace xabsl
