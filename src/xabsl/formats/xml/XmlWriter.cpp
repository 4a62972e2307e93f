#include <algorithm>
#include <filesystem>
#include <map>

#include "xabsl/formats/text/SourceWriter.h"
#include "xabsl/formats/xml/XmlExpressionWriter.h"
#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/ModelText.h"

namespace xabsl {

using xml::Attributes;
using xml::escaped;

namespace {

constexpr const char* optionsFile = "options.xml";
constexpr const char* optionsEntity = "options";
constexpr const char* doctypeFile = "symbol-and-basic-behavior-files.dtd";

Attributes named(const syntax::Declaration& declaration) {
  return {{"name", std::string(declaration.name.text)},
          {"description", std::string(declaration.doc)}};
}

std::string entityDeclaration(const std::string& name, const std::string& path) {
  return "<!ENTITY " + name + " SYSTEM \"" + escaped(path) + "\">\n";
}

/// The declaration of the file with the definitions of all options.
std::string optionsDeclaration() {
  return entityDeclaration(optionsEntity, optionsFile);
}

bool stays(const syntax::Decision& decision) {
  return decision.kind == syntax::Decision::Kind::stay ||
         std::any_of(decision.arms.begin(), decision.arms.end(),
                     [](const syntax::Arm& arm) { return stays(*arm.decision); }) ||
         (decision.otherwise && stays(*decision.otherwise));
}

/// Writes the files of a behavior: declarations, options, states, decisions and actions.
class XmlWriter : XmlExpressionWriter {
 public:
  XmlWriter(const syntax::Program& program, const Model& model, Dialect dialect, Reporter& reporter)
      : XmlExpressionWriter(program, model, dialect, reporter),
        space_(xml::namespaceOf(dialect)),
        comments_(program) {}

  VirtualFiles write(const std::string& root) {
    files_[root];
    files_[optionsFile];
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    if (old_) finishCollections();
    for (const syntax::Option& option : program_.options) writeOption(option);
    if (!old_) writeDoctype();
    writeDefinitions();
    writeRoot(root);
    return std::move(files_);
  }

 private:
  /// What an option's file may include.
  struct Included {
    std::string entity;
    std::string path;
    std::string_view space;
    bool behaviors;
  };

  void comments(Location place) {
    for (const std::string& text : comments_.before(place)) out_.comment(text);
  }

  void comments(const syntax::Extent& extent, const syntax::Name& name) {
    comments(old_ ? extent.begin : name.location);
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

  /// What the root element of each file has, and its own attributes.
  Attributes rootAttributes(std::string_view kind, const Attributes& own = {}) const {
    Attributes attributes = {{"xmlns", space_},
                             {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}};
    if (old_)
      attributes.push_back(
          {"xsi:schemaLocation", space_ + " xabsl-2.1." + std::string(kind) + ".xsd"});
    attributes.insert(attributes.end(), own.begin(), own.end());
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
    out_.open(kind, rootAttributes(kind, {{"id", std::string(space.name.text)},
                                          {"title", std::string(space.title)},
                                          {"description", std::string(space.doc)}}));
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

  /// 2.1 declares an enumeration with each symbol, and includes basic behaviors behind symbols.
  void finishCollections() {
    for (const syntax::Enumeration& enumeration : program_.enumerations)
      if (declared_.count(&enumeration) == 0)
        refuse(enumeration.name.location, "an enumeration without a symbol of its type");
    std::stable_partition(included_.begin(), included_.end(),
                          [](const Included& included) { return !included.behaviors; });
  }

  void writeDoctype() {
    std::string text;
    for (const Included& included : included_)
      text += entityDeclaration(included.entity, included.path);
    finish(doctypeFile, "", text + optionsDeclaration());
  }

  void writeDefinitions() {
    out_.open("option-definitions", rootAttributes("option-definitions"));
    for (const syntax::Option& option : program_.options)
      function("option-definition", named(option), option.name.text, option.parameters);
    out_.close("option-definitions");
    finish(optionsFile, "", out_.take());
  }

  void writeRoot(const std::string& root) {
    const char* xinclude =
        old_ ? "http://www.w3.org/2001/XInclude" : "http://www.w3.org/2003/XInclude";
    out_.open("agent-collection", rootAttributes("agent-collection", {{"xmlns:xi", xinclude}}));
    const syntax::Header& header = program_.header;
    out_.line("<title>" + escaped(header.title) + "</title>");
    out_.line("<platform>" + escaped(header.platform) + "</platform>");
    out_.line("<software-environment>" + escaped(header.softwareEnvironment) +
              "</software-environment>");
    for (const syntax::Agent& agent : program_.agents) {
      comments(agent.extent, agent.name);
      out_.empty("agent", {{"id", std::string(agent.name.text)},
                           {"title", std::string(agent.title)},
                           {"description", std::string(agent.doc)},
                           {"root-option", std::string(agent.rootOption.text)}});
    }
    out_.line("&options;");
    out_.open("options");
    for (const std::string& path : paths_) out_.empty("xi:include", {{"href", path}});
    out_.close("options");
    for (const std::string& rest : comments_.rest()) out_.comment(rest);
    out_.close("agent-collection");
    const std::string doctype =
        old_ ? "<!DOCTYPE agent-collection [\n  " : "<!DOCTYPE options [\n    ";
    finish(root, doctype + optionsDeclaration() + "]>\n", out_.take());
  }

  // --- Declarations

  void declare(const syntax::Enumeration& enumeration) {
    if (old_) {  // which declares it with each symbol
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
    const std::string sign = constant.negative ? "-" : "", unit(constant.unit);
    if (!old_)
      return out_.empty("constant", {{"name", std::string(constant.name.text)},
                                     {"value", sign + std::string(constant.digits)},
                                     {"measure", unit},
                                     {"description", std::string(constant.doc)}});
    out_.empty("constant", {{"name", std::string(constant.name.text)},
                            {"description", std::string(constant.doc)},
                            {"measure", unit},
                            {"value", sign + withoutExponent(constant.digits)}});
  }

  void declare(const syntax::Symbol& symbol) {
    if (old_) return declareOld(symbol);
    Attributes attributes = typed(symbol, std::string(symbol.name.text));
    if (symbol.kind == SymbolKind::internal) attributes.push_back({"internal", "true"});
    const bool input = symbol.kind == SymbolKind::input;
    function(kindOf(symbol.type.kind) + (input ? "-input-symbol" : "-output-symbol"), attributes,
             symbol.name.text, symbol.parameters);
  }

  /// What a symbol or a parameter of 3.1 has.
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
    declared_.insert(&*found);
    if (found->internal) refuse(found->name.location, "an internal enumeration");
    out_.open(element, named(symbol));
    for (const syntax::Name& name : found->elements)
      out_.empty("enum-element", {{"name", elementName(symbol.name.text, *found, name.text)}});
    out_.close(element);
  }

  void declare(const syntax::Behavior& behavior) {
    function("basic-behavior", named(behavior), behavior.name.text, behavior.parameters);
  }

  void function(const std::string& element, const Attributes& attributes, std::string_view owner,
                const std::vector<syntax::Parameter>& parameters) {
    if (parameters.empty()) return out_.empty(element, attributes);
    out_.open(element, attributes);
    for (const syntax::Parameter& each : parameters)
      parameter(each, std::string(owner) + "." + std::string(each.name.text));
    out_.close(element);
  }

  void parameter(const syntax::Parameter& parameter, const std::string& name) {
    if (old_ && parameter.type.kind != ValueKind::number)
      refuse(parameter.name.location, "a parameter that is not decimal");
    comments(parameter.extent, parameter.name);
    if (!old_)
      return out_.empty(kindOf(parameter.type.kind) + "-parameter", typed(parameter, name));
    out_.empty("parameter", {{"name", name},
                             {"measure", std::string(parameter.unit)},
                             {"range", std::string(parameter.range)},
                             {"description", std::string(parameter.doc)}});
  }

  // --- Options

  void writeOption(const syntax::Option& option) {
    std::string folder = old_ ? folderOf(program_, option.extent.begin) : "";
    if (folder.empty()) folder = "Options/";
    const std::string path = newPath(folder, option.name.text);
    paths_.push_back(path);
    used_.clear();
    comments(option.extent, option.name);
    const auto initial = std::find_if(option.states.begin(), option.states.end(),
                                      [](const syntax::State& state) { return state.initial; });
    out_.open("option",
              rootAttributes("option", {{"name", std::string(option.name.text)},
                                        {"initial-state", std::string(initial->name.text)}}));
    const std::string head = out_.take();
    // In 3.1, only a state's own decision tree can express that it stays: then each has the whole.
    const bool copied = !old_ && option.commonDecision && stays(*option.commonDecision);
    state_ = nullptr;
    if (option.commonDecision && !copied) {
      out_.open("common-decision-tree");
      decision(option.commonDecision.get());
      out_.close("common-decision-tree");
    }
    if (!old_ && !option.commonActions.empty()) {
      out_.open("common-action");
      for (const syntax::Action& each : option.commonActions) action(each);
      out_.close("common-action");
    }
    for (const syntax::State& state : option.states) writeState(option, state, copied);
    out_.close("option");
    const std::string body = out_.take();
    const auto [entities, references] = inclusions(folder);
    const std::string doctype =
        old_ ? "option [\n" + entities + "]"
             : std::string("symbol-and-basic-behavior-files SYSTEM \"../") + doctypeFile + "\"";
    finish(path, "<!DOCTYPE " + doctype + ">\n", head + references + body);
  }

  /// The entities that an option's file includes, in 2.1 all: their declarations, and the
  /// references to them.
  std::pair<std::string, std::string> inclusions(const std::string& folder) const {
    std::string declarations, references;
    const auto include = [&](const std::string& entity, const std::filesystem::path& path) {
      references += "  &" + entity + ";\n";
      declarations +=
          "  " + entityDeclaration(entity, path.lexically_relative(folder).generic_string());
    };
    for (const Included& included : included_)
      if (old_ || used_.count({included.space, included.behaviors}) > 0)
        include(included.entity, included.path);
    include(optionsEntity, optionsFile);
    return {declarations, references};
  }

  void writeState(const syntax::Option& option, const syntax::State& state, bool copied) {
    state_ = &state;
    comments(state.extent, state.name);
    if (!state.doc.empty()) out_.comment(state.doc);
    Attributes attributes = {{"name", std::string(state.name.text)}};
    if (state.target) attributes.push_back({"is-target-state", "true"});
    const Cooperation::Kind kind = state.cooperation.kind;
    if (kind != Cooperation::Kind::none)
      attributes.push_back({kind == Cooperation::Kind::capacity ? "capacity" : "synchronized",
                            std::to_string(state.cooperation.agents)});
    out_.open("state", attributes);
    if (old_)
      oldActions(option);
    else
      for (const syntax::Action& each : state.actions) action(each);
    out_.open("decision-tree");
    decision((copied ? option.commonDecision : state.decision).get(), copied);
    out_.close("decision-tree");
    out_.close("state");
  }

  const Action& resolved(const syntax::Action& source) const {
    return model_.actions[at(source.resolved)];
  }
  using XmlExpressionWriter::resolved;

  /// One option or basic behavior; output symbols are set before it, as if the state had been asked
  /// first (F.6). Actions common to all states stand in each of them.
  void oldActions(const syntax::Option& option) {
    if (state_->cooperation.kind != Cooperation::Kind::none)
      refuse(state_->name.location, "a state in which robots cooperate");
    const syntax::Action* called = nullptr;
    std::vector<const syntax::Action*> assignments;
    for (const auto* actions : {&option.commonActions, &state_->actions})
      for (const syntax::Action& action : *actions) {
        const bool assignment = action.kind == syntax::Action::Kind::assignment;
        if (!assignment && called)
          refuse(action.name.location, "a second option or basic behavior in a state");
        if (assignment && called && resolved(*called).kind == Action::Kind::option)
          refuse(action.name.location, "an output symbol set after an option is called");
        if (assignment)
          assignments.push_back(&action);
        else
          called = &action;
      }
    if (!called) return refuse(state_->name.location, "a state without option or basic behavior");
    action(*called);
    for (const syntax::Action* assignment : assignments) action(*assignment);
  }

  void action(const syntax::Action& action) {
    comments(action.extent, action.name);
    const Action& resolved = this->resolved(action);
    if (resolved.kind == Action::Kind::assignment) return assignment(action);
    const bool option = resolved.kind == Action::Kind::option;
    if (!option) use(model_.behaviors[at(resolved.target)].space, true);
    call(option ? "subsequent-option" : "subsequent-basic-behavior", "set-parameter",
         action.name.text, parametersOf(model_, resolved), action.arguments);
  }

  void assignment(const syntax::Action& action) {
    const Symbol& symbol = model_.symbols[at(resolved(action).target)];
    if (old_) return setOutputSymbol(symbol, *action.value);
    use(symbol.space, false);
    const std::string element = "set-" + kindOf(symbol.type.kind) + "-output-symbol";
    out_.open(element, {{"ref", symbol.name}});
    expression(*action.value);
    out_.close(element);
  }

  void setOutputSymbol(const Symbol& symbol, const syntax::Expression& value) {
    if (symbol.type.kind != ValueKind::enumeration) return;  // its declaration is refused
    if (resolved(value).operation != Operator::element)
      return refuse(value.location, "a value that is not an element of its symbol");
    out_.empty("set-output-symbol",
               {{"ref", symbol.name}, {"value", elementName(symbol.name, resolved(value))}});
  }

  /// Null: the state stays. What decides nothing may continue with the decision of the state.
  void decision(const syntax::Decision* tree, bool continues = false) {
    using Kind = syntax::Decision::Kind;
    if (old_ && tree) {
      comments(tree->extent.begin);
      if (tree->kind == Kind::stay && !state_)
        return refuse(tree->extent.begin, "'stay' in a decision tree common to all states");
    }
    if (tree && tree->kind == Kind::choose) return choice(*tree, continues);
    const bool go = tree && tree->kind == Kind::go;
    out_.empty("transition-to-state",
               {{"ref", std::string(go ? tree->target.text : state_->name.text)}});
  }

  void choice(const syntax::Decision& tree, bool continues) {
    std::size_t open = 0;
    for (const syntax::Arm& arm : tree.arms) {
      const bool first = &arm == &tree.arms.front();
      const char* element = old_ && !first ? "else-if" : "if";
      if (!old_ && !first) {
        out_.open("else");
        ++open;
      }
      out_.open(element);
      out_.open("condition", {{"description", std::string(arm.doc)}});
      expression(*arm.condition);
      out_.close("condition");
      decision(arm.decision.get());
      out_.close(element);
    }
    if (tree.otherwise || continues) {
      out_.open("else");
      decision((tree.otherwise ? tree.otherwise : state_->decision).get());
      out_.close("else");
    }
    for (; open > 0; --open) out_.close("else");
  }

  const std::string space_;  // of the elements
  LooseComments comments_;
  VirtualFiles files_;
  std::vector<std::string> paths_;  // of the options
  std::vector<Included> included_;
  std::set<const syntax::Enumeration*> declared_;  // of 2.1: with a symbol
  const syntax::State* state_ = nullptr;  // the present one; none in what is common to all states
};

}  // namespace

VirtualFiles writeXml(const syntax::Program& program, const Model& model, Dialect dialect,
                      const std::string& root, Reporter& reporter) {
  return XmlWriter(program, model, dialect, reporter).write(root);
}

}  // namespace xabsl
