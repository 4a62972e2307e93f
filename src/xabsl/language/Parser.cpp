#include "xabsl/language/Parser.h"

#include <algorithm>
#include <utility>

namespace xabsl {

using namespace syntax;

namespace {

/// What people write who come from other languages.
constexpr std::pair<std::string_view, std::string_view> foreignWords[] = {
    {"and", "&&"},    {"or", "||"},          {"elseif", "else if"}, {"elif", "else if"},
    {"int", "float"}, {"double", "float"},   {"boolean", "bool"},   {"switch", "if"},
    {"while", "if"},  {"constant", "const"}, {"function", "input"}};

/// What was probably meant by a token that stands where `expected` should, as the end of a message.
std::string hintAt(const Token& token, const std::string& expected) {
  const auto meant = [](std::string_view word) {
    return "; did you mean '" + std::string(word) + "'?";
  };
  if (token.is("=") && expected == "')'") return meant("==");
  if (token.is(",") && expected == "';'") return "; numbers are written with a point";
  if (token.kind == TokenKind::string && expected == "an expression")
    return "; elements of enumerations stand without quotes";
  if (token.kind != TokenKind::identifier) return {};
  for (const auto& [foreign, word] : foreignWords)
    if (token.text == foreign) return meant(word);
  Suggestion suggestion(token.text);
  for (std::size_t open = expected.find('\''); open != std::string::npos;
       open = expected.find('\'', open)) {
    const std::size_t close = std::min(expected.find('\'', open + 1), expected.size());
    suggestion.offer(std::string_view(expected).substr(open + 1, close - open - 1));
    open = std::min(close + 1, expected.size());
  }
  return suggestion.text();
}

}  // namespace

Parser::Parser(int file, std::string_view text, Reporter& reporter, Program& program)
    : reporter_(reporter),
      program_(program),
      lexer_(file, text, reporter, &program.files[at(file)].comments, program.dialect),
      file_(file) {
  token_ = lexer_.next();
}

void Parser::parse() {
  while (token_.kind != TokenKind::end && !reporter_.full()) {
    try {
      declaration();
    } catch (const SyntaxError&) {
      skipToDeclaration();
    }
  }
  header();
}

/// The title and so on of the first header that has some: only the file with the agents has one.
void Parser::header() {
  const auto value = [](std::string_view text, std::string_view key) -> std::string_view {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    const auto start = std::search(text.begin(), text.end(), key.begin(), key.end(),
                                   [&](char a, char b) { return lower(a) == lower(b); });
    if (start == text.end()) return {};
    std::string_view line =
        text.substr(static_cast<std::size_t>(start - text.begin()) + key.size());
    line = line.substr(0, line.find_first_of("\r\n"));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    line = line.substr(first);
    if (line.size() >= 2 && line.substr(line.size() - 2) == "*/") line.remove_suffix(2);
    return line.substr(0, line.find_last_not_of(" \t*") + 1);
  };
  for (const Comment& comment : program_.files[at(file_)].comments) {
    if (comment.kind != Comment::Kind::header) continue;
    Header& header = program_.header;
    if (header.title.empty()) header.title = value(comment.text, "Title:");
    if (header.platform.empty()) header.platform = value(comment.text, "Platform:");
    if (header.softwareEnvironment.empty())
      header.softwareEnvironment = value(comment.text, "Software-Environment:");
  }
}

void Parser::fail(const std::string& message) {
  reporter_.error(token_.location, message);
  throw SyntaxError();
}

void Parser::failExpected(const std::string& what) {
  fail("expected " + what + ", found " + describe(token_) + hintAt(token_, what));
}

Token Parser::take() {
  end_ = token_.end;
  return std::exchange(token_, lexer_.next());
}

/// What a declaration that starts at the next token begins with.
Declaration Parser::begin() {
  return {{}, documentation(token_), {token_.location, token_.location}, space_};
}

/// The documentation before a token that begins something: its comment is no loose one then.
std::string_view Parser::documentation(const Token& token) {
  if (!token.doc.data()) return {};
  std::vector<Comment>& comments = program_.files[at(file_)].comments;
  // It is one of the last, and the last that begins before its text.
  std::find_if(comments.rbegin(), comments.rend(), [&](const Comment& comment) {
    return comment.text.data() < token.doc.data();
  })->documents = true;
  return token.doc;
}

bool Parser::accept(std::string_view text) {
  if (!token_.is(text)) return false;
  take();
  return true;
}

void Parser::expect(std::string_view text) {
  if (!accept(text)) failExpected(inQuotes(text));
}

/// A semicolon that is missing at the end of a line is reported there, not where the next line
/// begins.
void Parser::expectSemicolon() {
  if (accept(";")) return;
  if (token_.location.line == end_.line) failExpected("';'");
  reporter_.error(end_, "expected ';', found the end of the line");
  throw SyntaxError();
}

/// About what this compiler reads and the public compiler of XABSL 3.1 refuses.
void Parser::warnOfDialect(Location location, const std::string& what) {
  reporter_.warning(location, what + "; other XABSL compilers refuse this");
}

/// About the number that is the next token.
void Parser::warnOfExponent() {
  if (token_.text.find_first_of("eE") != std::string_view::npos)
    warnOfDialect(token_.location, "a number with an exponent");
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
  std::string_view stem = reporter_.files()[at(name.location.file)];
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
  expectSemicolon();
  program_.files[at(file_)].includes.push_back({path.text, path.location});
}

void Parser::agent() {
  Agent agent;
  static_cast<Declaration&>(agent) = begin();
  take();
  agent.name = expectName("the name of an agent");
  expect("(");
  if (token_.kind != TokenKind::string) failExpected("the title of the agent in quotes");
  agent.title = take().text;
  expect(",");
  agent.rootOption = expectName("the name of the root option");
  expect(")");
  expectSemicolon();
  agent.extent.end = end_;
  program_.agents.push_back(agent);
}

void Parser::option() {
  Option option;
  static_cast<Declaration&>(option) = begin();
  take();
  option.name = expectName("the name of an option");
  try {
    optionBody(option);
  } catch (const SyntaxError&) {
    // What is whole in it is of use for who types it.
    option.extent.end = end_;
    program_.options.push_back(std::move(option));
    throw;
  }
  option.extent.end = end_;
  accept(";");
  program_.options.push_back(std::move(option));
}

void Parser::optionBody(Option& option) {
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
      } else if (token_.is("action") && !option.hasCommonActions) {
        take();
        option.hasCommonActions = true;
        option.commonActions = actions();
      } else {
        failExpected("'decision' or 'action', each at most once");
      }
    }
  } catch (const SyntaxError&) {
    common_ = false;
    skipToState();
  }
  states(option);
  expect("}");
}

void Parser::states(Option& option) {
  if (!atState()) failExpected("a parameter, 'common' or a state");
  while (atState() && !reporter_.full()) {
    State read;
    try {
      state(read);
      option.states.push_back(std::move(read));
    } catch (const SyntaxError&) {
      State named;
      static_cast<Declaration&>(named) = read;
      named.initial = read.initial;
      named.target = read.target;
      named.extent.end = end_;
      if (!named.name.text.empty()) option.states.push_back(std::move(named));
      skipToState();
    }
  }
  // After an error the closing brace may have been skipped together with a broken last state.
  if (!token_.is("}") && reporter_.failed()) throw SyntaxError();
}

bool Parser::atState() const {
  return token_.is("state") || token_.is("initial") || token_.is("target");
}

void Parser::state(State& state) {
  static_cast<Declaration&>(state) = begin();
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
  state.cooperation = cooperation();
  expect("{");
  stateBody(state);
  expect("}");
  state.extent.end = end_;
}

Cooperation Parser::cooperation() {
  constexpr double mostAgents = 1000;
  Cooperation cooperation;
  const bool named = token_.kind == TokenKind::identifier;
  if (named && (token_.text == "capacity" || token_.text == "synchronized"))
    fail(describe(token_) + " is of XABSL 3.1, in 3.0 robots do not agree about states");
  if (accept("capacity")) {
    cooperation.kind = Cooperation::Kind::capacity;
    if (token_.kind != TokenKind::number) failExpected("the number of agents");
  } else if (accept("synchronized")) {
    cooperation.kind = Cooperation::Kind::synchronized;
  }
  if (cooperation.kind == Cooperation::Kind::none || token_.kind != TokenKind::number)
    return cooperation;
  const bool whole = token_.number <= mostAgents &&
                     token_.number == static_cast<double>(static_cast<int>(token_.number));
  if (!whole) fail("the number of agents is a whole number up to 1000");
  cooperation.agents = static_cast<int>(take().number);
  return cooperation;
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
  if (token_.is("decision")) fail("the decision of a state stands before its action");
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
  action.extent.begin = token_.location;
  action.name = expectName("an action (an assignment, an option or a basic behavior) or '}'");
  if (accept("=")) {
    action.kind = Action::Kind::assignment;
    action.value = expression();
    expectSemicolon();
    action.extent.end = end_;
    return action;
  }
  if (accept("option"))
    action.kind = Action::Kind::callOption;
  else if (accept("behavior"))
    action.kind = Action::Kind::callBehavior;
  if (!token_.is("(")) failExpected("'=' or '('");
  action.arguments = arguments();
  expectSemicolon();
  action.extent.end = end_;
  return action;
}

std::vector<Argument> Parser::arguments() {
  expect("(");
  std::vector<Argument> arguments;
  if (accept(")")) return arguments;
  do {
    Argument argument;
    argument.name = expectName("the name of a parameter, as in 'speed = 100'");
    expect("=");
    argument.value = expression();
    arguments.push_back(std::move(argument));
  } while (accept(",") && !token_.is(")"));  // a last comma may be left over
  if (!token_.is(")")) failExpected("',' or ')'");
  take();
  return arguments;
}

}  // namespace xabsl
