#include <optional>
#include <utility>

#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/formats/intermediate/IntermediateCodeReader.h"
#include "xabsl/language/Behavior.h"
#include "xabsl/language/ModelText.h"
#include "xabsl/language/Operators.h"
#include "xabsl/language/OptionGraph.h"
#include "xabsl/language/SourceFiles.h"
#include "xabsl/language/Text.h"

/// The part of the reader for expressions, and for the steps that are possible at the end only.
namespace xabsl {

namespace {

/// The operator with a code, if its level is between `first` and `last`.
std::optional<Operator> find(std::string_view code, Level first, Level last) {
  const OperatorSpelling* found = findOperator([&](const OperatorSpelling& one) {
    return one.code == code && one.level >= first && one.level <= last;
  });
  return found ? std::optional(found->operation) : std::nullopt;
}

}  // namespace

int IntermediateCodeReader::add(const Expression& expression, const Token& token) {
  model_.expressions.push_back(expression);
  model_.expressionLocations.push_back(token.location);
  return static_cast<int>(model_.expressions.size()) - 1;
}

int IntermediateCodeReader::expression(ValueKind kind, int depth) {
  if (kind == ValueKind::number) return decimal(depth);
  if (kind == ValueKind::boolean) return boolean(depth);
  return element(depth).expression;
}

int IntermediateCodeReader::decimal(int depth) {
  checkDepth(depth);
  const Token token = token_;
  if (token.text.empty()) failExpected("a number");
  if (const auto operation = find(token.text, Level::sum, Level::product))
    return operands(*operation, ValueKind::number, 2, token, depth);
  if (token.text == "v") {
    take();
    const double value = number();
    take();
    return add({.operation = Operator::constant, .number = value}, token);
  }
  if (token.text == "c") return constant(token);
  if (token.text == "p") return optionParameter(ValueKind::number);
  if (token.text == "i") return input(ValueKind::number, depth);
  if (token.text == "o") return variable(ValueKind::number);
  if (token.text != "s" && token.text != "t" && token.text != "q") failExpected("a number");
  take();
  if (token.text == "s") return add({.operation = Operator::stateTime}, token);
  if (token.text == "t") return add({.operation = Operator::optionTime}, token);
  const int condition = boolean(depth + 1);
  const int then = decimal(depth + 1);
  const int otherwise = decimal(depth + 1);
  return add({.operation = Operator::conditional, .a = condition, .b = then, .c = otherwise},
             token);
}

/// Reads a named constant, of which only the value is known; its digits are kept.
int IntermediateCodeReader::constant(const Token& token) {
  take();
  const double value = number();
  const Token digits = take();
  const auto [entry, added] =
      constants_.emplace(std::string(digits.text), static_cast<int>(model_.constants.size()));
  if (added) model_.constants.push_back({entry->first, entry->first, value, digits.location});
  return add({.operation = Operator::constant, .a = entry->second, .number = value}, token);
}

int IntermediateCodeReader::boolean(int depth) {
  checkDepth(depth);
  const Token token = token_;
  if (const auto operation = find(token.text, Level::comparison, Level::comparison))
    return operands(*operation, ValueKind::number, 2, token, depth);
  if (token.text == "p") return optionParameter(ValueKind::boolean);
  if (token.text == "i") return input(ValueKind::boolean, depth);
  if (token.text == "o") return variable(ValueKind::boolean);
  if (token.text == "&") return connection(Operator::logicalAnd, token, depth);
  if (token.text == "|") return connection(Operator::logicalOr, token, depth);
  if (token.text == "!") return operands(Operator::logicalNot, ValueKind::boolean, 1, token, depth);
  if (token.text == "c") return comparison(token, depth);
  if (token.text == "t" || token.text == "x") {
    take();
    return add({.operation = token.text == "t" ? Operator::actionDone : Operator::conflict}, token);
  }
  if (token.text != "v") failExpected("a condition");
  take();
  if (token_.text != "true" && token_.text != "false") failExpected("'true' or 'false'");
  const double value = take().text == "true" ? 1 : 0;
  return add({.operation = Operator::constant, .b = 1, .number = value}, token);
}

IntermediateCodeReader::Element IntermediateCodeReader::element(int depth) {
  checkDepth(depth);
  const Token token = token_;
  if (token.text == "v") {
    take();
    const Token value = token_;
    name("the name of an element");
    const int domain = enumerations_.fresh();
    const int mention = enumerations_.mention(domain, value.text, value.location);
    return {add({.operation = Operator::element, .a = domain, .b = mention}, token), domain};
  }
  if (token.text == "q") {
    take();
    const int condition = boolean(depth + 1);
    const Element then = element(depth + 1);
    const Element otherwise = element(depth + 1);
    unite(then.domain, otherwise.domain, token);
    return {add({.operation = Operator::conditional,
                 .a = condition,
                 .b = then.expression,
                 .c = otherwise.expression},
                token),
            then.domain};
  }
  int index = -1;
  if (token.text == "p")
    index = optionParameter(ValueKind::enumeration);
  else if (token.text == "i")
    index = input(ValueKind::enumeration, depth);
  else if (token.text == "o")
    index = variable(ValueKind::enumeration);
  else
    failExpected("an element of an enumeration");
  return {index, typeOf(model_, index).enumeration};
}

int IntermediateCodeReader::optionParameter(ValueKind kind) {
  const Token letter = take();
  const Token token = token_;
  name("the name of a parameter");
  const Option& option = model_.options[at(option_)];
  const std::string_view name = withoutOwner(token.text, option.name);
  const int index = indexOf(option.parameters, name);
  if (index < 0)
    fail(token, "option '" + option.name + "' has no parameter '" + std::string(name) + "'");
  if (option.parameters[at(index)].type.kind != kind)
    fail(token, "parameter '" + std::string(name) + "' is used with two types");
  return add({.operation = Operator::parameter, .a = option_, .b = index}, letter);
}

int IntermediateCodeReader::input(ValueKind kind, int depth) {
  const Token letter = take();
  const Token token = token_;
  name("the name of an input symbol");
  const int index = symbol(inputs_, SymbolKind::input, token, kind);
  const int expression = add({.operation = Operator::input, .a = index}, letter);
  arguments({Action::Kind::assignment, index, expression, {}}, depth);
  return expression;
}

int IntermediateCodeReader::variable(ValueKind kind) {
  const Token letter = take();
  const Token token = token_;
  name("the name of an output symbol");
  return add(
      {.operation = Operator::variable, .a = symbol(variables_, SymbolKind::output, token, kind)},
      letter);
}

int IntermediateCodeReader::operands(Operator operation, ValueKind kind, int operandCount,
                                     const Token& token, int depth) {
  take();
  Expression result{.operation = operation};
  result.a = expression(kind, depth + 1);
  if (operandCount > 1) result.b = expression(kind, depth + 1);
  return add(result, token);
}

int IntermediateCodeReader::connection(Operator operation, const Token& token, int depth) {
  take();
  std::vector<int> values;
  for (std::size_t left = count("operands"); left > 0; --left) values.push_back(boolean(depth + 1));
  if (values.empty()) fail(token, "nothing is connected");
  const int first = static_cast<int>(model_.operands.size());
  model_.operands.insert(model_.operands.end(), values.begin(), values.end());
  model_.argumentOrder.resize(model_.operands.size(), -1);
  return add({.operation = operation, .b = first, .c = static_cast<int>(values.size())}, token);
}

/// Reads a comparison of elements of an enumeration.
int IntermediateCodeReader::comparison(const Token& token, int depth) {
  take();
  const Element left = element(depth + 1);
  const Element right = element(depth + 1);
  unite(left.domain, right.domain, token);
  return add({.operation = Operator::equal, .a = left.expression, .b = right.expression}, token);
}

/// Inserts the default of each type, which were not known before, in front of the expressions.
void IntermediateCodeReader::finish() {
  model_.enumerations = enumerations_.resolve();
  resolveTypes();
  const int offset = static_cast<int>(model_.enumerations.size()) + 1;
  resolveExpressions(offset);
  layOutOperands(offset);
}

void IntermediateCodeReader::resolveTypes() {
  const auto resolve = [&](Type& type) {
    if (type.kind == ValueKind::enumeration)
      type.enumeration = enumerations_.enumeration(type.enumeration);
  };
  const auto resolveAll = [&](std::vector<Parameter>& parameters) {
    for (Parameter& parameter : parameters) resolve(parameter.type);
  };
  for (Symbol& symbol : model_.symbols) {
    resolve(symbol.type);
    resolveAll(symbol.parameters);
  }
  for (BasicBehavior& behavior : model_.behaviors) resolveAll(behavior.parameters);
  for (Option& option : model_.options) resolveAll(option.parameters);
}

void IntermediateCodeReader::resolveExpressions(int offset) {
  for (Expression& expression : model_.expressions) {
    switch (expression.operation) {
      case Operator::element:
        expression.a = enumerations_.enumeration(expression.a);
        expression.b = enumerations_.element(expression.b);
        break;
      case Operator::constant:
      case Operator::parameter:
      case Operator::input:
      case Operator::variable:
      case Operator::logicalAnd:
      case Operator::logicalOr:
        break;  // they refer to no expression by themselves
      default:
        for (int* operand : {&expression.a, &expression.b, &expression.c})
          if (*operand >= 0) *operand += offset;
    }
  }
  std::vector<Expression> defaults(1);
  for (int i = 0; i + 1 < offset; ++i)
    defaults.push_back({.operation = Operator::element, .a = i, .b = 0});
  model_.expressions.insert(model_.expressions.begin(), defaults.begin(), defaults.end());
  model_.expressionLocations.insert(model_.expressionLocations.begin(), defaults.size(), {});
}

void IntermediateCodeReader::layOutOperands(int offset) {
  for (int& operand : model_.operands) operand += offset;
  for (Decision& decision : model_.decisions) decision.condition += offset;
  for (Action& action : model_.actions)
    if (action.kind == Action::Kind::assignment) action.operand += offset;
  for (const Call& call : calls_) {
    const int first = static_cast<int>(model_.operands.size());
    for (const Parameter& parameter : parametersOf(call))
      model_.operands.push_back(Model::defaultExpression(parameter.type));
    for (const auto& [parameter, value] : call.arguments) {
      model_.operands[at(first + parameter)] = value + offset;
      model_.argumentOrder.push_back(parameter);
    }
    model_.argumentOrder.resize(model_.operands.size(), -1);
    if (call.kind == Action::Kind::assignment)
      model_.expressions[at(call.caller + offset)].b = first;
    else
      model_.actions[at(call.caller)].operand = first;
  }
}

Compilation readIntermediateCode(const std::string& name, std::string_view text,
                                 const Symbols* registered) {
  Compilation best;
  int furthest = -1;
  // Nothing in the file states the dialect; but hardly anything is sound in both.
  for (const Dialect dialect : {Dialect::xabsl31, Dialect::xabsl30}) {
    Reporter reporter;
    reporter.addFile(name, text);
    IntermediateCodeReader reader(text, dialect, registered, reporter);
    auto model = std::make_shared<Model>(reader.read());
    if (!reporter.failed()) checkOptionGraph(*model, reporter);
    const bool sound = !reporter.failed();
    if (!sound && reader.location().line <= furthest) continue;
    furthest = reader.location().line;
    best = {};
    if (sound) best.behavior.emplace(std::move(model));
    best.diagnostics = reporter.take();
    if (sound) return best;
  }
  return best;
}

Compilation loadIntermediateCode(const std::string& path, const Symbols* registered) {
  constexpr std::size_t largest = 16u << 20;
  std::string text;
  if (const auto problem = readFile(path, text, largest)) {
    Compilation compilation;
    compilation.diagnostics.push_back({Diagnostic::Severity::error, path, 0, 0, *problem});
    return compilation;
  }
  return readIntermediateCode(path, text, registered);
}

}  // namespace xabsl
