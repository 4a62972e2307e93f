#include "xabsl/language/ExpressionAnalyzer.h"

#include <algorithm>

#include "xabsl/language/Operators.h"
#include "xabsl/language/Text.h"

namespace xabsl {

namespace {

constexpr Type number{ValueKind::number, -1};
constexpr Type boolean{ValueKind::boolean, -1};

/// The name of an operator in messages.
std::string quoted(Operator operation) {
  return inQuotes(spellingOf(operation).text);
}

Entity::Kind parameterKind(Entity::Kind owner) {
  if (owner == Entity::Kind::option) return Entity::Kind::optionParameter;
  return owner == Entity::Kind::behavior ? Entity::Kind::behaviorParameter
                                         : Entity::Kind::symbolParameter;
}

}  // namespace

std::string describe(const Model& model, Type type) {
  if (type.kind == ValueKind::number) return "float";
  if (type.kind == ValueKind::boolean) return "bool";
  return "enum " + model.enumerations[at(type.enumeration)].name;
}

int findParameter(const std::vector<Parameter>& parameters, std::string_view name,
                  std::string_view owner) {
  const int index = indexOf(parameters, name);
  return index >= 0 ? index : indexOf(parameters, withoutOwner(name, owner));
}

ExpressionAnalyzer::ExpressionAnalyzer(Model& model, const Names& names, int option,
                                       Reporter& reporter, References* references)
    : model_(model), names_(names), option_(option), reporter_(reporter), references_(references) {}

void ExpressionAnalyzer::refer(const Entity& entity, syntax::Expression& source) {
  if (references_) references_->add(entity, source.name, source.location);
}

/// Returns false for an enumeration that was reported as unknown, which matches any type.
bool ExpressionAnalyzer::isDeclared(Type type) const {
  return type.kind != ValueKind::enumeration || type.enumeration < 0 ||
         !model_.enumerations[at(type.enumeration)].elements.empty();
}

void ExpressionAnalyzer::error(Location location, const std::string& message) {
  const std::string& option = model_.options[at(option_)].name;
  // A hint stays the end of the sentence.
  const std::size_t end = std::min(message.find("; "), message.size());
  reporter_.error(location, message.substr(0, end) + " in option " + option + message.substr(end));
}

int ExpressionAnalyzer::expression(syntax::Expression& source, Type wanted,
                                   const std::string& purpose) {
  const Typed typed = analyze(source, wanted.enumeration);
  if (typed.index < 0 || typed.type == wanted) return typed.index;
  if (!isDeclared(typed.type) || !isDeclared(wanted)) return -1;
  error(source.location, purpose + " must be " + describe(model_, wanted) + ", found " +
                             describe(model_, typed.type));
  return -1;
}

int ExpressionAnalyzer::arguments(const std::vector<syntax::Argument>& sources,
                                  const std::vector<Parameter>& parameters, std::string_view owner,
                                  const std::string& callee, const Entity& entity) {
  std::vector<int> operands(parameters.size(), -1);
  std::vector<bool> given(parameters.size(), false);
  std::vector<int> order;
  for (const syntax::Argument& source : sources) {
    const int index = findParameter(parameters, source.name.text, owner);
    if (index < 0) {
      Suggestion suggestion(source.name.text);
      for (const Parameter& parameter : parameters) suggestion.offer(parameter.name);
      error(source.name.location,
            callee + " has no parameter " + inQuotes(source.name.text) + suggestion.text());
      continue;
    }
    const std::size_t i = static_cast<std::size_t>(index);
    if (references_)
      references_->addQualified(entity, {parameterKind(entity.kind), entity.index, index},
                                source.name.text, source.name.location,
                                source.name.text == parameters[i].name ? 0 : owner.size());
    if (given[i])
      error(source.name.location, "parameter " + inQuotes(source.name.text) + " is set twice");
    else
      order.push_back(index);
    given[i] = true;
    operands[i] = expression(*source.value, parameters[i].type,
                             "parameter " + inQuotes(source.name.text) + " of " + callee);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (!given[i] && isDeclared(parameters[i].type))
      operands[i] = Model::defaultExpression(parameters[i].type);
  return appendOperands(operands, order);
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::analyze(syntax::Expression& source, int enumeration) {
  using Kind = syntax::Expression::Kind;
  switch (source.kind) {
    case Kind::number:
      return add(source, {.operation = Operator::constant, .number = source.number}, number);
    case Kind::boolean:
      return add(source, {.operation = Operator::constant, .b = 1, .number = source.number},
                 boolean);
    case Kind::name:
      return name(source, enumeration);
    case Kind::parameter:
      return parameter(source);
    case Kind::call:
      return call(source);
    case Kind::stateTime:
      return add(source, {.operation = Operator::stateTime}, number);
    case Kind::optionTime:
      return add(source, {.operation = Operator::optionTime}, number);
    case Kind::actionDone:
      return add(source, {.operation = Operator::actionDone}, boolean);
    case Kind::conflict:
      return add(source, {.operation = Operator::conflict}, boolean);
    case Kind::operation:
      return operation(source, enumeration);
  }
  return {};
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::name(syntax::Expression& source, int enumeration) {
  if (enumeration >= 0) {
    const Typed found = element(source, enumeration);
    if (found.index >= 0) return found;
  }
  const int constant = Names::find(names_.constants, source.name);
  const int input = Names::find(names_.inputs, source.name);
  const int output = Names::find(names_.outputs, source.name);
  if ((constant >= 0) + (input >= 0) + (output >= 0) > 1) {
    ambiguous(source, constant >= 0, input >= 0, output >= 0);
    return {};
  }
  if (constant >= 0) {
    refer({Entity::Kind::constant, constant}, source);
    return add(source,
               {.operation = Operator::constant,
                .a = constant,
                .number = model_.constants[at(constant)].value},
               number);
  }
  if (input >= 0 || output >= 0) return symbol(source, std::max(input, output));
  // Written with the name of the enumeration, an element stands for itself anywhere.
  for (std::size_t dot = source.name.find('.'); dot != std::string_view::npos;
       dot = source.name.find('.', dot + 1)) {
    const int named = Names::find(names_.enumerations, source.name.substr(0, dot));
    if (named < 0) continue;
    const Typed found = element(source, named);
    if (found.index >= 0) return found;
  }
  if (!isDeclared({ValueKind::enumeration, enumeration})) return {};
  unknownName(source, enumeration);
  return {};
}

void ExpressionAnalyzer::ambiguous(syntax::Expression& source, bool constant, bool input,
                                   bool output) {
  std::string kinds;
  const auto add = [&](bool present, const char* kind) {
    if (present) kinds += (kinds.empty() ? "" : " and ") + std::string(kind);
  };
  add(constant, "a constant");
  add(input, "an input symbol");
  add(output, "an output symbol");
  error(source.location,
        inQuotes(source.name) + " is " + kinds +
            (input ? ", expected " + inQuotes(std::string(source.name) + "()") + " for the input"
                   : ""));
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::symbol(syntax::Expression& source, int index) {
  refer({Entity::Kind::symbol, index}, source);
  Symbol& symbol = model_.symbols[at(index)];
  if (symbol.firstUse.option < 0) symbol.firstUse = {option_, source.location};
  if (symbol.kind != SymbolKind::input)
    return add(source, {.operation = Operator::variable, .a = index}, symbol.type);
  const int first =
      arguments(source.arguments, symbol.parameters, symbol.name,
                "input symbol " + inQuotes(symbol.name), {Entity::Kind::symbol, index});
  return add(source, {.operation = Operator::input, .a = index, .b = first}, symbol.type);
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::element(syntax::Expression& source, int enumeration) {
  const Enumeration& found = model_.enumerations[at(enumeration)];
  const int index = indexOf(found.elements, withoutOwner(source.name, found.name));
  if (index < 0) return {};
  const bool qualified = source.name != found.elements[at(index)].name;
  if (references_)
    references_->addQualified({Entity::Kind::enumeration, enumeration},
                              {Entity::Kind::element, enumeration, index}, source.name,
                              source.location, qualified ? found.name.size() : 0);
  return add(source, {.operation = Operator::element, .a = enumeration, .b = index},
             {ValueKind::enumeration, enumeration});
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::parameter(syntax::Expression& source) {
  const std::vector<Parameter>& parameters = model_.options[at(option_)].parameters;
  const int index = indexOf(parameters, source.name);
  if (index >= 0) {
    if (references_) {
      Location name = source.location;
      ++name.column;  // behind the @
      references_->add({Entity::Kind::optionParameter, option_, index}, source.name, name);
    }
    return add(source, {.operation = Operator::parameter, .a = option_, .b = index},
               parameters[at(index)].type);
  }
  Suggestion suggestion(source.name);
  for (const Parameter& parameter : parameters) suggestion.offer(parameter.name);
  error(source.location,
        "unknown parameter '@" + std::string(source.name) + "'" + suggestion.text());
  return {};
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::call(syntax::Expression& source) {
  const int index = Names::find(names_.inputs, source.name);
  if (index >= 0) return symbol(source, index);
  if (names_.outputs.count(source.name) > 0 || names_.constants.count(source.name) > 0)
    error(source.location,
          inQuotes(source.name) + " is no input symbol and cannot have parameters");
  else
    unknownName(source, -1);
  return {};
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::operation(syntax::Expression& source,
                                                        int enumeration) {
  switch (source.operation) {
    case Operator::equal:
    case Operator::notEqual:
      return equality(source);
    case Operator::conditional:
      return conditional(source, enumeration);
    case Operator::logicalNot:
    case Operator::logicalAnd:
    case Operator::logicalOr:
      return uniform(source, boolean, boolean);
    case Operator::less:
    case Operator::lessEqual:
    case Operator::greater:
    case Operator::greaterEqual:
      return uniform(source, number, boolean);
    default:
      return uniform(source, number, number);
  }
}

/// An operator whose operands all have the same type.
ExpressionAnalyzer::Typed ExpressionAnalyzer::uniform(syntax::Expression& source, Type operandType,
                                                      Type resultType) {
  const std::string purpose = "operand of " + quoted(source.operation);
  std::vector<int> operands;
  bool failed = false;
  for (const syntax::ExpressionPtr& operand : source.operands) {
    operands.push_back(expression(*operand, operandType, purpose));
    failed = failed || operands.back() < 0;
  }
  if (failed) return {};
  Expression resolved{.operation = source.operation};
  if (source.operation == Operator::logicalAnd || source.operation == Operator::logicalOr) {
    resolved.b = appendOperands(operands);
    resolved.c = static_cast<int>(operands.size());
  } else {
    resolved.a = operands[0];
    if (operands.size() > 1) resolved.b = operands[1];
  }
  return add(source, resolved, resultType);
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::equality(syntax::Expression& source) {
  const Typed left = analyze(*source.operands[0], -1);
  // The left side fixes the enumeration, so that the right side may name its elements short.
  const Typed right = analyze(*source.operands[1], left.type.enumeration);
  if (left.index < 0 || right.index < 0) return {};
  if (!isDeclared(left.type) || !isDeclared(right.type)) return {};
  if (left.type != right.type) {
    error(source.location, quoted(source.operation) + " compares " + describe(model_, left.type) +
                               " with " + describe(model_, right.type));
    return {};
  }
  if (left.type.kind == ValueKind::boolean) {
    error(source.location,
          quoted(source.operation) + " compares float or enum, found bool; use '&&', '||' and '!'");
    return {};
  }
  return add(source, {.operation = source.operation, .a = left.index, .b = right.index}, boolean);
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::conditional(syntax::Expression& source,
                                                          int enumeration) {
  const int condition = expression(*source.operands[0], boolean, "condition of '?:'");
  const Typed then = analyze(*source.operands[1], enumeration);
  const Typed otherwise =
      analyze(*source.operands[2], enumeration >= 0 ? enumeration : then.type.enumeration);
  if (condition < 0 || then.index < 0 || otherwise.index < 0) return {};
  if (!isDeclared(then.type) || !isDeclared(otherwise.type)) return {};
  if (then.type != otherwise.type) {
    error(source.location, "'?:' chooses between " + describe(model_, then.type) + " and " +
                               describe(model_, otherwise.type));
    return {};
  }
  if (then.type.kind == ValueKind::boolean) {
    error(source.location, "'?:' chooses between float or enum, found bool; use '&&' and '||'");
    return {};
  }
  return add(
      source,
      {.operation = Operator::conditional, .a = condition, .b = then.index, .c = otherwise.index},
      then.type);
}

ExpressionAnalyzer::Typed ExpressionAnalyzer::add(syntax::Expression& source,
                                                  const Expression& expression, Type type) {
  model_.expressions.push_back(expression);
  model_.expressionLocations.push_back(source.location);
  source.resolved = static_cast<int>(model_.expressions.size()) - 1;
  return {source.resolved, type};
}

int ExpressionAnalyzer::appendOperands(const std::vector<int>& operands,
                                       const std::vector<int>& order) {
  const int first = static_cast<int>(model_.operands.size());
  model_.operands.insert(model_.operands.end(), operands.begin(), operands.end());
  model_.argumentOrder.insert(model_.argumentOrder.end(), order.begin(), order.end());
  model_.argumentOrder.resize(model_.operands.size(), -1);
  return first;
}

void ExpressionAnalyzer::unknownName(syntax::Expression& source, int enumeration) {
  if (reporter_.full()) return;
  Suggestion suggestion(source.name);
  std::string message = "unknown input symbol " + inQuotes(source.name);
  if (enumeration >= 0) {
    const Enumeration& expected = model_.enumerations[at(enumeration)];
    for (const EnumerationElement& element : expected.elements) suggestion.offer(element.name);
    message = "enumeration " + inQuotes(expected.name) + " has no element " +
              inQuotes(source.name) + ", nor is there a symbol of that name";
  }
  if (source.name == "conflict" && model_.dialect == Dialect::xabsl30)
    return error(source.location, "'conflict' is of XABSL 3.1");
  if (indexOf(model_.options[at(option_)].parameters, source.name) >= 0)
    return error(source.location, message + "; did you mean '@" + std::string(source.name) + "'?");
  for (const Names::Table* table : {&names_.inputs, &names_.outputs, &names_.constants})
    for (const auto& [candidate, index] : *table) suggestion.offer(candidate);
  error(source.location, message + suggestion.text());
}

}  // namespace xabsl
