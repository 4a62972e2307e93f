#include "xabsl/tools/documentation/Usage.h"

#include "xabsl/language/ModelText.h"

namespace xabsl::documentation {

Usage::Usage(const Model& model)
    : model_(model), direct_(model.options.size()), all_(model.options.size()) {
  for (std::size_t i = 0; i < model.options.size(); ++i)
    collect(model.options[i], static_cast<int>(i));
  for (std::size_t i = 0; i < model.options.size(); ++i) close(static_cast<int>(i));
}

const std::map<Thing, std::vector<int>>& Usage::direct(int option) const {
  return direct_[at(option)];
}

const std::set<Thing>& Usage::all(int option) const {
  return all_[at(option)];
}

const std::vector<Place>& Usage::places(const Thing& thing) const {
  static const std::vector<Place> none;
  const auto found = places_.find(thing);
  return found == places_.end() ? none : found->second;
}

void Usage::add(const Thing& thing, Place place) {
  std::vector<int>& states = direct_[at(place.option)][thing];
  if (!states.empty() && states.back() == place.state) return;
  states.push_back(place.state);
  places_[thing].push_back(place);
}

void Usage::collect(const Option& option, int index) {
  collect(option.commonDecision, {index, -1});
  collect(option.commonActions, {index, -1});
  for (const int state : option.states) {
    collect(model_.states[at(state)].decision, {index, state});
    collect(model_.states[at(state)].actions, {index, state});
  }
}

void Usage::collect(Branch branch, Place place) {
  // A chain of `else if` may be long: it is followed in a loop.
  while (branch.kind == Branch::Kind::decision) {
    const Decision& decision = model_.decisions[at(branch.index)];
    collectExpression(decision.condition, place);
    collect(decision.then, place);
    branch = decision.otherwise;
  }
}

void Usage::collect(Span actions, Place place) {
  for (const Action& action : actions.of(model_.actions)) {
    if (action.kind == Action::Kind::assignment)
      collectExpression(action.operand, place);
    else
      collectOperands(action.operand, parametersOf(model_, action).size(), place);
    add(thingOf(action), place);
  }
}

/// Collects the operands that were set; the defaults of others are no use of anything.
void Usage::collectOperands(int first, std::size_t count, Place place) {
  for (const int parameter : model_.setParameters(first, count))
    collectExpression(model_.operands[at(first + parameter)], place);
}

void Usage::collectExpression(int index, Place place) {
  const Expression& expression = model_.expressions[at(index)];
  switch (expression.operation) {
    case Operator::constant:
      if (expression.a >= 0) add({Thing::Kind::constant, expression.a}, place);
      return;
    case Operator::element:
      return add({Thing::Kind::element, expression.a, expression.b}, place);
    case Operator::variable:
      return add({Thing::Kind::read, expression.a}, place);
    case Operator::input:
      add({Thing::Kind::read, expression.a}, place);
      return collectOperands(expression.b, model_.symbols[at(expression.a)].parameters.size(),
                             place);
    case Operator::logicalAnd:
    case Operator::logicalOr:
      for (int i = 0; i < expression.c; ++i)
        collectExpression(model_.operands[at(expression.b + i)], place);
      return;
    case Operator::parameter:
    case Operator::stateTime:
    case Operator::optionTime:
    case Operator::actionDone:
    case Operator::conflict:
      return;
    default:
      for (const int operand : {expression.a, expression.b, expression.c})
        if (operand >= 0) collectExpression(operand, place);
  }
}

/// Recursive: options form a graph without cycles and with bounded depth.
const std::set<Thing>& Usage::close(int option) {
  std::set<Thing>& all = all_[at(option)];
  if (!all.empty()) return all;
  for (const auto& [thing, states] : direct_[at(option)]) {
    all.insert(thing);
    if (thing.kind != Thing::Kind::option) continue;
    const std::set<Thing>& below = close(thing.index);
    all.insert(below.begin(), below.end());
  }
  return all;
}

}  // namespace xabsl::documentation
