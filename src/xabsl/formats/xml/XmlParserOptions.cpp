#include <algorithm>
#include <charconv>
#include <utility>

#include "xabsl/formats/xml/XmlParser.h"
#include "xabsl/language/Operators.h"
#include "xabsl/language/Parser.h"
#include "xabsl/language/Text.h"

/// The part of the parser for options: states, decision trees and expressions (report F.5 to F.9).
namespace xabsl::xml {

using namespace syntax;

namespace {

ExpressionPtr leaf(const Element& element, Expression::Kind kind, std::string_view name = {}) {
  auto expression = std::make_unique<Expression>();
  const Attribute* reference = element.find("ref");
  expression->kind = kind;
  expression->location = reference ? reference->location : element.location;
  expression->extent = {expression->location, expression->location};
  expression->name = name;
  return expression;
}

ExpressionPtr boolean(const Element& element) {
  ExpressionPtr expression = leaf(element, Expression::Kind::boolean);
  expression->number = isTrue(element.attribute("value")) ? 1 : 0;
  return expression;
}

}  // namespace

void Parser::option(const Element& element) {
  auto option = declared<Option>(element, "name");
  option_ = option.name.text;
  checkFileName(element, option_, "name");
  visible_.clear();
  for (const Element* child : elementsOf(element))
    if (!child->is("state") && !child->is("common-decision-tree") && !child->is("common-action"))
      visible_.push_back(child);
  const auto prototype = prototypes_.find(option_);
  if (prototype == prototypes_.end()) {
    error(element, "name", "option " + inQuotes(option_) + " has no prototype (option-definition)");
  } else {
    option.parameters = parameters(*prototype->second);
    option.doc = prototype->second->attribute("description");
  }
  for (const Element* child : elementsOf(element)) {
    if (child->is("common-decision-tree")) option.commonDecision = statement(*child);
    if (child->is("common-action")) {
      option.hasCommonActions = true;
      actions(*child, option.commonActions);
    }
    if (!child->is("state")) continue;
    option.states.push_back(state(*child));
    option.states.back().leadingElse = option.commonDecision != nullptr;
  }
  markInitialState(element, option);
  program_.options.push_back(std::move(option));
}

void Parser::markInitialState(const Element& element, Option& option) {
  const std::string_view initial = element.attribute("initial-state");
  const auto found = std::find_if(option.states.begin(), option.states.end(),
                                  [&](const State& state) { return state.name.text == initial; });
  if (found != option.states.end()) {
    found->initial = true;
    return;
  }
  Suggestion suggestion(initial);
  for (const State& state : option.states) suggestion.offer(state.name.text);
  error(element, "initial-state", "unknown state " + inQuotes(initial) + suggestion.text());
}

State Parser::state(const Element& element) {
  auto state = declared<State>(element, "name");
  state.target = isTrue(element.attribute("is-target-state"));
  state.cooperation = cooperation(element);
  state.decisionLocation = element.location;
  for (const Element* child : elementsOf(element))
    if (child->is("decision-tree")) {
      state.decisionLocation = child->location;
      state.decision = statement(*child);
    }
  actions(element, state.actions);
  return state;
}

Cooperation Parser::cooperation(const Element& state) {
  constexpr int mostAgents = 1000;
  Cooperation cooperation;
  for (const auto& [key, kind] : {std::pair("capacity", Cooperation::Kind::capacity),
                                  std::pair("synchronized", Cooperation::Kind::synchronized)}) {
    const Attribute* agents = state.find(key);
    if (!agents) continue;
    cooperation.kind = kind;
    const char* end = agents->value.data() + agents->value.size();
    const auto [last, problem] = std::from_chars(agents->value.data(), end, cooperation.agents);
    if (problem != std::errc() || last != end || cooperation.agents < 0 ||
        cooperation.agents > mostAgents)
      reporter_.error(agents->location, "the number of agents is a whole number up to 1000");
  }
  return cooperation;
}

/// In 3.1 actions are executed in their order. In 2.1 subsequent options may overwrite output
/// symbols (F.6), so they are called last.
void Parser::actions(const Element& parent, std::vector<Action>& actions) {
  std::vector<Action> last;
  for (const Element* child : elementsOf(parent)) {
    if (child->is("decision-tree")) continue;
    if (child->is("set-output-symbol"))
      actions.push_back(setOutputSymbol(*child));
    else if (child->is("subsequent-option") || child->is("subsequent-basic-behavior"))
      (program_.dialect == Dialect::xabsl21 ? last : actions).push_back(subsequent(*child));
    else
      actions.push_back(assignment(*child));
  }
  for (Action& action : last) actions.push_back(std::move(action));
}

/// `set-decimal-output-symbol` sets a `decimal-output-symbol`.
Action Parser::assignment(const Element& element) {
  constexpr std::string_view beginning = "set-";
  refer(element, element.name.substr(beginning.size()));
  Action action;
  action.kind = Action::Kind::assignment;
  action.name = {element.attribute("ref"), element.find("ref")->location};
  action.extent = {element.location, element.location};
  action.value = expression(*elementsOf(element).front());
  return action;
}

Action Parser::setOutputSymbol(const Element& element) {
  const Element* symbol = refer(element, "enumerated-output-symbol");
  Action action;
  action.kind = Action::Kind::assignment;
  action.name = {element.attribute("ref"), element.find("ref")->location};
  action.extent = {element.location, element.location};
  action.value = leaf(element, Expression::Kind::name, element.attribute("value"));
  action.value->location = element.find("value")->location;
  if (symbol) checkElement(element, *symbol);
  return action;
}

Action Parser::subsequent(const Element& element) {
  Action action;
  const bool option = element.is("subsequent-option");
  action.kind = option ? Action::Kind::callOption : Action::Kind::callBehavior;
  action.name = {element.attribute("ref"), element.find("ref")->location};
  action.extent = {element.location, element.location};
  refer(element, option ? "option-definition" : "basic-behavior");
  action.arguments = arguments(element);
  return action;
}

std::vector<Argument> Parser::arguments(const Element& element) {
  std::vector<Argument> arguments;
  for (const Element* child : elementsOf(element)) {
    Argument argument;
    argument.name = {withoutOwner(child->attribute("ref"), element.attribute("ref")),
                     child->find("ref")->location};
    argument.value = expression(*elementsOf(*child).front());
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

/// The decision tree in an element; one without a final decision is the common decision tree of all
/// states (F.5).
DecisionPtr Parser::statement(const Element& parent) {
  auto decision = std::make_unique<Decision>();
  decision->extent = {parent.location, parent.location};
  for (const Element* element : elementsOf(parent)) {
    if (element->is("transition-to-state")) {
      decision->kind = Decision::Kind::go;
      decision->target = {element->attribute("ref"), element->find("ref")->location};
    } else if (element->is("if") || element->is("else-if")) {
      decision->kind = Decision::Kind::choose;
      decision->arms.push_back(arm(*element));
    } else if (element->is("else")) {
      decision->otherwise = statement(*element);
    }
  }
  const bool chain = decision->otherwise && decision->otherwise->kind == Decision::Kind::choose;
  if (!chain || program_.dialect == Dialect::xabsl21) return decision;
  // 3.1 has no `else-if`.
  const DecisionPtr rest = std::move(decision->otherwise);
  for (Arm& arm : rest->arms) decision->arms.push_back(std::move(arm));
  decision->otherwise = std::move(rest->otherwise);
  return decision;
}

Arm Parser::arm(const Element& element) {
  Arm arm;
  const Element& condition = *elementsOf(element).front();
  arm.doc = condition.attribute("description");
  arm.condition = expression(*elementsOf(condition).front());
  arm.decision = statement(element);
  return arm;
}

ExpressionPtr Parser::expression(const Element& element) {
  using Kind = Expression::Kind;
  if (const OperatorSpelling* spelling =
          findOperator([&](const OperatorSpelling& one) { return element.is(one.element); }))
    return operation(element, spelling->operation);
  if (element.is("decimal-value")) return number(element);
  if (element.is("boolean-value")) return boolean(element);
  if (element.is("time-of-state-execution")) return leaf(element, Kind::stateTime);
  if (element.is("time-of-option-execution")) return leaf(element, Kind::optionTime);
  if (element.is("subsequent-option-reached-target-state")) return leaf(element, Kind::actionDone);
  if (element.is("conflict")) return leaf(element, Kind::conflict);
  if (element.is("decimal-input-function-call"))
    return functionCall(element, "decimal-input-function");
  if (element.is("option-parameter-ref")) return optionParameter(element);
  if (element.is("enum-element-ref")) return enumElement(element);
  if (element.is("enumerated-input-symbol-comparison"))
    return program_.dialect == Dialect::xabsl21 ? comparison(element)
                                                : operation(element, Operator::equal);
  return reference(element);
}

/// All remaining elements refer to a symbol: `decimal-input-symbol-ref` to a
/// `decimal-input-symbol`.
ExpressionPtr Parser::reference(const Element& element) {
  constexpr std::string_view ending = "-ref";
  const std::string_view kind = element.name.substr(0, element.name.size() - ending.size());
  if (!elementsOf(element).empty()) return functionCall(element, kind);
  refer(element, kind);
  const bool input = kind.find("-input-") != std::string_view::npos;
  return input ? inputSymbol(element)
               : leaf(element, Expression::Kind::name, element.attribute("ref"));
}

/// Elements belong to their enumeration; `ref` names both.
ExpressionPtr Parser::enumElement(const Element& element) {
  const std::string_view name = element.attribute("ref");
  if (notInputs_.count(name) == 0)
    error(element, "ref", "unknown element " + inQuotes(name) + " of an enumeration");
  return leaf(element, Expression::Kind::name, name);
}

/// XABSL text can distinguish an input symbol from another entity of the same name only by
/// parentheses.
ExpressionPtr Parser::inputSymbol(const Element& element) {
  const std::string_view name = element.attribute("ref");
  const bool shared = notInputs_.count(name) > 0;
  return leaf(element, shared ? Expression::Kind::call : Expression::Kind::name, name);
}

ExpressionPtr Parser::operation(const Element& element, Operator operation) {
  ExpressionPtr node = leaf(element, Expression::Kind::operation);
  node->operation = operation;
  for (const Element* child : elementsOf(element)) {
    const bool wrapped = operation == Operator::conditional;
    node->operands.push_back(expression(wrapped ? *elementsOf(*child).front() : *child));
    node->depth = std::max(node->depth, node->operands.back()->depth + 1);
  }
  if (node->depth > xabsl::Parser::maximalNesting)
    reporter_.error(element.location, "expression is nested too deeply");
  return node;
}

ExpressionPtr Parser::functionCall(const Element& element, std::string_view kind) {
  refer(element, kind);
  ExpressionPtr call = leaf(element, Expression::Kind::call, element.attribute("ref"));
  call->arguments = arguments(element);
  for (const Argument& argument : call->arguments)
    call->depth = std::max(call->depth, argument.value->depth + 1);
  return call;
}

ExpressionPtr Parser::optionParameter(const Element& element) {
  return leaf(element, Expression::Kind::parameter,
              withoutOwner(element.attribute("ref"), option_));
}

ExpressionPtr Parser::comparison(const Element& element) {
  const Element* symbol = refer(element, "enumerated-input-symbol");
  if (symbol) checkElement(element, *symbol);
  ExpressionPtr node = leaf(element, Expression::Kind::operation);
  node->operation = Operator::equal;
  node->operands.push_back(inputSymbol(element));
  node->operands.push_back(leaf(element, Expression::Kind::name, element.attribute("value")));
  node->depth = 2;
  return node;
}

/// A value must be one of the elements of its symbol.
void Parser::checkElement(const Element& element, const Element& symbol) {
  const std::string_view value = element.attribute("value");
  const std::string_view owner = symbol.attribute("name");
  Suggestion suggestion(value);
  for (const Element* candidate : elementsOf(symbol)) {
    const std::string_view name = candidate->attribute("name");
    if (withoutOwner(name, owner) == withoutOwner(value, owner)) return;
    suggestion.offer(name);
  }
  error(element, "value",
        inQuotes(owner) + " has no element " + inQuotes(value) + suggestion.text());
}

/// The entity to which an element refers, if the file of the option includes it.
const Element* Parser::refer(const Element& element, std::string_view kind) {
  const std::string_view name = element.attribute("ref");
  const Element* other = nullptr;
  for (const Element* collection : visible_) {
    const Entries& entries = entriesOf(*collection);
    const auto [first, last] = entries.equal_range(name);
    for (auto found = first; found != last; ++found) {
      if (found->second->is(kind)) return found->second;
      // An option and a basic behavior may have the same name.
      if (!found->second->is("option-definition") && !found->second->is("basic-behavior"))
        other = found->second;
    }
  }
  if (other)
    error(element, "ref",
          inQuotes(name) + " is no " + std::string(kind) + ", but of the kind " +
              std::string(other->name));
  else
    unknown(element, kind);
  return nullptr;
}

void Parser::unknown(const Element& element, std::string_view kind) {
  if (reporter_.full()) return;
  const std::string_view name = element.attribute("ref");
  Suggestion suggestion(name);
  for (const Element* collection : visible_)
    for (const auto& [candidate, entry] : entriesOf(*collection))
      if (entry->is(kind)) suggestion.offer(candidate);
  for (const auto& [key, collection] : collections_) {
    const auto [first, last] = entriesOf(*collection).equal_range(name);
    const bool declared =
        std::any_of(first, last, [&](const auto& entry) { return entry.second->is(kind); });
    if (declared || (collection->is(kind) && collection->attribute("name") == name))
      return error(element, "ref",
                   inQuotes(name) + " is not included by option " + std::string(option_) +
                       ", but declared in " + files_[at(collection->location.file)].path);
  }
  error(element, "ref", "unknown " + std::string(kind) + " " + inQuotes(name) + suggestion.text());
}

}  // namespace xabsl::xml
