#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "xabsl/formats/Lowering.h"
#include "xabsl/formats/SourceWriter.h"
#include "xabsl/formats/XmlOperators.h"
#include "xabsl/formats/XmlOutput.h"
#include "xabsl/formats/XmlTree.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/ModelText.h"

namespace xabsl {

using xml::Attributes;
using xml::escaped;
using xml::XmlOutput;

namespace {

constexpr const char* doctypeFile = "symbol-and-basic-behavior-files.dtd";
constexpr const char* optionsFile = "options.xml";
constexpr const char* optionsEntity = "options";

/// What the names of elements about a type begin with.
std::string kindOf(ValueKind kind) {
  return kind == ValueKind::number    ? "decimal"
         : kind == ValueKind::boolean ? "boolean"
                                      : "enumerated";
}

std::string qualified(const syntax::Enumeration& enumeration, std::string_view element) {
  const std::string prefix = std::string(enumeration.name.text) + ".";
  return element.starts_with(prefix) ? std::string(element) : prefix + std::string(element);
}

/// A number without exponent, which the schema of 2.1 does not know.
std::string withoutExponent(std::string_view text) {
  if (text.find_first_of("eE") == std::string_view::npos) return std::string(text);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  char buffer[800];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr;
  return {buffer, end};
}

/// Walks the syntax tree, which has the comments, the order and the spelling, and beside it the
/// model, which has the types: both list the same things in the same order.
class XmlWriter {
 public:
  XmlWriter(const syntax::Program& program, const Model& model, Dialect dialect, Reporter& reporter)
      : program_(program),
        model_(model),
        old_(dialect == Dialect::xabsl21),
        reporter_(reporter),
        comments_(program) {}

  VirtualFiles write(const std::string& root) {
    files_[root];
    files_[optionsFile];
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    if (old_) prepareOldOptions();
    for (std::size_t i = 0; i < program_.options.size(); ++i)
      writeOption(program_.options[i], model_.options[i]);
    writeDefinitions();
    if (!old_) writeDoctype();
    writeRoot(root);
    return std::move(files_);
  }

 private:
  struct Included {
    std::string entity;
    std::string path;
    std::string_view space;
    bool behaviors;
  };

  /// A decision tree in both forms. Without a source the state stays.
  struct Tree {
    const syntax::Decision* source;
    Branch branch;
  };

  struct ActionPair {
    const syntax::Action& source;
    const Action& resolved;
  };

  /// XABSL 2.1 has no way to express something.
  void refuse(Location location, const std::string& what) {
    // Actions common to all states are written in each of them.
    if (refused_.insert({location.file, location.line, location.column, what}).second)
      reporter_.error(location, "XABSL 2.1 cannot say this: " + what);
  }

  void comments(Location place) {
    for (const std::string& text : comments_.before(place)) out_.comment(text);
  }

  void comments(const syntax::Declaration& declaration) {
    comments(old_ ? declaration.extent.begin : declaration.name.location);
  }

  // --- Files

  /// A path that no other file has.
  std::string newPath(const std::string& folder, std::string_view name) {
    std::string path = folder + std::string(name) + ".xml";
    for (int i = 2; !files_.emplace(path, "").second; ++i)
      path = folder + std::string(name) + "-" + std::to_string(i) + ".xml";
    return path;
  }

  void finish(const std::string& path, const std::string& doctype, const std::string& text) {
    files_[path] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + doctype + text;
  }

  /// What the root element of each file has.
  Attributes rootAttributes(const char* schema) const {
    const std::string space(old_ ? xml::namespace21 : xml::namespace31);
    Attributes attributes = {{"xmlns", space},
                             {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}};
    if (old_) attributes.push_back({"xsi:schemaLocation", space + " xabsl-2.1." + schema + ".xsd"});
    return attributes;
  }

  void writeCollection(const Collection& collection) {
    const syntax::Namespace& space = *collection.space;
    const char* kind = collection.behaviors ? "basic-behaviors" : "symbols";
    const std::string folder = old_                   ? folderOf(program_, space.extent.begin)
                               : collection.behaviors ? "BasicBehaviors/"
                                                      : "Symbols/";
    const std::string path = newPath(folder, space.name.text);
    comments(space.extent.begin);
    Attributes attributes = rootAttributes(kind);
    attributes.insert(attributes.end(), {{"id", std::string(space.name.text)},
                                         {"title", std::string(space.title)},
                                         {"description", std::string(space.doc)}});
    out_.open(kind, attributes);
    for (const Collection::Member& member : collection.members) {
      comments(declarationOf(member).extent.begin);
      std::visit([this](const auto* declaration) { declare(*declaration); }, member);
    }
    out_.close(kind);
    finish(path, "", out_.take());
    std::string entity(space.name.text);
    const auto taken = [&](const Included& other) { return other.entity == entity; };
    while (entity == optionsEntity || std::any_of(included_.begin(), included_.end(), taken))
      entity += "-2";
    included_.push_back({entity, path, space.name.text, collection.behaviors});
  }

  void writeDefinitions() {
    out_.open("option-definitions", rootAttributes("option-definitions"));
    for (const syntax::Option& option : program_.options)
      function("option-definition", named(option), option.name.text, option.parameters);
    out_.close("option-definitions");
    finish(optionsFile, "", out_.take());
  }

  static std::string entityDeclaration(const std::string& name, const std::string& path) {
    return "<!ENTITY " + name + " SYSTEM \"" + escaped(path) + "\">\n";
  }

  void writeDoctype() {
    std::string text;
    for (const Included& included : included_)
      text += entityDeclaration(included.entity, included.path);
    finish(doctypeFile, "", text + entityDeclaration(optionsEntity, optionsFile));
  }

  void writeRoot(const std::string& root) {
    Attributes attributes = rootAttributes("agent-collection");
    attributes.push_back(
        {"xmlns:xi", old_ ? "http://www.w3.org/2001/XInclude" : "http://www.w3.org/2003/XInclude"});
    out_.open("agent-collection", attributes);
    const syntax::Header& header = program_.header;
    out_.line("<title>" + escaped(header.title) + "</title>");
    out_.line("<platform>" + escaped(header.platform) + "</platform>");
    out_.line("<software-environment>" + escaped(header.softwareEnvironment) +
              "</software-environment>");
    for (const syntax::Agent& agent : program_.agents) {
      comments(agent);
      out_.empty("agent", {{"id", std::string(agent.name.text)},
                           {"title", std::string(agent.title)},
                           {"description", std::string(agent.doc)},
                           {"root-option", std::string(agent.rootOption.text)}});
    }
    out_.line("&options;");
    out_.open("options", {});
    for (const std::string& path : paths_) out_.empty("xi:include", {{"href", path}});
    out_.close("options");
    for (const std::string& rest : comments_.rest()) out_.comment(rest);
    out_.close("agent-collection");
    const std::string options = entityDeclaration(optionsEntity, optionsFile);
    finish(root,
           old_ ? "<!DOCTYPE agent-collection [\n  " + options + "]>\n"
                : "<!DOCTYPE options [\n    " + options + "]>\n",
           out_.take());
  }

  // --- Declarations

  static Attributes named(const syntax::Declaration& declaration) {
    return {{"name", std::string(declaration.name.text)},
            {"description", std::string(declaration.doc)}};
  }

  /// Of a symbol or a parameter of XABSL 3.1.
  template <typename Declaration>
  static Attributes typed(const Declaration& declaration, const std::string& name) {
    Attributes attributes = {{"name", name}, {"description", std::string(declaration.doc)}};
    if (declaration.type.kind == ValueKind::enumeration)
      attributes.insert(attributes.begin() + 1,
                        {"enumeration", std::string(declaration.type.enumeration.text)});
    if (declaration.type.kind == ValueKind::number)
      attributes.insert(attributes.end(), {{"measure", std::string(declaration.unit)},
                                           {"range", std::string(declaration.range)}});
    return attributes;
  }

  void declare(const syntax::Behavior& behavior) {
    function("basic-behavior", named(behavior), behavior.name.text, behavior.parameters);
  }

  void declare(const syntax::Enumeration& enumeration) {
    if (old_) {  // is declared with each symbol
      if (!enumeration.doc.empty()) out_.comment(enumeration.doc);
      return;
    }
    Attributes attributes = named(enumeration);
    if (enumeration.internal) attributes.push_back({"internal", "true"});
    out_.open("enumeration", attributes);
    for (const syntax::Name& element : enumeration.elements)
      out_.empty("enum-element", {{"name", qualified(enumeration, element.text)}});
    out_.close("enumeration");
  }

  void declare(const syntax::Constant& constant) {
    Attributes attributes = named(constant);
    const std::string digits(old_ ? withoutExponent(constant.digits) : constant.digits);
    attributes.insert(old_ ? attributes.end() : attributes.begin() + 1,
                      {"measure", std::string(constant.unit)});
    attributes.insert(old_ ? attributes.end() : attributes.begin() + 1,
                      {"value", (constant.negative ? "-" : "") + digits});
    out_.empty("constant", attributes);
  }

  void declare(const syntax::Symbol& symbol) {
    if (old_) return declareOld(symbol);
    Attributes attributes = typed(symbol, std::string(symbol.name.text));
    if (symbol.kind == SymbolKind::internal) attributes.push_back({"internal", "true"});
    const bool input = symbol.kind == SymbolKind::input;
    function(kindOf(symbol.type.kind) + (input ? "-input-symbol" : "-output-symbol"), attributes,
             symbol.name.text, symbol.parameters);
  }

  void declareOld(const syntax::Symbol& symbol) {
    const Location place = symbol.name.location;
    const bool input = symbol.kind == SymbolKind::input;
    const bool enumerated = symbol.type.kind == ValueKind::enumeration;
    if (!symbol.range.empty())
      reporter_.warning(place, "XABSL 2.1 has no ranges of symbols; that of " +
                                   inQuotes(symbol.name.text) + " is left out");
    if (symbol.kind == SymbolKind::internal) return refuse(place, "an internal symbol");
    if (!input && !enumerated) return refuse(place, "an output symbol that is not enumerated");
    if (symbol.type.kind != ValueKind::number && !symbol.parameters.empty())
      return refuse(place, enumerated ? "an enumerated symbol with parameters"
                                      : "a boolean symbol with parameters");
    if (enumerated) return declareEnumerated(symbol, input);
    Attributes attributes = named(symbol);
    if (symbol.type.kind == ValueKind::boolean)
      return out_.empty("boolean-input-symbol", attributes);
    attributes.push_back({"measure", std::string(symbol.unit)});
    function(symbol.parameters.empty() ? "decimal-input-symbol" : "decimal-input-function",
             attributes, symbol.name.text, symbol.parameters);
  }

  void declareEnumerated(const syntax::Symbol& symbol, bool input) {
    const std::string element = input ? "enumerated-input-symbol" : "enumerated-output-symbol";
    const auto found = std::find_if(program_.enumerations.begin(), program_.enumerations.end(),
                                    [&](const syntax::Enumeration& candidate) {
                                      return candidate.name.text == symbol.type.enumeration.text;
                                    });
    used_.insert({found->name.text, false});
    if (found->internal) refuse(found->name.location, "an internal enumeration");
    out_.open(element, named(symbol));
    for (const syntax::Name& name : found->elements)
      out_.empty("enum-element", {{"name", elementName(symbol.name.text, *found, name.text)}});
    out_.close(element);
  }

  /// In 2.1, elements have the name of their enumeration before them, if it is not that of the
  /// symbol: so symbols of one type are of one type again.
  static std::string elementName(std::string_view symbol, const syntax::Enumeration& enumeration,
                                 std::string_view element) {
    return symbol == enumeration.name.text ? std::string(element) : qualified(enumeration, element);
  }

  void function(const std::string& element, const Attributes& attributes, std::string_view owner,
                const std::vector<syntax::Parameter>& parameters) {
    if (parameters.empty()) return out_.empty(element, attributes);
    out_.open(element, attributes);
    for (const syntax::Parameter& parameter : parameters) {
      const std::string name = std::string(owner) + "." + std::string(parameter.name.text);
      if (old_ && parameter.type.kind != ValueKind::number)
        refuse(parameter.name.location, "a parameter that is not decimal");
      comments(parameter);
      if (old_)
        out_.empty("parameter", {{"name", name},
                                 {"measure", std::string(parameter.unit)},
                                 {"range", std::string(parameter.range)},
                                 {"description", std::string(parameter.doc)}});
      else
        out_.empty(kindOf(parameter.type.kind) + "-parameter", typed(parameter, name));
    }
    out_.close(element);
  }

  // --- Options

  void prepareOldOptions() {
    for (const syntax::Enumeration& enumeration : program_.enumerations)
      if (used_.count({enumeration.name.text, false}) == 0)
        refuse(enumeration.name.location, "an enumeration without a symbol of its type");
    std::stable_partition(included_.begin(), included_.end(),
                          [](const Included& included) { return !included.behaviors; });
  }

  void writeOption(const syntax::Option& option, const Option& resolved) {
    std::string folder = old_ ? folderOf(program_, option.extent.begin) : "";
    if (folder.empty()) folder = "Options/";
    const std::string path = newPath(folder, option.name.text);
    paths_.push_back(path);
    used_.clear();
    comments(option);
    Attributes attributes = rootAttributes("option");
    attributes.insert(attributes.end(),
                      {{"name", std::string(option.name.text)},
                       {"initial-state", model_.states[at(resolved.initialState)].name}});
    out_.open("option", attributes);
    const std::string head = out_.take();
    // In 3.1, only a state's own decision tree can express that it stays: then each has the whole.
    const Tree common{option.commonDecision.get(), resolved.commonDecision};
    const bool copied = !old_ && common.source && stays(*common.source);
    if (common.source && !copied) {
      state_ = nullptr;
      out_.open("common-decision-tree", {});
      decision(common, nullptr);
      out_.close("common-decision-tree");
    }
    if (!old_ && !option.commonActions.empty()) {
      out_.open("common-action", {});
      actions(option.commonActions, resolved.commonActions);
      out_.close("common-action");
    }
    for (std::size_t i = 0; i < option.states.size(); ++i) {
      state_ = &option.states[i];
      state(option, resolved, model_.states[at(resolved.states.first) + i],
            copied ? &common : nullptr);
    }
    out_.close("option");
    const std::string body = out_.take();
    const auto [doctype, entities] = includes(folder);
    finish(path, doctype, head + entities + body);
  }

  /// The document type of an option's file, and the references to what it includes.
  std::pair<std::string, std::string> includes(const std::string& folder) const {
    std::string declarations, references;
    const auto include = [&](const std::string& entity, const std::string& path) {
      references += "  &" + entity + ";\n";
      declarations +=
          "  " +
          entityDeclaration(
              entity, std::filesystem::path(path).lexically_relative(folder).generic_string());
    };
    for (const Included& included : included_)
      if (old_ || used_.count({included.space, included.behaviors}) > 0)
        include(included.entity, included.path);
    include(optionsEntity, optionsFile);
    return {old_ ? "<!DOCTYPE option [\n" + declarations + "]>\n"
                 : std::string("<!DOCTYPE symbol-and-basic-behavior-files SYSTEM \"../") +
                       doctypeFile + "\">\n",
            references};
  }

  static bool stays(const syntax::Decision& decision) {
    return decision.kind == syntax::Decision::Kind::stay ||
           std::any_of(decision.arms.begin(), decision.arms.end(),
                       [](const syntax::Arm& arm) { return stays(*arm.decision); }) ||
           (decision.otherwise && stays(*decision.otherwise));
  }

  void state(const syntax::Option& option, const Option& resolvedOption, const State& resolved,
             const Tree* common) {
    const syntax::State& state = *state_;
    comments(state);
    if (!state.doc.empty()) out_.comment(state.doc);
    Attributes attributes = {{"name", std::string(state.name.text)}};
    if (state.target) attributes.push_back({"is-target-state", "true"});
    if (state.cooperation.kind != Cooperation::Kind::none) {
      if (old_) refuse(state.name.location, "a state in which robots cooperate");
      const bool capacity = state.cooperation.kind == Cooperation::Kind::capacity;
      attributes.push_back(
          {capacity ? "capacity" : "synchronized", std::to_string(state.cooperation.agents)});
    }
    out_.open("state", attributes);
    if (old_)
      oldActions(option, resolvedOption, resolved);
    else
      actions(state.actions, resolved.actions);
    const Tree own{state.decision.get(), resolved.decision};
    out_.open("decision-tree", {});
    decision(common ? *common : own, common ? &own : nullptr);
    out_.close("decision-tree");
    out_.close("state");
  }

  std::vector<ActionPair> pairs(const std::vector<syntax::Action>& sources, Span span) const {
    std::vector<ActionPair> pairs;
    for (std::size_t i = 0; i < sources.size(); ++i)
      pairs.push_back({sources[i], model_.actions[at(span.first) + i]});
    return pairs;
  }

  void actions(const std::vector<syntax::Action>& sources, Span span) {
    for (const ActionPair& action : pairs(sources, span)) this->action(action);
  }

  /// In 2.1: one option or basic behavior; output symbols are set before it, as if the state had
  /// been asked first (F.6). Actions common to all states stand in each of them.
  void oldActions(const syntax::Option& option, const Option& resolved, const State& state) {
    std::vector<ActionPair> all = pairs(option.commonActions, resolved.commonActions);
    for (const ActionPair& own : pairs(state_->actions, state.actions)) all.push_back(own);
    const ActionPair* called = nullptr;
    for (const ActionPair& action : all) {
      const bool assignment = action.resolved.kind == Action::Kind::assignment;
      if (!assignment && called)
        refuse(action.source.name.location, "a second option or basic behavior in a state");
      if (assignment && called && called->resolved.kind == Action::Kind::option)
        refuse(action.source.name.location, "an output symbol set after an option is called");
      if (!assignment) called = &action;
    }
    if (!called) return refuse(state_->name.location, "a state without option or basic behavior");
    action(*called);
    for (const ActionPair& action : all)
      if (action.resolved.kind == Action::Kind::assignment) this->action(action);
  }

  void action(const ActionPair& action) {
    comments(old_ ? action.source.extent.begin : action.source.name.location);
    const int target = action.resolved.target;
    if (action.resolved.kind == Action::Kind::assignment) return assignment(action);
    if (action.resolved.kind == Action::Kind::behavior)
      use(model_.behaviors[at(target)].space, true);
    const bool option = action.resolved.kind == Action::Kind::option;
    arguments(option ? "subsequent-option" : "subsequent-basic-behavior", "set-parameter",
              action.source.name.text, parametersOf(model_, action.resolved),
              action.source.arguments, action.resolved.operand);
  }

  void assignment(const ActionPair& action) {
    const Symbol& symbol = model_.symbols[at(action.resolved.target)];
    const Expression& value = model_.expressions[at(action.resolved.operand)];
    use(symbol.space, false);
    if (!old_) {
      const std::string element = "set-" + kindOf(symbol.type.kind) + "-output-symbol";
      out_.open(element, {{"ref", symbol.name}});
      expression(*action.source.value, action.resolved.operand);
      return out_.close(element);
    }
    if (symbol.type.kind != ValueKind::enumeration) return;  // its declaration is refused
    if (value.operation != Operator::element)
      return refuse(action.source.value->location, "a value that is not an element of its symbol");
    out_.empty("set-output-symbol",
               {{"ref", symbol.name}, {"value", oldElement(symbol.name, value)}});
  }

  /// What decides nothing continues with `rest`.
  void decision(const Tree& tree, const Tree* rest) {
    if (!tree.source) return transition(state_->name.text);
    const syntax::Decision& decision = *tree.source;
    if (old_) comments(decision.extent.begin);
    if (decision.kind == syntax::Decision::Kind::go) return transition(decision.target.text);
    if (decision.kind == syntax::Decision::Kind::choose) return choice(tree, rest);
    if (!state_)
      return refuse(decision.extent.begin, "'stay' in a decision tree common to all states");
    transition(state_->name.text);
  }

  /// The first version has `else-if`, the later one an `if` in an `else`.
  void choice(const Tree& tree, const Tree* rest) {
    const syntax::Decision& decision = *tree.source;
    std::size_t open = 0;
    Branch otherwise;
    for (std::size_t i = 0; i < decision.arms.size(); ++i) {
      const Decision& resolved = model_.decisions[at(tree.branch.index) + i];
      const char* element = old_ && i > 0 ? "else-if" : "if";
      if (!old_ && i > 0) {
        out_.open("else", {});
        ++open;
      }
      out_.open(element, {});
      out_.open("condition", {{"description", std::string(decision.arms[i].doc)}});
      expression(*decision.arms[i].condition, resolved.condition);
      out_.close("condition");
      this->decision({decision.arms[i].decision.get(), resolved.then}, nullptr);
      out_.close(element);
      otherwise = resolved.otherwise;
    }
    if (decision.otherwise || rest) {
      out_.open("else", {});
      this->decision(decision.otherwise ? Tree{decision.otherwise.get(), otherwise} : *rest,
                     nullptr);
      out_.close("else");
    }
    for (; open > 0; --open) out_.close("else");
  }

  void transition(std::string_view state) {
    out_.empty("transition-to-state", {{"ref", std::string(state)}});
  }

  // --- Expressions

  /// The present option needs what is declared in a namespace.
  void use(int space, bool behaviors) {
    used_.insert({program_.namespaces[at(space)].name.text, behaviors});
  }

  void expression(const syntax::Expression& source, int index) {
    const Expression& expression = model_.expressions[at(index)];
    switch (expression.operation) {
      case Operator::constant:
        return constant(source, expression);
      case Operator::element:
        if (old_) return refuse(source.location, "an element of an enumeration as a value");
        use(model_.enumerations[at(expression.a)].space, false);
        return out_.empty("enum-element-ref", {{"ref", elementOf(expression)}});
      case Operator::parameter: {
        const Option& option = model_.options[at(expression.a)];
        return out_.empty("option-parameter-ref",
                          {{"ref", option.name + "." + option.parameters[at(expression.b)].name}});
      }
      case Operator::input:
      case Operator::variable:
        return symbol(source, expression);
      case Operator::stateTime:
        return out_.empty("time-of-state-execution", {});
      case Operator::optionTime:
        return out_.empty("time-of-option-execution", {});
      case Operator::actionDone:
        return out_.empty("subsequent-option-reached-target-state", {});
      case Operator::conflict:
        return old_ ? refuse(source.location, "'conflict'") : out_.empty("conflict", {});
      case Operator::negate:
        return negation(source, expression);
      case Operator::conditional:
        return conditional(source, expression);
      default:
        operation(source, index);
    }
  }

  void constant(const syntax::Expression& source, const Expression& expression) {
    if (expression.a >= 0) {
      const Constant& constant = model_.constants[at(expression.a)];
      use(constant.space, false);
      return out_.empty("constant-ref", {{"ref", constant.name}});
    }
    if (expression.b < 0)
      return number(old_ ? withoutExponent(source.name) : decimalText(expression.number));
    if (old_) return refuse(source.location, "'true' and 'false' in an expression");
    out_.empty("boolean-value", {{"value", expression.number != 0 ? "true" : "false"}});
  }

  void number(const std::string& value) { out_.empty("decimal-value", {{"value", value}}); }

  void symbol(const syntax::Expression& source, const Expression& expression) {
    const Symbol& symbol = model_.symbols[at(expression.a)];
    const bool input = expression.operation == Operator::input;
    if (old_ && !input) return refuse(source.location, "an output symbol that is read");
    if (old_ && symbol.type.kind == ValueKind::enumeration)
      return refuse(source.location, "an enumerated symbol that is not compared with an element");
    use(symbol.space, false);
    const std::string element =
        kindOf(symbol.type.kind) + (input ? "-input-" : "-output-") +
        (old_ && !symbol.parameters.empty() ? "function-call" : "symbol-ref");
    arguments(element, "with-parameter", symbol.name, symbol.parameters, source.arguments,
              expression.b);
  }

  void arguments(const std::string& element, const char* inner, std::string_view name,
                 const std::vector<Parameter>& parameters,
                 const std::vector<syntax::Argument>& arguments, int first) {
    const Attributes reference = {{"ref", std::string(name)}};
    if (arguments.empty()) return out_.empty(element, reference);
    out_.open(element, reference);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const int parameter = model_.argumentOrder[at(first) + i];
      out_.open(inner, {{"ref", std::string(name) + "." + parameters[at(parameter)].name}});
      expression(*arguments[i].value, model_.operands[at(first + parameter)]);
      out_.close(inner);
    }
    out_.close(element);
  }

  /// A number gets the sign itself, anything else is taken from 0.
  void negation(const syntax::Expression& source, const Expression& expression) {
    const syntax::Expression& operand = *source.operands.front();
    if (old_ && operand.kind == syntax::Expression::Kind::number)
      return number("-" + withoutExponent(operand.name));
    if (const auto value = old_ ? std::nullopt : signedNumber(model_, expression))
      return number(decimalText(*value));
    out_.open("minus", {});
    number("0");
    this->expression(operand, expression.a);
    out_.close("minus");
  }

  void conditional(const syntax::Expression& source, const Expression& expression) {
    constexpr const char* names[] = {"condition", "expression1", "expression2"};
    const int operands[] = {expression.a, expression.b, expression.c};
    out_.open("conditional-expression", {});
    for (std::size_t i = 0; i < 3; ++i) {
      out_.open(names[i], {});
      this->expression(*source.operands[i], operands[i]);
      out_.close(names[i]);
    }
    out_.close("conditional-expression");
  }

  void operation(const syntax::Expression& source, int index) {
    const Expression& expression = model_.expressions[at(index)];
    const bool equality =
        expression.operation == Operator::equal || expression.operation == Operator::notEqual;
    const bool comparison = equality && (old_ ? isOldComparison(source, expression)
                                              : isEnumerated(model_, expression.a));
    const bool differs = comparison && expression.operation == Operator::notEqual;
    if (differs) out_.open("not", {});
    if (comparison && old_)
      oldComparison(expression);
    else
      element(comparison ? "enumerated-input-symbol-comparison" : elementOf(expression.operation),
              source, index);
    if (differs) out_.close("not");
  }

  static std::string_view elementOf(Operator operation) {
    return std::find_if(std::begin(xml::operators), std::end(xml::operators),
                        [&](const xml::OperatorElement& e) { return e.operation == operation; })
        ->name;
  }

  void element(std::string_view name, const syntax::Expression& source, int index) {
    out_.open(name, {});
    operands(source, index);
    out_.close(name);
  }

  /// In 3.1, `&&` below `&&` is one, and so is `||` below `||`.
  void operands(const syntax::Expression& source, int index) {
    const Expression& expression = model_.expressions[at(index)];
    const bool connection =
        expression.operation == Operator::logicalAnd || expression.operation == Operator::logicalOr;
    for (std::size_t i = 0; i < source.operands.size(); ++i) {
      const int operand = connection ? model_.operands[at(expression.b) + i]
                          : i == 0   ? expression.a
                                     : expression.b;
      const bool same = model_.expressions[at(operand)].operation == expression.operation;
      if (connection && same && !old_)
        operands(*source.operands[i], operand);
      else
        this->expression(*source.operands[i], operand);
    }
  }

  /// An enumerated input symbol compared with one of its elements.
  bool isOldComparison(const syntax::Expression& source, const Expression& expression) const {
    const Expression& left = model_.expressions[at(expression.a)];
    return left.operation == Operator::input && source.operands.front()->arguments.empty() &&
           model_.expressions[at(expression.b)].operation == Operator::element;
  }

  void oldComparison(const Expression& expression) {
    const std::string& symbol = model_.symbols[at(model_.expressions[at(expression.a)].a)].name;
    out_.empty(
        "enumerated-input-symbol-comparison",
        {{"ref", symbol}, {"value", oldElement(symbol, model_.expressions[at(expression.b)])}});
  }

  std::string elementOf(const Expression& element) const {
    const Enumeration& enumeration = model_.enumerations[at(element.a)];
    return enumeration.name + "." + enumeration.elements[at(element.b)].name;
  }

  std::string oldElement(const std::string& symbol, const Expression& element) const {
    const syntax::Enumeration& enumeration = program_.enumerations[at(element.a)];
    return elementName(symbol, enumeration, enumeration.elements[at(element.b)].text);
  }

  const syntax::Program& program_;
  const Model& model_;
  const bool old_;  // XABSL 2.1
  Reporter& reporter_;
  LooseComments comments_;
  XmlOutput out_;  // of the present file
  VirtualFiles files_;
  std::vector<Included> included_;
  std::vector<std::string> paths_;  // of the options
  /// Namespaces that the present option uses, and whether their basic behaviors; before that, the
  /// enumerations of symbols.
  std::set<std::pair<std::string_view, bool>> used_;
  std::set<std::tuple<int, int, int, std::string>> refused_;
  const syntax::State* state_ = nullptr;
};

}  // namespace

VirtualFiles writeXml(const syntax::Program& program, const Model& model, Dialect dialect,
                      const std::string& root, Reporter& reporter) {
  return XmlWriter(program, model, dialect, reporter).write(root);
}

}  // namespace xabsl
