#include "xabsl/language/Parser.h"

#include <algorithm>
#include <utility>

namespace xabsl {

using namespace syntax;

namespace {

/// Keywords of other languages that users may write, with those of XABSL.
constexpr std::pair<std::string_view, std::string_view> foreignWords[] = {
    {"and", "&&"},    {"or", "||"},          {"elseif", "else if"}, {"elif", "else if"},
    {"int", "float"}, {"double", "float"},   {"boolean", "bool"},   {"switch", "if"},
    {"while", "if"},  {"constant", "const"}, {"function", "input"}};

/// A hint, as the end of a message, about the probable meaning of a token found instead of
/// `expected`.
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
      guesses_ = false;
      declaration();
    } catch (const SyntaxError&) {
      recover();
    }
  }
  header();
}

/// After an error, reads parts that still belong to the option or namespace before it: states of an
/// option that was closed by an extra brace, or symbols behind a broken title. Stops at a
/// declaration.
void Parser::recover() {
  space_ = -1;
  skipToDeclaration();
  while (!reporter_.full() && !atDeclaration()) {
    const bool space = atSymbol() || (atType() && !atParameter());
    if (block_ != (space ? Block::space : Block::option)) guess(space);
    try {
      if (space)
        namespaceBody();
      else
        optionBody();
    } catch (const SyntaxError&) {
      space_ = -1;
    }
    skipToDeclaration();
  }
}

/// Reads parts outside of any option or namespace, on the assumption that its keyword is
/// misspelled. The error was reported already.
void Parser::guess(bool space) {
  guesses_ = true;
  Declaration& guessed = space ? static_cast<Declaration&>(program_.namespaces.emplace_back())
                               : program_.options.emplace_back();
  guessed = begin();
  enter(space ? Block::space : Block::option);
}

void Parser::enter(Block block) {
  block_ = block;
  closed_ = false;
}

/// Reads title, platform and software environment of the first header that has some; only the file
/// with the agents has one.
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
  failAt(token_.location, message);
}

void Parser::failAt(Location location, const std::string& message) {
  if (!guesses_) reporter_.error(location, message);
  throw SyntaxError();
}

void Parser::failExpected(const std::string& what) {
  fail("expected " + what + ", found " + describe(token_) + hintAt(token_, what));
}

Token Parser::take() {
  end_ = token_.end;
  return std::exchange(token_, lexer_.next());
}

/// The beginning of a declaration that starts at the next token; its name is still empty.
Declaration Parser::begin() {
  return {{{}, token_.location}, documentation(token_), {token_.location, token_.location}, space_};
}

/// The documentation before a token that begins a declaration; marks its comment as documentation.
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
  failAt(end_, "expected ';', found the end of the line");
}

/// Warns about constructs that this compiler accepts and the public compiler of XABSL 3.1 refuses.
void Parser::warnOfDialect(Location location, const std::string& what) {
  reporter_.warning(location, what + "; other XABSL compilers refuse this");
}

/// Warns about a number with an exponent as the next token.
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

/// Warns if a declaration is not in the file of its name, where people search for it.
void Parser::warnFileName(const std::string& what, const Name& name) {
  std::string_view stem = reporter_.files()[at(name.location.file)];
  stem = stem.substr(stem.rfind('/') + 1);
  stem = stem.substr(0, stem.rfind('.'));
  if (stem != name.text)
    reporter_.warning(name.location, what + " '" + std::string(name.text) +
                                         "' stands in a file of another name, expected '" +
                                         std::string(name.text) + ".xabsl'");
}

/// Behind the name of an action, `option (` calls an option.
bool Parser::atDeclaration() const {
  return token_.kind == TokenKind::end || token_.is("agent") || token_.is("namespace") ||
         token_.is("include") || (token_.is("option") && !lexer_.isNext('('));
}

/// Whether the next token is a word that begins a part of a namespace, but no part of an option.
bool Parser::atSymbol() const {
  return token_.is("const") || token_.is("input") || token_.is("output") || token_.is("internal") ||
         (token_.is("behavior") && !lexer_.isNext('('));
}

bool Parser::atType() const {
  return token_.is("float") || token_.is("bool") || token_.is("enum");
}

/// Whether the next token is a word that begins a part of an option, but no part of a namespace.
bool Parser::atCommonOrState() const {
  return atState() || token_.is("common");
}

/// Whether a parameter of an option begins here.
bool Parser::atParameter() const {
  return token_.kind == TokenKind::parameter ||
         (atType() && (lexer_.isNext('@') || (block_ == Block::option && !closed_)));
}

/// Also stops at parts of an option or a namespace, but not at parts of the one while the other is
/// open.
void Parser::skipToDeclaration() {
  const bool inSpace = block_ == Block::space && !closed_,
             inOption = block_ == Block::option && !closed_;
  while (!atDeclaration() && !atType() && (inSpace || !atCommonOrState()) &&
         (inOption || !atSymbol()))
    take();
}

void Parser::skipToMember() {
  while (!atDeclaration() && !atType() && !atSymbol() && !token_.is(";") && !token_.is("}")) take();
  accept(";");
}

void Parser::skipToNextParameter() {
  while (!atDeclaration() && !atCommonOrState() && !atType() && !token_.is(";") && !token_.is("}"))
    take();
  accept(";");
}

void Parser::skipToState() {
  while (!atDeclaration() && !atState()) take();
}

void Parser::skipToActions() {
  while (!atDeclaration() && !atState() && !token_.is("action")) take();
}

void Parser::skipToNextAction() {
  while (!atDeclaration() && !atState() && !token_.is(";") && !token_.is("}")) take();
  accept(";");
}

void Parser::declaration() {
  if (token_.is("include") || token_.is("agent")) enter(Block::none);
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
  finish(program_.agents, agent, [&] {
    expect("(");
    if (token_.kind != TokenKind::string) failExpected("the title of the agent in quotes");
    agent.title = take().text;
    expect(",");
    agent.rootOption = expectName("the name of the root option");
    expect(")");
    expectSemicolon();
  });
}

void Parser::option() {
  const Declaration declaration = begin();
  Option& option = program_.options.emplace_back();
  static_cast<Declaration&>(option) = declaration;
  enter(Block::option);
  take();
  try {
    option.name = expectName("the name of an option");
    warnFileName("option", option.name);
    expect("{");
    optionBody();
  } catch (const SyntaxError&) {
    skipToDeclaration();
    option.extent.end = end_;
    throw;
  }
}

/// Reads the body of the last option and its closing brace.
void Parser::optionBody() {
  Option& option = program_.options.back();
  bool broken = false;
  while (atParameter()) {
    try {
      option.parameters.push_back(parameter(true));
    } catch (const SyntaxError&) {
      broken = true;
      skipToNextParameter();
    }
  }
  while (token_.is("common")) {
    try {
      common(option);
    } catch (const SyntaxError&) {
      common_ = false;
      while (!atDeclaration() && !atCommonOrState()) take();
    }
  }
  if (broken && !atState()) throw SyntaxError();
  states(option);
  option.extent.end = end_;
  expect("}");
  closed_ = true;
  option.extent.end = end_;
  accept(";");
}

void Parser::common(Option& option) {
  take();
  if (token_.is("decision") && !option.commonDecision) {
    take();
    option.commonDecision = commonDecision();
  } else if (token_.is("action") && !option.hasCommonActions) {
    take();
    option.hasCommonActions = true;
    actions(option.commonActions);
  } else {
    failExpected("'decision' or 'action', each at most once");
  }
}

void Parser::states(Option& option) {
  if (!atState()) failExpected("a parameter, 'common' or a state");
  while (atState() && !reporter_.full()) {
    State& read = option.states.emplace_back();
    try {
      state(read);
    } catch (const SyntaxError&) {
      skipToState();
    }
    read.extent.end = end_;
  }
  option.extent.end = end_;
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
    try {
      expect("{");
      state.decisionLocation = token_.location;
      state.leadingElse = accept("else");
      state.decision = decision();
      expect("}");
    } catch (const SyntaxError&) {
      skipToActions();
      if (!token_.is("action")) throw;
    }
  }
  expect("action");
  actions(state.actions);
  if (token_.is("decision")) fail("the decision of a state stands before its action");
}

void Parser::actions(std::vector<Action>& actions) {
  expect("{");
  while (!token_.is("}") && !reporter_.full()) {
    try {
      actions.push_back(action());
    } catch (const SyntaxError&) {
      skipToNextAction();
      if (token_.kind != TokenKind::identifier && !token_.is("}")) throw;
    }
  }
  expect("}");
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
