#include <algorithm>
#include <utility>

#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/language/Lowering.h"
#include "xabsl/language/ModelText.h"
#include "xabsl/language/Operators.h"

namespace xabsl {

namespace {

constexpr std::string_view lineEnd = "\r\n";

class CodeWriter {
 public:
  CodeWriter(const Model& model, Dialect dialect) : model_(model), dialect_(dialect) {}

  IntermediateCode run() {
    text_ = "// Intermediate code for the agents of " + model_.title;
    endLine();
    endLine();
    internals();
    const std::vector<int> options = sortedByName(model_.options);
    line(std::to_string(options.size()));
    for (const int option : options) declare(model_.options[at(option)]);
    endLine();
    for (const int option : options) define(model_.options[at(option)]);
    agents();
    IntermediateCode code;
    code.diagnostics = std::move(diagnostics_);
    if (code.diagnostics.empty()) code.text = std::move(text_);
    return code;
  }

 private:
  void endLine() { text_ += lineEnd; }
  void line(std::string_view text) {
    text_ += text;
    endLine();
  }

  void refuse(Location location, const std::string& what) {
    diagnostics_.push_back({Diagnostic::Severity::error, model_.files[at(location.file)],
                            location.line, location.column,
                            what + " cannot be said in intermediate code of XABSL 3.0"});
  }

  std::string typed(Type type, const std::string& name) const {
    return typedName(model_, type, name);
  }

  std::string element(int index, int element) const {
    const Enumeration& of = model_.enumerations[at(index)];
    const std::string& name = of.elements[at(element)].name;
    return of.name.empty() ? name : of.name + "." + name;
  }

  void internals() {
    const std::vector<int> enumerations =
        sortedByName(model_.enumerations, [](const Enumeration& one) { return one.internal; });
    line(std::to_string(enumerations.size()));
    for (const int index : enumerations) {
      const Enumeration& one = model_.enumerations[at(index)];
      text_ += one.name + " " + std::to_string(one.elements.size());
      for (std::size_t i = 0; i < one.elements.size(); ++i)
        text_ += " " + element(index, static_cast<int>(i));
      endLine();
    }
    const std::vector<int> symbols = sortedByName(
        model_.symbols, [](const Symbol& symbol) { return symbol.kind == SymbolKind::internal; });
    line(std::to_string(symbols.size()));
    for (const int index : symbols)
      line(typed(model_.symbols[at(index)].type, model_.symbols[at(index)].name));
    endLine();
  }

  void declare(const Option& option) {
    text_ += option.name + " " + std::to_string(option.parameters.size());
    for (const Parameter& parameter : option.parameters)
      text_ += " " + typed(parameter.type, option.name + "." + parameter.name);
    endLine();
  }

  void define(const Option& option) {
    line(std::to_string(option.states.count));
    for (const State& state : option.states.of(model_.states)) listState(state);
    if (dialect_ == Dialect::xabsl30) endLine();
    endLine();
    line(model_.states[at(option.initialState)].name);
    for (const int i : option.states) define(option, i);
    for (int i = 0; i < 3; ++i) endLine();
  }

  void listState(const State& state) {
    using Kind = Cooperation::Kind;
    const Cooperation::Kind kind = state.cooperation.kind;
    text_ += state.name + " ";
    if (dialect_ == Dialect::xabsl30) {
      if (kind != Kind::none) refuse(state.location, "cooperative state '" + state.name + "'");
    } else if (kind == Kind::none) {
      line("n");
    } else {
      line((kind == Kind::capacity ? "c " : "s ") + std::to_string(state.cooperation.agents));
    }
  }

  void define(const Option& option, int index) {
    const State& state = model_.states[at(index)];
    line(state.target ? "1" : "0");
    line(std::to_string(option.commonActions.count + state.actions.count));
    actions(option.commonActions);
    actions(state.actions);
    state_ = index;
    if (option.commonDecision.kind != Branch::Kind::none)
      decision(option.commonDecision, &state.decision);
    else
      decision(state.decision, nullptr);
  }

  void actions(Span span) {
    for (const Action& each : span.of(model_.actions)) action(each);
  }

  void action(const Action& action) {
    if (action.kind == Action::Kind::assignment) {
      const Symbol& symbol = model_.symbols[at(action.target)];
      // Here, unlike elsewhere, the enumeration is left out.
      const bool enumerated = symbol.type.kind == ValueKind::enumeration;
      line(enumerated ? "e " + symbol.name : typed(symbol.type, symbol.name));
      expression(action.operand);
    } else {
      const std::string& name = targetName(model_, action);
      line((action.kind == Action::Kind::option ? "o " : "a ") + name);
      arguments(name, parametersOf(model_, action), action.operand);
    }
  }

  /// Only what was set, in the order in which it was.
  void arguments(const std::string& owner, const std::vector<Parameter>& parameters, int first) {
    const auto order = model_.setParameters(first, parameters.size());
    line(std::to_string(order.size()));
    for (const int index : order) {
      const Parameter& parameter = parameters[at(index)];
      line(typed(parameter.type, owner + "." + parameter.name));
      expression(model_.operands[at(first + index)]);
    }
  }

  /// What decides nothing goes on with `rest`; without that one the state stays.
  void decision(Branch branch, const Branch* rest) {
    // A chain of `else if` may be long: it is written in a loop.
    while (branch.kind == Branch::Kind::decision || (branch.kind == Branch::Kind::none && rest)) {
      if (branch.kind == Branch::Kind::none) {
        branch = *std::exchange(rest, nullptr);
        continue;
      }
      const Decision& decision = model_.decisions[at(branch.index)];
      line("i");
      expression(decision.condition);
      this->decision(decision.then, nullptr);
      branch = decision.otherwise;
    }
    const int target = branch.kind == Branch::Kind::state ? branch.index : state_;
    line("t " + model_.states[at(target)].name);
  }

  void expression(int index) {
    const Expression& expression = model_.expressions[at(index)];
    switch (expression.operation) {
      case Operator::constant:
        return constant(index);
      case Operator::element:
        return line("v " + element(expression.a, expression.b) + " ");
      case Operator::parameter: {
        const Option& option = model_.options[at(expression.a)];
        return line("p " + option.name + "." + option.parameters[at(expression.b)].name);
      }
      case Operator::input: {
        const Symbol& symbol = model_.symbols[at(expression.a)];
        line("i " + symbol.name);
        return arguments(symbol.name, symbol.parameters, expression.b);
      }
      case Operator::variable:
        return line("o " + model_.symbols[at(expression.a)].name);
      case Operator::conflict:
        if (dialect_ == Dialect::xabsl30)
          refuse(model_.expressionLocations[at(index)], "'conflict'");
        return line("x");
      case Operator::stateTime:
        return line("s");
      case Operator::optionTime:
      case Operator::actionDone:
        return line("t");
      case Operator::negate:
        return negation(expression);
      case Operator::logicalAnd:
      case Operator::logicalOr:
        return connection(index);
      case Operator::equal:
      case Operator::notEqual:
        return equality(expression);
      default:
        line(spellingOf(expression.operation).code);
        for (const int operand : {expression.a, expression.b, expression.c})
          if (operand >= 0) this->expression(operand);
    }
  }

  void constant(int index) {
    const Expression& expression = model_.expressions[at(index)];
    if (expression.a >= 0) return line("c " + model_.constants[at(expression.a)].digits);
    if (expression.b >= 0) return line(expression.number != 0 ? "v true" : "v false");
    line("v " + decimalText(expression.number));
  }

  /// A number gets the sign itself, anything else is taken from 0.
  void negation(const Expression& expression) {
    if (const std::optional<double> number = signedNumber(model_, expression))
      return line("v " + decimalText(*number));
    line("-");
    line("v 0");
    this->expression(expression.a);
  }

  /// `&&` below `&&` is one, and so is `||` below `||`.
  void connection(int index) {
    const std::vector<int> operands = flattened(model_, index);
    text_ += spellingOf(model_.expressions[at(index)].operation).code;
    line(" " + std::to_string(operands.size()));
    for (const int operand : operands) expression(operand);
  }

  /// Enumerations are compared by `c` alone.
  void equality(const Expression& expression) {
    const bool equal = expression.operation == Operator::equal;
    if (typeOf(model_, expression.a).kind == ValueKind::enumeration) {
      if (!equal) line("!");
      line("c");
    } else {
      line(equal ? "=" : "n");
    }
    this->expression(expression.a);
    this->expression(expression.b);
  }

  void agents() {
    line(std::to_string(model_.agents.size()));
    for (std::size_t i = 0; i < model_.agents.size(); ++i) {
      const Agent& agent = model_.agents[i];
      if (i > 0) text_ += " ";
      text_ += agent.name + " " + model_.options[at(agent.rootOption)].name;
    }
    endLine();
  }

  const Model& model_;
  Dialect dialect_;
  std::string text_;
  std::vector<Diagnostic> diagnostics_;
  int state_ = -1;  // whose decision tree is being written
};

}  // namespace

IntermediateCode writeIntermediateCode(const Model& model, Dialect dialect) {
  return CodeWriter(model, dialect).run();
}

}  // namespace xabsl
