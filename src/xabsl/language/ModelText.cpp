#include "xabsl/language/ModelText.h"

#include <array>
#include <charconv>
#include <utility>

#include "xabsl/language/Operators.h"

namespace xabsl {

namespace {

std::string numberText(double number) {
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

class Writer {
 public:
  explicit Writer(const Model& model) : model_(model) {}

  /// `wanted` is the least level that needs no parentheses; elements are written `fully` with their
  /// enumeration where nothing else names it.
  void write(int index, Level wanted, bool fully = false) {
    const Expression& expression = model_.expressions[at(index)];
    const bool parentheses = spellingOf(expression.operation).level < wanted;
    if (parentheses) text_ += '(';
    operation(expression, fully);
    if (parentheses) text_ += ')';
  }

  void call(const std::string& name, const std::vector<Parameter>& parameters, int first) {
    text_ += name;
    arguments(parameters, first);
  }

  void assignment(const std::string& name, int value) {
    text_ += name + " = ";
    write(value, lowest);
  }

  std::string take() { return std::move(text_); }

 private:
  void operation(const Expression& expression, bool fully) {
    const OperatorSpelling spelling = spellingOf(expression.operation);
    switch (expression.operation) {
      case Operator::logicalAnd:
      case Operator::logicalOr:
        for (int i = 0; i < expression.c; ++i) {
          if (i > 0) between(spelling);
          write(model_.operands[at(expression.b + i)], next(spelling.level));
        }
        return;
      case Operator::negate:
      case Operator::logicalNot:
        text_ += spelling.text;
        // Not a decrement, which people would take two signs for.
        return write(expression.a, expression.operation == Operator::negate ? primary : sign);
      case Operator::conditional:
        write(expression.a, disjunction);
        text_ += " ? ";
        write(expression.b, disjunction, fully);
        text_ += " : ";
        return write(expression.c, disjunction);
      default:
        if (spelling.level == primary) return value(expression, fully);
        // Comparisons do not associate, all others do to the left.
        write(expression.a, spelling.level == comparison ? sum : spelling.level,
              spelling.level == comparison);
        between(spelling);
        write(expression.b, next(spelling.level));
    }
  }

  void between(const OperatorSpelling& spelling) {
    text_ += ' ';
    text_ += spelling.text;
    text_ += ' ';
  }

  static Level next(Level level) { return static_cast<Level>(level + 1); }

  void value(const Expression& expression, bool fully) {
    switch (expression.operation) {
      case Operator::constant:
        text_ += expression.a >= 0        ? model_.constants[at(expression.a)].name
                 : expression.b != 1      ? numberText(expression.number)
                 : expression.number != 0 ? "true"
                                          : "false";
        return;
      case Operator::element: {
        const Enumeration& enumeration = model_.enumerations[at(expression.a)];
        if (fully) text_ += enumeration.name + ".";
        text_ += enumeration.elements[at(expression.b)].name;
        return;
      }
      case Operator::parameter:
        text_ += "@" + model_.options[at(expression.a)].parameters[at(expression.b)].name;
        return;
      case Operator::input: {
        const Symbol& symbol = model_.symbols[at(expression.a)];
        text_ += symbol.name;
        if (!symbol.parameters.empty()) arguments(symbol.parameters, expression.b);
        return;
      }
      case Operator::variable:
        text_ += model_.symbols[at(expression.a)].name;
        return;
      default:
        text_ += expression.operation == Operator::stateTime    ? "state_time"
                 : expression.operation == Operator::optionTime ? "option_time"
                 : expression.operation == Operator::actionDone ? "action_done"
                                                                : "conflict";
    }
  }

  void arguments(const std::vector<Parameter>& parameters, int first) {
    text_ += '(';
    const char* separator = "";
    for (const int parameter : model_.setParameters(first, parameters.size())) {
      text_ += std::exchange(separator, ", ");
      assignment(parameters[at(parameter)].name, model_.operands[at(first + parameter)]);
    }
    text_ += ')';
  }

  const Model& model_;
  std::string text_;
};

}  // namespace

Type typeOf(const Model& model, int index) {
  const Expression& expression = model.expressions[at(index)];
  switch (expression.operation) {
    case Operator::constant:
      return {expression.b >= 0 ? ValueKind::boolean : ValueKind::number, -1};
    case Operator::element:
      return {ValueKind::enumeration, expression.a};
    case Operator::parameter:
      return model.options[at(expression.a)].parameters[at(expression.b)].type;
    case Operator::input:
    case Operator::variable:
      return model.symbols[at(expression.a)].type;
    case Operator::conditional:
      return typeOf(model, expression.b);
    case Operator::stateTime:
    case Operator::optionTime:
    case Operator::negate:
    case Operator::add:
    case Operator::subtract:
    case Operator::multiply:
    case Operator::divide:
    case Operator::modulo:
      return {};
    default:
      return {ValueKind::boolean, -1};
  }
}

std::string expressionText(const Model& model, int expression) {
  Writer writer(model);
  writer.write(expression, lowest);
  return writer.take();
}

std::string valueText(const Model& model, const std::vector<std::vector<double>>& elements,
                      Type type, double value) {
  if (type.kind == ValueKind::boolean) return value != 0 ? "true" : "false";
  if (type.kind == ValueKind::enumeration) {
    const std::vector<double>& values = elements[at(type.enumeration)];
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string& name = model.enumerations[at(type.enumeration)].elements[i].name;
      if (values[i] == value && !name.empty()) return name;
    }
  }
  return numberText(value);
}

const std::string& targetName(const Model& model, const Action& action) {
  if (action.kind == Action::Kind::option) return model.options[at(action.target)].name;
  if (action.kind == Action::Kind::behavior) return model.behaviors[at(action.target)].name;
  return model.symbols[at(action.target)].name;
}

const std::vector<Parameter>& parametersOf(const Model& model, const Action& action) {
  static const std::vector<Parameter> none;
  if (action.kind == Action::Kind::option) return model.options[at(action.target)].parameters;
  if (action.kind == Action::Kind::behavior) return model.behaviors[at(action.target)].parameters;
  return none;
}

std::string actionText(const Model& model, const Action& action) {
  Writer writer(model);
  const std::string& name = targetName(model, action);
  if (action.kind == Action::Kind::assignment)
    writer.assignment(name, action.operand);
  else
    writer.call(name, parametersOf(model, action), action.operand);
  return writer.take();
}

}  // namespace xabsl
