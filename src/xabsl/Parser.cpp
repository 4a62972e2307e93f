#include "xabsl/Parser.h"

#include <utility>

namespace xabsl {

using namespace syntax;

Parser::Parser(int file, std::string_view text, Reporter& reporter, Program& program)
    : reporter_(reporter), program_(program), lexer_(file, text, reporter) {
  token_ = lexer_.next();
}

std::vector<Include> Parser::parse() {
  while (token_.kind != TokenKind::end && !reporter_.full()) {
    try {
      declaration();
    } catch (const SyntaxError&) {
      skipToDeclaration();
    }
  }
  return std::move(includes_);
}

void Parser::fail(const std::string& message) {
  reporter_.error(token_.location, message);
  throw SyntaxError();
}

void Parser::failExpected(const std::string& what) {
  fail("expected " + what + ", found " + describe(token_));
}

Token Parser::take() {
  return std::exchange(token_, lexer_.next());
}

bool Parser::accept(std::string_view text) {
  if (!token_.is(text)) return false;
  take();
  return true;
}

void Parser::expect(std::string_view text) {
  if (!accept(text)) failExpected("'" + std::string(text) + "'");
}

Name Parser::expectName(const std::string& what) {
  if (token_.kind == TokenKind::keyword)
    fail("expected " + what + ", found the keyword " + describe(token_));
  if (token_.kind != TokenKind::identifier) failExpected(what);
  const Token name = take();
  return {name.text, name.location};
}

/// People look for an option in the file of its name.
void Parser::warnFileName(const std::string& what, const Name& name) {
  std::string_view stem = reporter_.files()[static_cast<std::size_t>(name.location.file)];
  stem = stem.substr(stem.rfind('/') + 1);
  stem = stem.substr(0, stem.rfind('.'));
  if (stem != name.text)
    reporter_.warning(name.location, what + " '" + std::string(name.text) +
                                         "' stands in a file of another name, expected '" +
                                         std::string(name.text) + ".xabsl'");
}

void Parser::skipToDeclaration() {
  while (token_.kind != TokenKind::end && !token_.is("option") && !token_.is("agent") &&
         !token_.is("namespace") && !token_.is("include"))
    take();
}

void Parser::skipToMember() {
  while (token_.kind != TokenKind::end && !token_.is(";") && !token_.is("}") &&
         !token_.is("namespace") && !token_.is("option") && !token_.is("agent"))
    take();
  accept(";");
}

void Parser::skipToState() {
  while (token_.kind != TokenKind::end && !atState() && !token_.is("namespace") &&
         !token_.is("option") && !token_.is("agent"))
    take();
}

void Parser::skipToNextAction() {
  while (token_.kind != TokenKind::end && !token_.is(";") && !token_.is("}") && !atState() &&
         !token_.is("namespace") && !token_.is("agent"))
    take();
  accept(";");
}

void Parser::declaration() {
  if (token_.is("include"))
    include();
  else if (token_.is("option"))
    option();
  else if (token_.is("agent"))
    agent();
  else if (token_.is("namespace"))
    namespaceBlock();
  else
    failExpected("'include', 'option', 'agent' or 'namespace'");
}

void Parser::include() {
  take();
  if (token_.kind != TokenKind::string) failExpected("the path of a file in quotes");
  const Token path = take();
  expect(";");
  includes_.push_back({path.text, path.location});
}

void Parser::agent() {
  take();
  Agent agent;
  agent.name = expectName("the name of an agent");
  expect("(");
  if (token_.kind != TokenKind::string) failExpected("the title of the agent in quotes");
  take();
  expect(",");
  agent.rootOption = expectName("the name of the root option");
  expect(")");
  expect(";");
  program_.agents.push_back(agent);
}

void Parser::namespaceBlock() {
  take();
  warnFileName("namespace", expectName("the name of a namespace"));
  expect("(");
  if (token_.kind != TokenKind::string) failExpected("the title of the namespace in quotes");
  take();
  expect(")");
  expect("{");
  while (!token_.is("}") && token_.kind != TokenKind::end && !reporter_.full()) {
    try {
      namespaceMember();
    } catch (const SyntaxError&) {
      skipToMember();
      if (token_.is("namespace") || token_.is("option") || token_.is("agent")) return;
    }
  }
  expect("}");
  accept(";");
}

void Parser::namespaceMember() {
  if (token_.is("behavior")) return behavior();
  if (token_.is("enum")) return enumeration();
  if (token_.is("const")) return constant();
  TypeName type;
  const bool typed = typeName(type);
  if (token_.is("const")) {
    if (type.kind != ValueKind::number) fail("constants are of type float");
    return constant();
  }
  if (token_.is("input") || token_.is("output") || token_.is("internal")) return symbol(type);
  failExpected(typed ? "'input', 'output' or 'internal'"
                     : "a declaration of a symbol, a constant, an enumeration or a behavior");
}

/// `enum` starts a declaration of an enumeration, or of a symbol of that type.
void Parser::enumeration() {
  take();
  const Name name = expectName("the name of an enumeration");
  if (accept("{")) return enumerationElements({name, {}});
  if (!token_.is("input") && !token_.is("output") && !token_.is("internal"))
    failExpected("'{', 'input', 'output' or 'internal'");
  symbol({ValueKind::enumeration, name});
}

void Parser::enumerationElements(Enumeration enumeration) {
  try {
    do enumeration.elements.push_back(expectName("the name of an element"));
    while (accept(","));
    if (!token_.is("}")) failExpected("',' or '}'");
  } catch (const SyntaxError&) {
    while (token_.kind != TokenKind::end && !token_.is("}") && !token_.is(";")) take();
  }
  accept("}");
  accept(";");
  program_.enumerations.push_back(std::move(enumeration));
}

void Parser::constant() {
  take();
  Constant constant;
  constant.name = expectName("the name of a constant");
  expect("=");
  const bool negative = accept("-");
  if (token_.kind != TokenKind::number) failExpected("a number");
  constant.value = take().number;
  if (negative) constant.value = -constant.value;
  unitAndRange();
  expect(";");
  program_.constants.push_back(constant);
}

void Parser::symbol(TypeName type) {
  Symbol symbol;
  symbol.type = type;
  symbol.kind = token_.is("input")    ? SymbolKind::input
                : token_.is("output") ? SymbolKind::output
                                      : SymbolKind::internal;
  take();
  // `enum E input { a, b }` declares the enumeration: what it is used for is seen from its use.
  if (type.kind == ValueKind::enumeration && accept("{"))
    return enumerationElements({type.enumeration, {}});
  symbol.name = expectName("the name of a symbol");
  unitAndRange();
  if (token_.is("(")) {
    if (symbol.kind != SymbolKind::input)
      reporter_.error(token_.location, "only input symbols have parameters");
    take();
    symbol.parameters = parameters(")");
  }
  expect(";");
  program_.symbols.push_back(std::move(symbol));
}

void Parser::behavior() {
  take();
  Behavior behavior;
  behavior.name = expectName("the name of a basic behavior");
  expect("{");
  behavior.parameters = parameters("}");
  accept(";");
  program_.behaviors.push_back(std::move(behavior));
}

bool Parser::typeName(TypeName& type) {
  if (accept("float")) return true;
  if (accept("bool")) {
    type.kind = ValueKind::boolean;
    return true;
  }
  if (!accept("enum")) return false;
  type.kind = ValueKind::enumeration;
  type.enumeration = expectName("the name of an enumeration");
  return true;
}

std::vector<Parameter> Parser::parameters(std::string_view close) {
  std::vector<Parameter> parameters;
  while (!token_.is(close)) {
    try {
      parameters.push_back(parameter(false));
    } catch (const SyntaxError&) {
      skipToMember();
      if (token_.kind == TokenKind::end || reporter_.full()) throw;
      if (!token_.is(close) && (token_.kind == TokenKind::punctuation || token_.is("option") ||
                                token_.is("agent") || token_.is("namespace")))
        throw;
    }
  }
  take();
  return parameters;
}

Parameter Parser::parameter(bool ofOption) {
  Parameter parameter;
  typeName(parameter.type);
  if (ofOption) {
    if (token_.kind != TokenKind::parameter)
      failExpected("the name of a parameter, as in '@speed'");
    const Token name = take();
    parameter.name = {name.text, name.location};
  } else {
    parameter.name = expectName("the name of a parameter");
  }
  unitAndRange();
  expect(";");
  return parameter;
}

/// Both are for people; the unit comes after the range or before it.
void Parser::unitAndRange() {
  if (token_.kind == TokenKind::range) take();
  if (token_.kind == TokenKind::string) take();
  if (token_.kind == TokenKind::range) take();
}

void Parser::option() {
  take();
  Option option;
  option.name = expectName("the name of an option");
  warnFileName("option", option.name);
  expect("{");
  while (token_.kind == TokenKind::parameter || token_.is("float") || token_.is("bool") ||
         token_.is("enum"))
    option.parameters.push_back(parameter(true));
  try {
    while (accept("common")) {
      if (token_.is("decision") && !option.commonDecision) {
        take();
        option.commonDecision = commonDecision();
      } else if (token_.is("action") && option.commonActions.empty()) {
        take();
        option.commonActions = actions();
      } else {
        failExpected("'decision' or 'action', each at most once");
      }
    }
  } catch (const SyntaxError&) {
    skipToState();
  }
  states(option);
  expect("}");
  program_.options.push_back(std::move(option));
}

void Parser::states(Option& option) {
  if (!atState()) failExpected("a parameter, 'common' or a state");
  while (atState() && !reporter_.full()) {
    try {
      option.states.push_back(state());
    } catch (const SyntaxError&) {
      skipToState();
    }
  }
  // After an error the closing brace may have been skipped together with a broken last state.
  if (!token_.is("}") && reporter_.failed()) throw SyntaxError();
}

bool Parser::atState() const {
  return token_.is("state") || token_.is("initial") || token_.is("target");
}

State Parser::state() {
  State state;
  for (;;) {
    if (!state.initial && accept("initial"))
      state.initial = true;
    else if (!state.target && accept("target"))
      state.target = true;
    else
      break;
  }
  expect("state");
  state.name = expectName("the name of a state");
  refuseCooperation();
  expect("{");
  stateBody(state);
  expect("}");
  return state;
}

void Parser::refuseCooperation() {
  if (!token_.is("capacity") && !token_.is("synchronized")) return;
  reporter_.error(token_.location,
                  "cooperative states ('" + std::string(token_.text) + "') are not supported");
  take();
  if (token_.kind == TokenKind::number) take();
}

void Parser::stateBody(State& state) {
  if (accept("decision")) {
    expect("{");
    state.decisionLocation = token_.location;
    state.leadingElse = accept("else");
    state.decision = decision();
    expect("}");
  }
  expect("action");
  state.actions = actions();
}

std::vector<Action> Parser::actions() {
  expect("{");
  std::vector<Action> actions;
  while (!token_.is("}") && !reporter_.full()) {
    try {
      actions.push_back(action());
    } catch (const SyntaxError&) {
      skipToNextAction();
      if (token_.kind != TokenKind::identifier && !token_.is("}")) throw;
    }
  }
  expect("}");
  return actions;
}

Action Parser::action() {
  Action action;
  action.name = expectName("an action (an assignment, an option or a basic behavior) or '}'");
  if (accept("=")) {
    action.kind = Action::Kind::assignment;
    action.value = expression();
    expect(";");
    return action;
  }
  if (accept("option"))
    action.kind = Action::Kind::callOption;
  else if (accept("behavior"))
    action.kind = Action::Kind::callBehavior;
  if (!token_.is("(")) failExpected("'=' or '('");
  action.arguments = arguments();
  expect(";");
  return action;
}

std::vector<Argument> Parser::arguments() {
  expect("(");
  std::vector<Argument> arguments;
  if (accept(")")) return arguments;
  do {
    Argument argument;
    argument.name = expectName("the name of a parameter");
    expect("=");
    argument.value = expression();
    arguments.push_back(std::move(argument));
  } while (accept(","));
  if (!token_.is(")")) failExpected("',' or ')'");
  take();
  return arguments;
}

}  // namespace xabsl
