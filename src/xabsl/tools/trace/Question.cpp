#include "xabsl/tools/trace/Question.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "xabsl/engine/Engine.h"
#include "xabsl/engine/Symbols.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Lexer.h"

namespace xabsl {

/// The expression is compiled as a behavior of one state; its input symbols are the names that the
/// expression may use.
struct Question::Inside {
  Inside(const Moment& about, Type of) : moment(about), type(of) {}

  const Moment& moment;
  Type type;
  Symbols symbols;
  std::string declarations;
  std::set<std::string> names;
  std::optional<Engine> engine;
  double result = 0;
  bool unknown = false;

  void declareAll(const std::vector<Variable>& variables);
  void declareOption(std::size_t index);
  void declareBehavior(std::size_t index);
  void declareParameters(const std::string& owner, const std::vector<Parameter>& parameters,
                         const std::vector<double>& values);
  bool declareEnumeration(const std::string& name, std::vector<std::string> elements);
  void declare(const std::string& name, Type of, std::function<double()> read);
  void declareState(const std::string& name, const std::string& states, Span span,
                    const int& state);
  bool isFree(const std::string& name);
  std::string typeName(Type of) const;
  int element(int enumeration, double value) const;
  void declareAnswer();
};

namespace {

/// Whether a name is valid in XABSL text; XML and intermediate code allow more names.
bool isName(const std::string& name) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("name"), name, reporter);
  const Token token = lexer.next();
  return token.kind == TokenKind::identifier && token.text == name;
}

Diagnostic placed(Diagnostic diagnostic, std::string_view expression, const std::string& file,
                  Location place) {
  // The expression begins in the second line of what was compiled.
  const auto lines = static_cast<int>(std::count(expression.begin(), expression.end(), '\n')) + 1;
  const int line = std::clamp(diagnostic.line - 2, 0, lines - 1);
  if (line != diagnostic.line - 2) diagnostic.column = 1;
  diagnostic.file = file;
  constexpr std::string_view where = " in option question.option";
  if (const std::size_t at = diagnostic.message.find(where); at != std::string::npos)
    diagnostic.message.erase(at, where.size());
  if (line == 0) diagnostic.column += place.column - 1;
  diagnostic.line = place.line + line;
  if (line == 0 && place.column > 1 && !diagnostic.source.empty())
    diagnostic.source.insert(0, static_cast<std::size_t>(place.column - 1), ' ');
  return diagnostic;
}

}  // namespace

bool Question::Inside::isFree(const std::string& name) {
  return isName(name) && names.insert(name).second;
}

std::string Question::Inside::typeName(Type of) const {
  return describe(moment.subject().model, of);
}

int Question::Inside::element(int enumeration, double value) const {
  const std::vector<double>& values = moment.subject().elementValues[at(enumeration)];
  const auto found = std::find(values.begin(), values.end(), value);
  return found == values.end() ? -1 : static_cast<int>(found - values.begin());
}

bool Question::Inside::declareEnumeration(const std::string& name,
                                          std::vector<std::string> elements) {
  if (!isName(name)) return false;
  std::string list;
  for (const std::string& element : elements)
    if (isName(element)) list += (list.empty() ? "" : ", ") + element;
  if (list.empty()) return false;
  declarations += "enum " + name + " { " + list + " };\n";
  symbols.enumeration(name, std::move(elements));
  return true;
}

void Question::Inside::declare(const std::string& name, Type of, std::function<double()> read) {
  if (!isFree(name)) return;
  if (of.kind == ValueKind::enumeration &&
      !symbols.findEnumeration(moment.subject().model.enumerations[at(of.enumeration)].name))
    return;
  declarations += typeName(of) + " input " + name + ";\n";
  if (of.kind == ValueKind::number)
    symbols.input(name, [read = std::move(read)] { return read(); });
  else if (of.kind == ValueKind::boolean)
    symbols.input(name, [read = std::move(read)] { return read() != 0; });
  else
    symbols.inputIndex(name, moment.subject().model.enumerations[at(of.enumeration)].name,
                       [this, read = std::move(read), enumeration = of.enumeration] {
                         return element(enumeration, read());
                       });
}

void Question::Inside::declareState(const std::string& name, const std::string& states, Span span,
                                    const int& state) {
  if (!symbols.findEnumeration(states) || !isFree(name)) return;
  declarations += "enum " + states + " input " + name + ";\n";
  symbols.inputIndex(name, states,
                     [&state, first = span.first] { return state < 0 ? -1 : state - first; });
}

void Question::Inside::declareParameters(const std::string& owner,
                                         const std::vector<Parameter>& parameters,
                                         const std::vector<double>& values) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name;
    declare(name.starts_with(owner + ".") ? name : owner + "." + name, parameters[i].type,
            [&values, i] { return values[i]; });
  }
}

void Question::Inside::declareOption(std::size_t index) {
  const Option& option = moment.subject().model.options[index];
  const Moment::OptionMoment& now = moment.option(static_cast<int>(index));
  std::vector<std::string> states;
  for (const State& state : option.states.of(moment.subject().model.states))
    states.push_back(state.name);
  const std::string enumeration = option.name + ".state";
  declareEnumeration(enumeration, std::move(states));
  declareState(option.name, enumeration, option.states, now.state);
  declareState(option.name + ".previous", enumeration, option.states, now.previous);
  declare(option.name + ".active", {ValueKind::boolean, -1}, [&now] { return now.state >= 0; });
  declare(option.name + ".time", {}, [&now] { return now.optionTime; });
  declare(option.name + ".state_time", {}, [&now] { return now.stateTime; });
  declareParameters(option.name, option.parameters, now.parameters);
}

void Question::Inside::declareBehavior(std::size_t index) {
  const BasicBehavior& behavior = moment.subject().model.behaviors[index];
  const Moment::BehaviorMoment& now = moment.behavior(static_cast<int>(index));
  declare(behavior.name, {ValueKind::boolean, -1}, [&now] { return now.active; });
  declareParameters(behavior.name, behavior.parameters, now.parameters);
}

void Question::Inside::declareAll(const std::vector<Variable>& variables) {
  const Model& model = moment.subject().model;
  for (const Enumeration& enumeration : model.enumerations) {
    std::vector<std::string> elements;
    for (const EnumerationElement& element : enumeration.elements) elements.push_back(element.name);
    declareEnumeration(enumeration.name, std::move(elements));
  }
  for (const Variable& variable : variables)
    declare(variable.name, variable.type, [value = variable.value] { return *value; });
  for (std::size_t i = 0; i < model.symbols.size(); ++i)
    declare(model.symbols[i].name, model.symbols[i].type, [this, i] {
      const std::optional<double> value = moment.symbol(static_cast<int>(i));
      if (!value) unknown = true;
      return value.value_or(0);
    });
  for (std::size_t i = 0; i < model.options.size(); ++i) declareOption(i);
  for (std::size_t i = 0; i < model.behaviors.size(); ++i) declareBehavior(i);
  declare("time", {}, [this] { return moment.now(); });
  declareAnswer();
}

void Question::Inside::declareAnswer() {
  declarations += typeName(type) + " output question.answer;\n";
  if (type.kind == ValueKind::number) {
    symbols.output("question.answer", &result);
  } else if (type.kind == ValueKind::boolean) {
    symbols.output("question.answer", [this](bool value) { result = value; });
  } else {
    const auto index = static_cast<std::size_t>(type.enumeration);
    symbols.outputIndex("question.answer", moment.subject().model.enumerations[index].name,
                        [this, index](int value) {
                          const auto& values = moment.subject().elementValues[index];
                          if (value >= 0 && static_cast<std::size_t>(value) < values.size())
                            result = values[at(value)];
                        });
  }
}

Question::Making Question::make(const Moment& moment, std::string_view expression, Type type,
                                const std::string& file, Location place,
                                const std::vector<Variable>& variables) {
  Making making;
  if (const std::size_t sign = expression.find_first_of(";{}\""); sign != std::string_view::npos) {
    making.diagnostics.push_back(
        {Diagnostic::Severity::error, file, place.line, place.column,
         std::string("'") + expression[sign] + "' is no part of an expression"});
    return making;
  }
  auto inside = std::make_unique<Inside>(moment, type);
  inside->declareAll(variables);
  const std::string text =
      "option question.option { initial state asking { action { question.answer =\n" +
      std::string(expression) + "\n; } } }\nagent question.agent(\"\", question.option);\n" +
      "namespace question.facts(\"\") {\n" + inside->declarations + "}\n";
  const Compilation compilation = compile("question.xabsl", {{"question.xabsl", text}});
  for (const Diagnostic& diagnostic : compilation.diagnostics)
    if (diagnostic.severity == Diagnostic::Severity::error)
      making.diagnostics.push_back(placed(diagnostic, expression, file, place));
  if (!compilation.behavior) return making;
  Engine::Creation creation = Engine::create(*compilation.behavior, inside->symbols);
  if (!creation.engine) {
    making.diagnostics = std::move(creation.diagnostics);
    return making;
  }
  inside->engine = std::move(creation.engine);
  making.question = Question(std::move(inside));
  return making;
}

Question::Question(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Question::Question(Question&&) noexcept = default;
Question& Question::operator=(Question&&) noexcept = default;
Question::~Question() = default;

std::optional<double> Question::answer() {
  inside_->unknown = false;
  inside_->engine->execute(0);
  if (inside_->unknown) return std::nullopt;
  return inside_->result;
}

}  // namespace xabsl
