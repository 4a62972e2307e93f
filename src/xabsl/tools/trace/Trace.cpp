#include "xabsl/tools/trace/Trace.h"

#include "xabsl/language/ModelText.h"

namespace xabsl {

namespace {

/// Whether the engine records the values of expressions with an operator.
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
  read.type = typeOf(model, static_cast<int>(index));
  if (expression.operation == Operator::input || expression.operation == Operator::variable)
    read.symbol = expression.a;
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
  return xabsl::valueText(model, elementValues, type, value);
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
