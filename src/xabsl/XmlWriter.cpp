#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "xabsl/SourceWriter.h"
#include "xabsl/XmlTree.h"

namespace xabsl {

using namespace syntax;

namespace {

std::string quoted(std::string_view text) {
  return "'" + std::string(text) + "'";
}

/// Text as it may stand in an attribute or an element.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n' || c == '\t')
      result += c == '\n' ? "&#10;" : "&#9;";
    else if (c != '\r')
      result += c;
  }
  return result;
}

std::string_view elementOf(Operator operation) {
  switch (operation) {
    case Operator::logicalAnd:
      return "and";
    case Operator::logicalOr:
      return "or";
    case Operator::logicalNot:
      return "not";
    case Operator::equal:
      return "equal-to";
    case Operator::notEqual:
      return "not-equal-to";
    case Operator::less:
      return "less-than";
    case Operator::lessEqual:
      return "less-than-or-equal-to";
    case Operator::greater:
      return "greater-than";
    case Operator::greaterEqual:
      return "greater-than-or-equal-to";
    case Operator::add:
      return "plus";
    case Operator::multiply:
      return "multiply";
    case Operator::divide:
      return "divide";
    case Operator::modulo:
      return "mod";
    case Operator::conditional:
      return "conditional-expression";
    default:
      return "minus";
  }
}

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

class XmlWriter {
 public:
  XmlWriter(const Program& program, Reporter& reporter)
      : program_(program), reporter_(reporter), comments_(program) {
    for (const Symbol& symbol : program.symbols) symbols_.emplace(symbol.name.text, &symbol);
    for (const Constant& constant : program.constants) constants_.insert(constant.name.text);
    for (const Option& option : program.options) options_.insert(option.name.text);
    for (const Enumeration& enumeration : program.enumerations)
      enumerations_.emplace(enumeration.name.text, &enumeration);
  }

  VirtualFiles write(const std::string& root) {
    files_[root];
    files_["options.xml"];
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    for (const Enumeration& enumeration : program_.enumerations)
      if (used_.count(enumeration.name.text) == 0)
        cannot(enumeration.name.location, "an enumeration without a symbol of its type");
    for (const Option& option : program_.options) writeOption(option);
    writeDefinitions();
    writeRoot(root);
    return std::move(files_);
  }

 private:
  struct Included {
    std::string entity;
    std::string path;
    bool behaviors;
  };

  void cannot(Location location, const std::string& what) {
    reporter_.error(location, "XABSL 2.1 cannot say this: " + what);
  }

  // --- Files

  /// A path that no other file has.
  std::string newPath(const std::string& folder, std::string_view name) {
    std::string path = folder + std::string(name) + ".xml";
    for (int i = 2; !files_.emplace(path, "").second; ++i)
      path = folder + std::string(name) + "-" + std::to_string(i) + ".xml";
    return path;
  }

  void finish(const std::string& path, const std::string& doctype = {}) {
    files_[path] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + doctype + text_;
    text_.clear();
  }

  /// What the root element of each file has.
  static Attributes rootAttributes(const char* schema) {
    return {
        {"xmlns", std::string(xml::namespace21)},
        {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
        {"xsi:schemaLocation", std::string(xml::namespace21) + " xabsl-2.1." + schema + ".xsd"}};
  }

  static std::string fromFolder(const std::string& path, const std::string& folder) {
    return std::filesystem::path(path)
        .lexically_relative(folder.empty() ? "." : folder)
        .generic_string();
  }

  void writeCollection(const Collection& collection) {
    const Namespace& space = *collection.space;
    const char* kind = collection.behaviors ? "basic-behaviors" : "symbols";
    const std::string path = newPath(folderOf(program_, space.extent.begin), space.name.text);
    comments(space.extent.begin);
    Attributes attributes = rootAttributes(kind);
    attributes.insert(attributes.end(), {{"id", std::string(space.name.text)},
                                         {"title", std::string(space.title)},
                                         {"description", std::string(space.doc)}});
    open(kind, attributes);
    for (const Declaration* member : collection.members) this->member(collection, *member);
    close(kind);
    finish(path);
    std::string entity(space.name.text);
    while (entity == "options" ||
           std::any_of(included_.begin(), included_.end(),
                       [&](const Included& i) { return i.entity == entity; }))
      entity += "-2";
    included_.push_back({entity, path, collection.behaviors});
  }

  void member(const Collection& collection, const Declaration& member) {
    comments(member.extent.begin);
    if (collection.behaviors)
      return prototype("basic-behavior", member, static_cast<const Behavior&>(member).parameters);
    for (const Enumeration& enumeration : program_.enumerations)
      if (&enumeration == &member && !enumeration.doc.empty()) comment(enumeration.doc);
    const auto symbol = symbols_.find(member.name.text);
    if (symbol != symbols_.end() && symbol->second == &member) return this->symbol(*symbol->second);
    for (const Constant& constant : program_.constants)
      if (&constant == &member) this->constant(constant);
  }

  void symbol(const Symbol& symbol) {
    Attributes attributes = named(symbol);
    if (!symbol.range.empty())
      reporter_.warning(symbol.name.location, "XABSL 2.1 has no ranges of symbols; that of " +
                                                  quoted(symbol.name.text) + " is left out");
    const bool input = symbol.kind == SymbolKind::input;
    if (symbol.kind == SymbolKind::internal)
      return cannot(symbol.name.location, "an internal symbol");
    if (symbol.type.kind == ValueKind::enumeration) {
      if (!symbol.parameters.empty())
        return cannot(symbol.name.location, "an enumerated symbol with parameters");
      return enumeratedSymbol(symbol, input, attributes);
    }
    if (!input) return cannot(symbol.name.location, "an output symbol that is not enumerated");
    if (symbol.type.kind == ValueKind::boolean) {
      if (!symbol.parameters.empty())
        return cannot(symbol.name.location, "a boolean symbol with parameters");
      return empty("boolean-input-symbol", attributes);
    }
    attributes.push_back({"measure", std::string(symbol.unit)});
    if (symbol.parameters.empty()) return empty("decimal-input-symbol", attributes);
    open("decimal-input-function", attributes);
    parameters(symbol.name.text, symbol.parameters);
    close("decimal-input-function");
  }

  /// Elements bear the name of their enumeration, if it is not that of the symbol: so symbols of
  /// one type are of one type again.
  void enumeratedSymbol(const Symbol& symbol, bool input, const Attributes& attributes) {
    const char* kind = input ? "enumerated-input-symbol" : "enumerated-output-symbol";
    const auto enumeration = enumerations_.find(symbol.type.enumeration.text);
    if (enumeration == enumerations_.end()) return;  // an error of the program
    used_.insert(enumeration->first);
    if (enumeration->second->internal)
      cannot(enumeration->second->name.location, "an internal enumeration");
    open(kind, attributes);
    for (const Name& element : enumeration->second->elements)
      empty("enum-element", {{"name", elementName(symbol, *enumeration->second, element.text)}});
    close(kind);
  }

  static std::string elementName(const Symbol& symbol, const Enumeration& enumeration,
                                 std::string_view element) {
    if (symbol.name.text != enumeration.name.text) return qualified(enumeration, element);
    for (const Name& candidate : enumeration.elements)
      if (qualified(enumeration, candidate.text) == qualified(enumeration, element))
        return std::string(candidate.text);
    return std::string(element);
  }

  static std::string qualified(const Enumeration& enumeration, std::string_view element) {
    const std::string prefix = std::string(enumeration.name.text) + ".";
    return element.substr(0, prefix.size()) == prefix ? std::string(element)
                                                      : prefix + std::string(element);
  }

  void constant(const Constant& constant) {
    Attributes attributes = named(constant);
    attributes.push_back({"measure", std::string(constant.unit)});
    attributes.push_back({"value", (constant.negative ? "-" : "") + digits(constant.digits)});
    empty("constant", attributes);
  }

  /// The schema knows no exponents.
  static std::string digits(std::string_view text) {
    if (text.find_first_of("eE") == std::string_view::npos) return std::string(text);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    std::array<char, 800> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
            .ptr;
    return {buffer.data(), end};
  }

  void prototype(const char* element, const Declaration& declaration,
                 const std::vector<Parameter>& sources) {
    if (sources.empty()) return empty(element, named(declaration));
    open(element, named(declaration));
    parameters(declaration.name.text, sources);
    close(element);
  }

  void parameters(std::string_view owner, const std::vector<Parameter>& sources) {
    for (const Parameter& parameter : sources) {
      if (parameter.type.kind != ValueKind::number)
        cannot(parameter.name.location, "a parameter that is not decimal");
      comments(parameter.extent.begin);
      empty("parameter", {{"name", std::string(owner) + "." + std::string(parameter.name.text)},
                          {"measure", std::string(parameter.unit)},
                          {"range", std::string(parameter.range)},
                          {"description", std::string(parameter.doc)}});
    }
  }

  static Attributes named(const Declaration& declaration) {
    return {{"name", std::string(declaration.name.text)},
            {"description", std::string(declaration.doc)}};
  }

  void writeDefinitions() {
    open("option-definitions", rootAttributes("option-definitions"));
    for (const Option& option : program_.options)
      prototype("option-definition", option, option.parameters);
    close("option-definitions");
    finish("options.xml");
  }

  void writeRoot(const std::string& root) {
    Attributes attributes = rootAttributes("agent-collection");
    attributes.push_back({"xmlns:xi", "http://www.w3.org/2001/XInclude"});
    open("agent-collection", attributes);
    const Header& header = program_.header;
    line("<title>" + escaped(header.title) + "</title>");
    line("<platform>" + escaped(header.platform) + "</platform>");
    line("<software-environment>" + escaped(header.softwareEnvironment) +
         "</software-environment>");
    for (const Agent& agent : program_.agents) {
      comments(agent.extent.begin);
      empty("agent", {{"id", std::string(agent.name.text)},
                      {"title", std::string(agent.title)},
                      {"description", std::string(agent.doc)},
                      {"root-option", std::string(agent.rootOption.text)}});
    }
    line("&options;");
    open("options", {});
    for (const std::string& path : paths_) line("<xi:include href=\"" + escaped(path) + "\"/>");
    close("options");
    for (const std::string& rest : comments_.rest()) comment(rest);
    close("agent-collection");
    finish(root, "<!DOCTYPE agent-collection [\n  <!ENTITY options SYSTEM \"options.xml\">\n]>\n");
  }

  // --- Options

  void writeOption(const Option& option) {
    std::string folder = folderOf(program_, option.extent.begin);
    if (folder.empty()) folder = "Options/";
    const std::string path = newPath(folder, option.name.text);
    paths_.push_back(path);
    comments(option.extent.begin);
    option_ = &option;
    Attributes attributes = rootAttributes("option");
    attributes.push_back({"name", std::string(option.name.text)});
    for (const State& state : option.states)
      if (state.initial) attributes.push_back({"initial-state", std::string(state.name.text)});
    open("option", attributes);
    std::string doctype = "<!DOCTYPE option [\n";
    const auto include = [&](const std::string& entity, const std::string& file) {
      line("&" + entity + ";");
      doctype +=
          "  <!ENTITY " + entity + " SYSTEM \"" + escaped(fromFolder(file, folder)) + "\">\n";
    };
    for (const bool behaviors : {false, true})
      for (const Included& included : included_)
        if (included.behaviors == behaviors) include(included.entity, included.path);
    include("options", "options.xml");
    if (option.commonDecision) {
      open("common-decision-tree", {});
      statement(*option.commonDecision, nullptr);
      close("common-decision-tree");
    }
    for (const State& state : option.states) this->state(state);
    close("option");
    finish(path, doctype + "]>\n");
  }

  void state(const State& state) {
    comments(state.extent.begin);
    if (!state.doc.empty()) comment(state.doc);
    if (state.cooperation.kind != Cooperation::Kind::none)
      cannot(state.name.location, "a state in which robots cooperate");
    Attributes attributes = {{"name", std::string(state.name.text)}};
    if (state.target) attributes.push_back({"is-target-state", "true"});
    open("state", attributes);
    actions(state);
    open("decision-tree", {});
    if (state.decision)
      statement(*state.decision, &state);
    else
      transition(state.name.text);
    close("decision-tree");
    close("state");
  }

  /// One option or basic behavior; output symbols are set before it, as if the state had been asked
  /// first (F.6). Actions common to all states stand in each of them.
  void actions(const State& state) {
    std::vector<const Action*> all;
    for (const Action& action : option_->commonActions) all.push_back(&action);
    for (const Action& action : state.actions) all.push_back(&action);
    const Action* called = nullptr;
    for (const Action* each : all) {
      const Action& action = *each;
      if (action.kind == Action::Kind::assignment) {
        if (called && options_.count(called->name.text) > 0)
          cannot(action.name.location, "an output symbol set after an option is called");
        continue;
      }
      if (called) cannot(action.name.location, "a second option or basic behavior in a state");
      called = &action;
    }
    if (!called) return cannot(state.name.location, "a state without option or basic behavior");
    subsequent(*called);
    for (const Action* action : all)
      if (action->kind == Action::Kind::assignment) assignment(*action);
  }

  void subsequent(const Action& action) {
    comments(action.extent.begin);
    const bool option = action.kind == Action::Kind::callOption ||
                        (action.kind == Action::Kind::call && options_.count(action.name.text) > 0);
    values(option ? "subsequent-option" : "subsequent-basic-behavior", "set-parameter",
           action.name.text, action.arguments);
  }

  void values(const char* element, const char* inner, std::string_view ref,
              const std::vector<Argument>& arguments) {
    const Attributes reference = {{"ref", std::string(ref)}};
    if (arguments.empty()) return empty(element, reference);
    open(element, reference);
    for (const Argument& argument : arguments) {
      const std::string prefix = std::string(ref) + ".";
      const std::string_view name = argument.name.text;
      const bool whole = name.substr(0, prefix.size()) == prefix;
      open(inner, {{"ref", (whole ? "" : prefix) + std::string(name)}});
      expression(*argument.value);
      close(inner);
    }
    close(element);
  }

  void assignment(const Action& action) {
    comments(action.extent.begin);
    const auto symbol = symbols_.find(action.name.text);
    const Enumeration* enumeration =
        symbol == symbols_.end() ? nullptr : enumerationOf(*symbol->second);
    if (!enumeration) return;  // the symbol is told already
    if (!isElement(*enumeration, *action.value))
      return cannot(action.value->location, "a value that is not an element of its symbol");
    empty("set-output-symbol",
          {{"ref", std::string(action.name.text)},
           {"value", elementName(*symbol->second, *enumeration, action.value->name)}});
  }

  const Enumeration* enumerationOf(const Symbol& symbol) const {
    if (symbol.type.kind != ValueKind::enumeration) return nullptr;
    const auto found = enumerations_.find(symbol.type.enumeration.text);
    return found == enumerations_.end() ? nullptr : found->second;
  }

  static bool isElement(const Enumeration& enumeration, const Expression& value) {
    return value.kind == Expression::Kind::name &&
           std::any_of(
               enumeration.elements.begin(), enumeration.elements.end(), [&](const Name& element) {
                 return qualified(enumeration, element.text) == qualified(enumeration, value.name);
               });
  }

  void statement(const Decision& decision, const State* state) {
    comments(decision.extent.begin);
    if (decision.kind == Decision::Kind::stay && !state)
      return cannot(decision.extent.begin, "'stay' in a decision tree common to all states");
    if (decision.kind == Decision::Kind::stay) return transition(state->name.text);
    if (decision.kind == Decision::Kind::go) return transition(decision.target.text);
    const char* element = "if";
    for (const Arm& arm : decision.arms) {
      open(element, {});
      open("condition", {{"description", std::string(arm.doc)}});
      expression(*arm.condition);
      close("condition");
      statement(*arm.decision, state);
      close(element);
      element = "else-if";
    }
    if (!decision.otherwise) return;
    open("else", {});
    statement(*decision.otherwise, state);
    close("else");
  }

  void transition(std::string_view state) {
    empty("transition-to-state", {{"ref", std::string(state)}});
  }

  // --- Expressions

  void expression(const Expression& expression) {
    using Kind = Expression::Kind;
    switch (expression.kind) {
      case Kind::number:
        return empty("decimal-value", {{"value", digits(expression.name)}});
      case Kind::parameter: {
        const std::string owner(option_->name.text);
        return empty("option-parameter-ref", {{"ref", owner + "." + std::string(expression.name)}});
      }
      case Kind::stateTime:
        return empty("time-of-state-execution", {});
      case Kind::optionTime:
        return empty("time-of-option-execution", {});
      case Kind::actionDone:
        return empty("subsequent-option-reached-target-state", {});
      case Kind::boolean:
        return cannot(expression.location, "'true' and 'false' in an expression");
      case Kind::conflict:
        return cannot(expression.location, "'conflict'");
      case Kind::operation:
        return operation(expression);
      default:
        return reference(expression);
    }
  }

  void reference(const Expression& expression) {
    const Attributes ref = {{"ref", std::string(expression.name)}};
    const auto found = symbols_.find(expression.name);
    if (constants_.count(expression.name) > 0) return empty("constant-ref", ref);
    if (found == symbols_.end())
      return cannot(expression.location, quoted(expression.name) + " in an expression");
    const Symbol& symbol = *found->second;
    if (symbol.kind != SymbolKind::input)
      return cannot(expression.location, "an output symbol that is read");
    if (symbol.type.kind == ValueKind::boolean) return empty("boolean-input-symbol-ref", ref);
    if (symbol.type.kind == ValueKind::enumeration)
      return cannot(expression.location,
                    "an enumerated symbol that is not compared with an element");
    if (symbol.parameters.empty()) return empty("decimal-input-symbol-ref", ref);
    values("decimal-input-function-call", "with-parameter", expression.name, expression.arguments);
  }

  void operation(const Expression& expression) {
    const std::string name(elementOf(expression.operation));
    if (expression.operation == Operator::negate) return negation(expression);
    if (expression.operation == Operator::conditional) return conditional(expression);
    if (comparison(expression)) return;
    open(name, {});
    for (const ExpressionPtr& operand : expression.operands) this->expression(*operand);
    close(name);
  }

  void negation(const Expression& expression) {
    const Expression& operand = *expression.operands.front();
    if (operand.kind == Expression::Kind::number)
      return empty("decimal-value", {{"value", "-" + digits(operand.name)}});
    open("minus", {});
    empty("decimal-value", {{"value", "0"}});
    this->expression(operand);
    close("minus");
  }

  void conditional(const Expression& expression) {
    open("conditional-expression", {});
    constexpr const char* names[] = {"condition", "expression1", "expression2"};
    for (std::size_t i = 0; i < 3; ++i) {
      open(names[i], {});
      this->expression(*expression.operands[i]);
      close(names[i]);
    }
    close("conditional-expression");
  }

  /// An enumerated symbol compared with one of its elements.
  bool comparison(const Expression& expression) {
    const bool equal = expression.operation == Operator::equal;
    if (!equal && expression.operation != Operator::notEqual) return false;
    const auto symbol = symbols_.find(expression.operands[0]->name);
    if (expression.operands[0]->kind != Expression::Kind::name || symbol == symbols_.end())
      return false;
    const Enumeration* enumeration = enumerationOf(*symbol->second);
    if (!enumeration || symbol->second->kind != SymbolKind::input ||
        !isElement(*enumeration, *expression.operands[1]))
      return false;
    if (!equal) open("not", {});
    empty("enumerated-input-symbol-comparison",
          {{"ref", std::string(symbol->first)},
           {"value", elementName(*symbol->second, *enumeration, expression.operands[1]->name)}});
    if (!equal) close("not");
    return true;
  }

  // --- Lines

  void line(const std::string& text) { text_ += std::string(2 * depth_, ' ') + text + "\n"; }

  void comments(Location place) {
    for (const std::string& text : comments_.before(place)) comment(text);
  }

  /// Two hyphens end a comment of XML.
  void comment(std::string_view source) {
    std::string text(source);
    for (std::size_t i = text.find("--"); i != std::string::npos; i = text.find("--"))
      text.replace(i, 2, "- -");
    if (!text.empty() && text.back() == '-') text += ' ';
    line("<!-- " + text + " -->");
  }

  static std::string tag(std::string_view element, const Attributes& attributes) {
    std::string text = "<" + std::string(element);
    for (const auto& [key, value] : attributes)
      text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
    return text;
  }

  void open(std::string_view element, const Attributes& attributes) {
    line(tag(element, attributes) + ">");
    ++depth_;
  }

  void close(std::string_view element) {
    --depth_;
    line("</" + std::string(element) + ">");
  }

  void empty(std::string_view element, const Attributes& attributes) {
    line(tag(element, attributes) + "/>");
  }

  const Program& program_;
  Reporter& reporter_;
  LooseComments comments_;
  std::map<std::string_view, const Symbol*> symbols_;
  std::map<std::string_view, const Enumeration*> enumerations_;
  std::set<std::string_view> constants_;
  std::set<std::string_view> options_;
  std::set<std::string_view> used_;  // enumerations of symbols
  VirtualFiles files_;
  std::vector<Included> included_;
  std::vector<std::string> paths_;  // of the options
  const Option* option_ = nullptr;
  std::string text_;  // of the present file
  std::size_t depth_ = 0;
};

}  // namespace

VirtualFiles writeXml(const Program& program, const std::string& root, Reporter& reporter) {
  return XmlWriter(program, reporter).write(root);
}

}  // namespace xabsl
