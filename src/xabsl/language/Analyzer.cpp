#include "xabsl/language/Analyzer.h"

#include <utility>

#include "xabsl/language/OptionGraph.h"
#include "xabsl/language/Text.h"

namespace xabsl {

namespace {

// Limits far beyond real behaviors, which bound time and memory for broken files.
constexpr std::size_t maximalElements = 1000;
constexpr std::size_t maximalParameters = 100;

// The longest name that the reader of public XABSL engines accepts.
constexpr std::size_t longestPortableName = 99;

}  // namespace

Analyzer::Analyzer(syntax::Program& program, Reporter& reporter, References* references)
    : program_(program), reporter_(reporter), references_(references) {
  if (references_) references_->declare(program);
}

Model Analyzer::analyze() {
  describeProgram();
  declareEnumerations();
  declareSymbols();
  declareConstants();
  declareBehaviors();
  declareOptions();
  declareAgents();
  for (std::size_t i = 0; i < program_.options.size() && !reporter_.full(); ++i)
    resolveOption(program_.options[i], static_cast<int>(i));
  if (!reporter_.failed()) checkOptionGraph(model_, reporter_);
  return std::move(model_);
}

void Analyzer::describeProgram() {
  model_.files = reporter_.files();
  model_.dialect = program_.dialect;
  model_.title = program_.header.title;
  model_.platform = program_.header.platform;
  model_.softwareEnvironment = program_.header.softwareEnvironment;
  std::set<std::string_view> known;
  for (const syntax::Namespace& source : program_.namespaces) {
    if (!known.insert(source.name.text).second)
      reporter_.warning(source.name.location,
                        "namespace " + inQuotes(source.name.text) + " is declared twice");
    model_.namespaces.push_back({std::string(source.name.text), std::string(source.title),
                                 source.name.location, std::string(source.doc)});
  }
}

void Analyzer::declare(Names::Table& table, const syntax::Name& name, int index,
                       const std::string& what) {
  if (!table.emplace(name.text, index).second)
    reporter_.error(name.location, what + " " + inQuotes(name.text) + " is declared twice");
  if (name.text.size() > longestPortableName)
    reporter_.warning(name.location, what + " " + inQuotes(name.text.substr(0, 20)) + "... has " +
                                         std::to_string(name.text.size()) +
                                         " letters; other engines read at most " +
                                         std::to_string(longestPortableName));
}

void Analyzer::declareEnumerations() {
  model_.expressions.push_back({});
  for (const syntax::Enumeration& source : program_.enumerations) {
    declare(names_.enumerations, source.name, static_cast<int>(model_.enumerations.size()),
            "enumeration");
    model_.expressions.push_back({.operation = Operator::element,
                                  .a = static_cast<int>(model_.enumerations.size()),
                                  .b = 0});
    Enumeration enumeration{
        std::string(source.name.text), {}, source.name.location, source.internal, source.space,
        std::string(source.doc)};
    if (source.elements.size() > maximalElements)
      reporter_.error(source.name.location, "enumeration " + inQuotes(source.name.text) +
                                                " has more than " +
                                                std::to_string(maximalElements) + " elements");
    std::set<std::string_view> known;
    for (const syntax::Name& element : source.elements) {
      const std::string_view name = withoutOwner(element.text, enumeration.name);
      if (!known.insert(name).second)
        reporter_.error(element.location, "element " + inQuotes(name) + " is declared twice");
      enumeration.elements.push_back({std::string(name), element.location});
    }
    model_.enumerations.push_back(std::move(enumeration));
  }
  model_.expressionLocations.resize(model_.expressions.size());
}

void Analyzer::declareSymbols() {
  for (const syntax::Symbol& source : program_.symbols) {
    const bool input = source.kind == SymbolKind::input;
    declare(input ? names_.inputs : names_.outputs, source.name,
            static_cast<int>(model_.symbols.size()), std::string(wordOf(source.kind)) + " symbol");
    Symbol symbol;
    symbol.kind = source.kind;
    symbol.name = source.name.text;
    symbol.location = source.name.location;
    resolve(source.type, symbol.type);
    symbol.parameters = resolve(source.parameters);
    symbol.space = source.space;
    symbol.range = source.range;
    symbol.unit = source.unit;
    symbol.doc = source.doc;
    model_.symbols.push_back(std::move(symbol));
  }
}

void Analyzer::declareConstants() {
  for (const syntax::Constant& source : program_.constants) {
    declare(names_.constants, source.name, static_cast<int>(model_.constants.size()), "constant");
    model_.constants.push_back({std::string(source.name.text),
                                (source.negative ? "-" : "") + std::string(source.digits),
                                source.value, source.name.location, source.space,
                                std::string(source.unit), std::string(source.doc)});
  }
}

void Analyzer::declareBehaviors() {
  for (const syntax::Behavior& source : program_.behaviors) {
    declare(names_.behaviors, source.name, static_cast<int>(model_.behaviors.size()),
            "basic behavior");
    model_.behaviors.push_back({std::string(source.name.text),
                                resolve(source.parameters),
                                source.name.location,
                                {},
                                source.space,
                                std::string(source.doc)});
  }
}

void Analyzer::declareOptions() {
  for (const syntax::Option& source : program_.options) {
    declare(names_.options, source.name, static_cast<int>(model_.options.size()), "option");
    Option option;
    option.name = source.name.text;
    option.location = source.name.location;
    option.doc = source.doc;
    option.parameters = resolve(source.parameters);
    declareStates(source, option);
    model_.options.push_back(std::move(option));
  }
}

void Analyzer::declareStates(const syntax::Option& source, Option& option) {
  option.states = {static_cast<int>(model_.states.size()), static_cast<int>(source.states.size())};
  std::set<std::string_view> known;
  for (const syntax::State& state : source.states) {
    if (!known.insert(state.name.text).second)
      reporter_.error(state.name.location, "state " + inQuotes(state.name.text) +
                                               " is declared twice in option " + option.name);
    if (state.initial && option.initialState >= 0)
      reporter_.error(state.name.location, "option " + option.name +
                                               " has a second initial state, expected exactly one");
    if (state.initial) option.initialState = static_cast<int>(model_.states.size());
    model_.states.push_back({std::string(state.name.text),
                             state.target,
                             {},
                             {},
                             state.name.location,
                             state.cooperation,
                             std::string(state.doc)});
  }
  if (option.initialState < 0)
    reporter_.error(option.location,
                    "option " + option.name + " has no initial state, expected exactly one");
}

void Analyzer::declareAgents() {
  Names::Table known;
  for (const syntax::Agent& source : program_.agents) {
    declare(known, source.name, 0, "agent");
    const int root = Names::find(names_.options, source.rootOption.text);
    if (root < 0)
      unknown(names_.options, source.rootOption, "option");
    else
      refer({Entity::Kind::option, root}, source.rootOption);
    model_.agents.push_back({std::string(source.name.text), root, source.name.location,
                             std::string(source.title), std::string(source.doc)});
  }
}

void Analyzer::refer(const Entity& entity, const syntax::Name& name) {
  if (references_) references_->add(entity, name.text, name.location);
}

void Analyzer::resolve(const syntax::TypeName& source, Type& type) {
  type.kind = source.kind;
  if (source.kind != ValueKind::enumeration) return;
  type.enumeration = Names::find(names_.enumerations, source.enumeration.text);
  if (type.enumeration >= 0) {
    refer({Entity::Kind::enumeration, type.enumeration}, source.enumeration);
    return;
  }
  unknown(names_.enumerations, source.enumeration, "enumeration");
  // One that has any element stands for it, so that no use of what is declared with it is an error.
  type.enumeration = static_cast<int>(model_.enumerations.size());
  model_.enumerations.push_back(
      {std::string(source.enumeration.text), {}, source.enumeration.location});
}

std::vector<Parameter> Analyzer::resolve(const std::vector<syntax::Parameter>& sources) {
  std::vector<Parameter> parameters;
  if (sources.size() > maximalParameters) {
    reporter_.error(sources.front().name.location,
                    "more than " + std::to_string(maximalParameters) + " parameters");
    return parameters;
  }
  std::set<std::string_view> known;
  for (const syntax::Parameter& source : sources) {
    if (!known.insert(source.name.text).second)
      reporter_.error(source.name.location,
                      "parameter " + inQuotes(source.name.text) + " is declared twice");
    Parameter parameter{std::string(source.name.text), {},
                        source.name.location,          std::string(source.range),
                        std::string(source.unit),      std::string(source.doc)};
    resolve(source.type, parameter.type);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

void Analyzer::unknown(const Names::Table& table, const syntax::Name& name,
                       const std::string& what) {
  if (reporter_.full()) return;
  Suggestion suggestion(name.text);
  for (const auto& [candidate, index] : table) suggestion.offer(candidate);
  reporter_.error(name.location, "unknown " + what + " " + inQuotes(name.text) + suggestion.text());
}

void Analyzer::resolveOption(syntax::Option& source, int index) {
  const std::size_t i = static_cast<std::size_t>(index);
  ExpressionAnalyzer expressions(model_, names_, index, reporter_, references_);
  states_.clear();
  int stateIndex = model_.options[i].states.first;
  for (const syntax::State& stateSource : source.states)
    states_.emplace(stateSource.name.text, stateIndex++);
  if (source.commonDecision)
    model_.options[i].commonDecision = branch(*source.commonDecision, expressions);
  model_.options[i].commonActions = actions(source.commonActions, index, expressions);
  std::size_t state = static_cast<std::size_t>(model_.options[i].states.first);
  for (syntax::State& stateSource : source.states) {
    checkElse(source, stateSource);
    model_.states[state].decision = stateSource.decision
                                        ? branch(*stateSource.decision, expressions)
                                        : Branch{Branch::Kind::stay, -1};
    model_.states[state].actions = actions(stateSource.actions, index, expressions);
    ++state;
  }
}

void Analyzer::checkElse(const syntax::Option& option, const syntax::State& state) {
  if (!state.decision || state.leadingElse == (option.commonDecision != nullptr)) return;
  const std::string name(option.name.text);
  if (state.leadingElse)
    return reporter_.error(state.decisionLocation,
                           "unexpected 'else', since option " + name + " has no common decision");
  reporter_.warning(state.decisionLocation,
                    "expected 'else', since option " + name + " has a common decision");
}

Branch Analyzer::branch(const syntax::Decision& source, ExpressionAnalyzer& expressions) {
  if (source.kind == syntax::Decision::Kind::stay) return {Branch::Kind::stay, -1};
  if (source.kind == syntax::Decision::Kind::go) return transition(source.target, expressions);
  // The arms of one chain stand side by side, each one's else is the next.
  const std::size_t first = model_.decisions.size();
  model_.decisions.resize(first + source.arms.size());
  for (std::size_t i = 0; i < source.arms.size(); ++i) {
    Decision decision;
    decision.doc = source.arms[i].doc;
    decision.condition =
        expressions.expression(*source.arms[i].condition, {ValueKind::boolean, -1}, "condition");
    decision.then = branch(*source.arms[i].decision, expressions);
    decision.otherwise = {Branch::Kind::decision, static_cast<int>(first + i + 1)};
    model_.decisions[first + i] = std::move(decision);
  }
  model_.decisions[first + source.arms.size() - 1].otherwise = {};
  if (source.otherwise) {
    const Branch last = branch(*source.otherwise, expressions);
    model_.decisions[first + source.arms.size() - 1].otherwise = last;
  }
  return {Branch::Kind::decision, static_cast<int>(first)};
}

Branch Analyzer::transition(const syntax::Name& target, ExpressionAnalyzer& expressions) {
  const int state = Names::find(states_, target.text);
  if (state >= 0) {
    refer({Entity::Kind::state, state}, target);
    return {Branch::Kind::state, state};
  }
  Suggestion suggestion(target.text);
  for (const auto& [candidate, index] : states_) suggestion.offer(candidate);
  const bool option = names_.options.count(target.text) > 0;
  expressions.error(target.location,
                    "unknown state " + inQuotes(target.text) +
                        (option ? "; options are called by actions" : suggestion.text()));
  return {Branch::Kind::stay, -1};
}

Span Analyzer::actions(std::vector<syntax::Action>& sources, int option,
                       ExpressionAnalyzer& expressions) {
  Span span{static_cast<int>(model_.actions.size()), 0};
  for (syntax::Action& source : sources) {
    Action action;
    action.location = source.name.location;
    const bool valid = source.kind == syntax::Action::Kind::assignment
                           ? assignment(source, option, expressions, action)
                           : call(source, option, expressions, action);
    if (!valid) continue;
    source.resolved = static_cast<int>(model_.actions.size());
    model_.actions.push_back(action);
    ++span.count;
  }
  return span;
}

bool Analyzer::assignment(const syntax::Action& source, int option, ExpressionAnalyzer& expressions,
                          Action& action) {
  action.kind = Action::Kind::assignment;
  action.target = Names::find(names_.outputs, source.name.text);
  if (action.target < 0 && names_.inputs.count(source.name.text) > 0) {
    expressions.error(source.name.location,
                      "input symbol " + inQuotes(source.name.text) + " cannot be set");
    return false;
  }
  if (action.target < 0) {
    Suggestion suggestion(source.name.text);
    for (const auto& [candidate, index] : names_.outputs) suggestion.offer(candidate);
    expressions.error(source.name.location,
                      "unknown output symbol " + inQuotes(source.name.text) + suggestion.text());
    return false;
  }
  refer({Entity::Kind::symbol, action.target}, source.name);
  Symbol& symbol = model_.symbols[at(action.target)];
  if (symbol.firstUse.option < 0) symbol.firstUse = {option, source.name.location};
  action.operand =
      expressions.expression(*source.value, symbol.type, "value of " + inQuotes(source.name.text));
  return action.operand >= 0;
}

bool Analyzer::call(const syntax::Action& source, int option, ExpressionAnalyzer& expressions,
                    Action& action) {
  using Kind = syntax::Action::Kind;
  const int called = Names::find(names_.options, source.name.text);
  const int behavior = Names::find(names_.behaviors, source.name.text);
  if (source.kind == Kind::call && called >= 0 && behavior >= 0) {
    expressions.error(source.name.location,
                      inQuotes(source.name.text) +
                          " is an option and a basic behavior, expected 'option' or 'behavior' "
                          "before '('");
    return false;
  }
  const std::string name = inQuotes(source.name.text);
  if (called >= 0 && source.kind != Kind::callBehavior) {
    action.kind = Action::Kind::option;
    action.target = called;
    refer({Entity::Kind::option, called}, source.name);
    action.operand =
        expressions.arguments(source.arguments, model_.options[at(called)].parameters,
                              source.name.text, "option " + name, {Entity::Kind::option, called});
    return true;
  }
  if (behavior >= 0 && source.kind != Kind::callOption) {
    BasicBehavior& prototype = model_.behaviors[at(behavior)];
    if (prototype.firstUse.option < 0) prototype.firstUse = {option, source.name.location};
    action.kind = Action::Kind::behavior;
    action.target = behavior;
    refer({Entity::Kind::behavior, behavior}, source.name);
    action.operand =
        expressions.arguments(source.arguments, prototype.parameters, source.name.text,
                              "basic behavior " + name, {Entity::Kind::behavior, behavior});
    return true;
  }
  unknownCallee(source, expressions);
  return false;
}

void Analyzer::unknownCallee(const syntax::Action& source, ExpressionAnalyzer& expressions) {
  using Kind = syntax::Action::Kind;
  Suggestion suggestion(source.name.text);
  if (source.kind != Kind::callBehavior)
    for (const auto& [candidate, index] : names_.options) suggestion.offer(candidate);
  if (source.kind != Kind::callOption)
    for (const auto& [candidate, index] : names_.behaviors) suggestion.offer(candidate);
  const std::string what = source.kind == Kind::callOption ? "unknown option "
                           : source.kind == Kind::callBehavior
                               ? "unknown basic behavior "
                               : "unknown option or basic behavior ";
  const bool state = states_.count(source.name.text) > 0;
  expressions.error(source.name.location,
                    what + inQuotes(source.name.text) +
                        (state ? "; a state is entered by a decision" : suggestion.text()));
}

}  // namespace xabsl
