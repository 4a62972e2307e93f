#include "xabsl/formats/intermediate/IntermediateCodeReader.h"

#include <charconv>

#include "xabsl/engine/Symbols.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/language/Text.h"

/// The part of the reader for declarations, options, states and actions.
namespace xabsl {

namespace {

bool separates(char c) {
  return isBlank(c) || c == '\v';
}

}  // namespace

IntermediateCodeReader::IntermediateCodeReader(std::string_view text, Dialect dialect,
                                               const Symbols* registered, Reporter& reporter)
    : text_(text),
      dialect_(dialect),
      registered_(registered),
      reporter_(reporter),
      enumerations_(registered, reporter) {
  take();
}

Model IntermediateCodeReader::read() {
  model_.dialect = dialect_;
  model_.files = reporter_.files();
  try {
    internalEnumerations();
    internalSymbols();
    declareOptions();
    for (option_ = 0; at(option_) < model_.options.size(); ++option_)
      defineOption(model_.options[at(option_)]);
    agents();
    if (!token_.text.empty()) failExpected("the end of the file");
    finish();
  } catch (const Failed&) {
  }
  return std::move(model_);
}

void IntermediateCodeReader::fail(const Token& token, const std::string& message) {
  reporter_.error(token.location, message);
  throw Failed();
}

void IntermediateCodeReader::failExpected(const std::string& what) {
  fail(token_, "expected " + what + ", found " +
                   (token_.text.empty() ? "the end of the file" : inQuotes(token_.text)));
}

IntermediateCodeReader::Token IntermediateCodeReader::take() {
  skipBlanks();
  const std::size_t start = position_;
  const Location location = location_;
  while (position_ < text_.size() && !separates(text_[position_])) ++position_;
  location_.column += static_cast<int>(position_ - start);
  return std::exchange(token_, Token{text_.substr(start, position_ - start), location});
}

void IntermediateCodeReader::skipBlanks() {
  bool comment = false;
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (c == '\n') {
      comment = false;
      ++location_.line;
      location_.column = 1;
      continue;
    }
    comment = comment || (c == '/' && text_.substr(position_, 2) == "//");
    if (!comment && !separates(c)) return;
    ++location_.column;
  }
}

std::string IntermediateCodeReader::name(const std::string& what) {
  if (token_.text.empty()) failExpected(what);
  if (token_.text.size() > Lexer::longestName)
    fail(token_, "name is longer than " + std::to_string(Lexer::longestName) + " characters");
  return std::string(take().text);
}

/// Reads a count. It cannot exceed the number of characters left, which protects against wrong
/// counts.
std::size_t IntermediateCodeReader::count(const std::string& what) {
  std::size_t count = 0;
  const char* end = token_.text.data() + token_.text.size();
  const auto [stop, error] = std::from_chars(token_.text.data(), end, count);
  if (token_.text.empty() || error != std::errc() || stop != end || count > text_.size())
    failExpected("the number of " + what);
  take();
  return count;
}

double IntermediateCodeReader::number() {
  double value = 0;
  const char* end = token_.text.data() + token_.text.size();
  const auto [stop, error] = std::from_chars(token_.text.data(), end, value);
  const bool finite = value - value == 0;
  if (token_.text.empty() || error != std::errc() || stop != end || !finite)
    failExpected("a number");
  return value;
}

/// `d`, `b` or `e`.
ValueKind IntermediateCodeReader::kind() {
  if (token_.text == "d" || token_.text == "b" || token_.text == "e") {
    const char letter = take().text.front();
    return letter == 'd'   ? ValueKind::number
           : letter == 'b' ? ValueKind::boolean
                           : ValueKind::enumeration;
  }
  failExpected("a type, 'd', 'b' or 'e'");
}

/// `d`, `b` or `e enumeration`; the type holds a domain.
Type IntermediateCodeReader::typed() {
  Type type{kind(), -1};
  if (type.kind == ValueKind::enumeration)
    type.enumeration = enumerations_.named(name("the name of an enumeration"));
  return type;
}

void IntermediateCodeReader::internalEnumerations() {
  for (std::size_t left = count("internal enumerations"); left > 0; --left) {
    const Token enumeration = token_;
    name("the name of an enumeration");
    std::vector<std::string_view> elements;
    for (std::size_t open = count("elements"); open > 0; --open) {
      elements.push_back(token_.text);
      name("the name of an element");
    }
    enumerations_.declare(enumeration.text, elements, enumeration.location);
  }
}

void IntermediateCodeReader::internalSymbols() {
  for (std::size_t left = count("internal symbols"); left > 0; --left) {
    Symbol symbol;
    symbol.kind = SymbolKind::internal;
    symbol.type = typed();
    symbol.location = token_.location;
    symbol.name = name("the name of a symbol");
    if (!variables_.emplace(symbol.name, static_cast<int>(model_.symbols.size())).second)
      fail({symbol.name, symbol.location},
           "symbol " + inQuotes(symbol.name) + " is declared twice");
    model_.symbols.push_back(std::move(symbol));
  }
}

void IntermediateCodeReader::declareOptions() {
  for (std::size_t left = count("options"); left > 0; --left) {
    Option option;
    const Token token = token_;
    option.location = token.location;
    option.name = name("the name of an option");
    if (!options_.emplace(option.name, static_cast<int>(model_.options.size())).second)
      fail(token, "option " + inQuotes(option.name) + " is declared twice");
    for (std::size_t open = count("parameters"); open > 0; --open) {
      Parameter parameter;
      parameter.type = typed();
      parameter.location = token_.location;
      parameter.name = withoutOwner(name("the name of a parameter"), option.name);
      if (indexOf(option.parameters, parameter.name) >= 0)
        fail({parameter.name, parameter.location},
             "parameter " + inQuotes(parameter.name) + " is declared twice");
      option.parameters.push_back(std::move(parameter));
    }
    model_.options.push_back(std::move(option));
  }
}

void IntermediateCodeReader::defineOption(Option& option) {
  listStates(option);
  const Token initial = take();
  option.initialState = state(initial);
  for (const int i : option.states) defineState(i);
}

void IntermediateCodeReader::listStates(Option& option) {
  states_.clear();
  option.states.first = static_cast<int>(model_.states.size());
  const std::size_t states = count("states");
  if (states == 0) fail(token_, "option " + inQuotes(option.name) + " has no states");
  for (std::size_t i = 0; i < states; ++i) {
    State state;
    const Token token = token_;
    state.location = token.location;
    state.name = name("the name of a state");
    if (dialect_ == Dialect::xabsl31) state.cooperation = cooperation();
    if (!states_.emplace(state.name, static_cast<int>(model_.states.size())).second)
      fail(token, "state " + inQuotes(state.name) + " is declared twice");
    model_.states.push_back(std::move(state));
  }
  option.states.count = static_cast<int>(states);
}

Cooperation IntermediateCodeReader::cooperation() {
  if (token_.text != "n" && token_.text != "c" && token_.text != "s")
    failExpected("'n', 'c' or 's' behind the name of a state");
  const char kind = take().text.front();
  if (kind == 'n') return {};
  const int agents = static_cast<int>(count("agents"));
  return {kind == 'c' ? Cooperation::Kind::capacity : Cooperation::Kind::synchronized, agents};
}

int IntermediateCodeReader::state(const Token& token) {
  const auto found = states_.find(token.text);
  if (found == states_.end())
    fail(token, token.text.empty() ? "expected a state, found the end of the file"
                                   : "unknown state " + inQuotes(token.text));
  return found->second;
}

void IntermediateCodeReader::defineState(int index) {
  if (token_.text != "0" && token_.text != "1")
    failExpected("'1' for a target state or '0' for another one");
  model_.states[at(index)].target = take().text == "1";
  Span span{static_cast<int>(model_.actions.size()), 0};
  for (std::size_t left = count("actions"); left > 0; --left) action();
  span.count = static_cast<int>(model_.actions.size()) - span.first;
  model_.states[at(index)].actions = span;
  model_.states[at(index)].decision = statement(0);
}

/// `t state`, or `i condition statement statement`.
Branch IntermediateCodeReader::statement(int depth) {
  checkDepth(depth);
  Branch first;
  // A chain of else branches may be long: it is read in a loop.
  for (int last = -1;;) {
    const Token token = token_;
    Branch branch;
    if (token.text == "t") {
      take();
      branch = {Branch::Kind::state, state(take())};
    } else if (token.text == "i") {
      take();
      branch = {Branch::Kind::decision, static_cast<int>(model_.decisions.size())};
      model_.decisions.emplace_back();
      const int condition = boolean(0);
      const Branch then = statement(depth + 1);
      model_.decisions[at(branch.index)].condition = condition;
      model_.decisions[at(branch.index)].then = then;
    } else {
      failExpected("'t' or 'i'");
    }
    if (last < 0)
      first = branch;
    else
      model_.decisions[at(last)].otherwise = branch;
    if (branch.kind == Branch::Kind::state) return first;
    last = branch.index;
  }
}

void IntermediateCodeReader::agents() {
  std::map<std::string, bool> known;
  const Token place = token_;
  for (std::size_t left = count("agents"); left > 0; --left) {
    Agent agent;
    const Token token = token_;
    agent.location = token.location;
    agent.name = name("the name of an agent");
    if (!known.emplace(agent.name, true).second)
      fail(token, "agent " + inQuotes(agent.name) + " is declared twice");
    const auto root = options_.find(token_.text);
    if (root == options_.end()) failExpected("the root option of agent " + inQuotes(agent.name));
    take();
    agent.rootOption = root->second;
    model_.agents.push_back(std::move(agent));
  }
  if (model_.agents.empty()) fail(place, "there is no agent");
}

void IntermediateCodeReader::action() {
  const Token letter = token_;
  Action action;
  action.location = letter.location;
  if (letter.text == "d" || letter.text == "b" || letter.text == "e") {
    assignment(action);
    model_.actions.push_back(action);
    return;
  }
  if (letter.text != "o" && letter.text != "a")
    failExpected("an action, 'o', 'a', 'd', 'b' or 'e'");
  take();
  const Token token = token_;
  name("the name of what is called");
  if (letter.text == "o") {
    const auto found = options_.find(token.text);
    if (found == options_.end()) fail(token, "unknown option " + inQuotes(token.text));
    action.target = found->second;
  } else {
    action.kind = Action::Kind::behavior;
    action.target = behavior(token);
  }
  const int index = static_cast<int>(model_.actions.size());
  model_.actions.push_back(action);
  arguments({action.kind, action.target, index, {}}, 0);
}

void IntermediateCodeReader::assignment(Action& action) {
  const ValueKind type = kind();
  const Token token = token_;
  name("the name of an output symbol");
  action.kind = Action::Kind::assignment;
  action.target = symbol(variables_, SymbolKind::output, token, type);
  if (type != ValueKind::enumeration) {
    action.operand = expression(type, 0);
    return;
  }
  const Element value = element(0);
  unite(model_.symbols[at(action.target)].type.enumeration, value.domain, token);
  action.operand = value.expression;
}

/// Finds an input symbol, or an output or internal one; an unknown name becomes a new input or
/// output symbol of that type.
int IntermediateCodeReader::symbol(std::map<std::string, int, std::less<>>& table,
                                   SymbolKind symbolKind, const Token& token, ValueKind kind) {
  const auto found = table.find(token.text);
  if (found != table.end()) {
    if (model_.symbols[at(found->second)].type.kind != kind)
      fail(token, "symbol " + inQuotes(token.text) + " is used with two types");
    return found->second;
  }
  Symbol symbol;
  symbol.kind = symbolKind;
  symbol.name = token.text;
  symbol.type.kind = kind;
  if (kind == ValueKind::enumeration) symbol.type.enumeration = enumerations_.fresh();
  symbol.location = token.location;
  symbol.firstUse = {option_, token.location};
  completeInput(symbol);
  const int index = static_cast<int>(model_.symbols.size());
  table.emplace(symbol.name, index);
  model_.symbols.push_back(std::move(symbol));
  return index;
}

int IntermediateCodeReader::behavior(const Token& token) {
  const auto found = behaviors_.find(token.text);
  if (found != behaviors_.end()) return found->second;
  const int index = static_cast<int>(model_.behaviors.size());
  BasicBehavior behavior{std::string(token.text), {}, token.location, {option_, token.location}};
  const RegisteredFunction* known =
      registered_ ? registered_->findBehavior(behavior.name) : nullptr;
  if (known) behavior.parameters = registeredParameters(*known, token);
  behaviors_.emplace(behavior.name, index);
  model_.behaviors.push_back(std::move(behavior));
  return index;
}

/// Completes a symbol by the registered information that intermediate code does not contain.
void IntermediateCodeReader::completeInput(Symbol& symbol) {
  if (!registered_) return;
  const RegisteredFunction* known = symbol.kind == SymbolKind::input
                                        ? registered_->findInput(symbol.name)
                                        : registered_->findOutput(symbol.name);
  if (!known) return;
  const Token token{symbol.name, symbol.location};
  if (symbol.kind == SymbolKind::input) symbol.parameters = registeredParameters(*known, token);
  if (symbol.type.kind == ValueKind::enumeration && known->type.kind == ValueKind::enumeration)
    unite(symbol.type.enumeration, enumerations_.named(registered_->enumerationName(known->type)),
          token);
}

std::vector<Parameter> IntermediateCodeReader::registeredParameters(
    const RegisteredFunction& function, const Token& token) {
  std::vector<Parameter> parameters;
  for (const RegisteredParameter& registered : function.parameters) {
    Parameter parameter{registered.name, {registered.type.kind, -1}, token.location};
    if (parameter.type.kind == ValueKind::enumeration)
      parameter.type.enumeration =
          enumerations_.named(registered_->enumerationName(registered.type));
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

std::vector<Parameter>& IntermediateCodeReader::parametersOf(const Call& call) {
  if (call.kind == Action::Kind::option) return model_.options[at(call.target)].parameters;
  if (call.kind == Action::Kind::behavior) return model_.behaviors[at(call.target)].parameters;
  return model_.symbols[at(call.target)].parameters;
}

const std::string& IntermediateCodeReader::nameOf(const Call& call) {
  if (call.kind == Action::Kind::option) return model_.options[at(call.target)].name;
  if (call.kind == Action::Kind::behavior) return model_.behaviors[at(call.target)].name;
  return model_.symbols[at(call.target)].name;
}

/// `K { type name value }`
void IntermediateCodeReader::arguments(Call call, int depth) {
  for (std::size_t left = count("parameters"); left > 0; --left) {
    const Type type = typed();
    const Token token = token_;
    name("the name of a parameter");
    const int index = parameter(call, type, token);
    for (const auto& [other, value] : call.arguments)
      if (other == index) fail(token, "parameter " + inQuotes(token.text) + " is set twice");
    int value = -1;
    if (type.kind == ValueKind::enumeration) {
      const Element given = element(depth + 1);
      unite(type.enumeration, given.domain, token);
      value = given.expression;
    } else {
      value = expression(type.kind, depth + 1);
    }
    call.arguments.emplace_back(index, value);
  }
  calls_.push_back(std::move(call));
}

int IntermediateCodeReader::parameter(const Call& call, Type type, const Token& token) {
  constexpr std::size_t mostParameters = 100;
  const std::string_view name = withoutOwner(token.text, nameOf(call));
  std::vector<Parameter>& parameters = parametersOf(call);
  const int index = indexOf(parameters, name);
  if (index < 0) {
    if (call.kind == Action::Kind::option || parameters.size() >= mostParameters)
      fail(token, inQuotes(nameOf(call)) + " has no parameter " + inQuotes(name));
    parameters.push_back({std::string(name), type, token.location});
    return static_cast<int>(parameters.size()) - 1;
  }
  const Type known = parameters[at(index)].type;
  if (known.kind != type.kind)
    fail(token, "parameter " + inQuotes(token.text) + " is used with two types");
  if (type.kind == ValueKind::enumeration) unite(known.enumeration, type.enumeration, token);
  return index;
}

void IntermediateCodeReader::unite(int a, int b, const Token& token) {
  if (!enumerations_.unite(a, b))
    fail(token, "different enumerations where " + inQuotes(token.text) + " is used");
}

void IntermediateCodeReader::checkDepth(int depth) {
  constexpr int deepest = 1000;
  if (depth > deepest) fail(token_, "nested too deeply, at most 1000 levels");
}

}  // namespace xabsl
