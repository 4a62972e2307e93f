#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "xabsl/formats/SourceWriter.h"
#include "xabsl/formats/XmlExpressionWriter.h"
#include "xabsl/formats/XmlOutput.h"
#include "xabsl/formats/XmlTree.h"

namespace xabsl {

using namespace syntax;
using xml::Attributes;
using xml::escaped;
using xml::XmlOutput;

namespace {

class XmlWriter {
 public:
  XmlWriter(const Program& program, Reporter& reporter)
      : program_(program),
        reporter_(reporter),
        comments_(program),
        expressions_(program, reporter, out_) {}

  VirtualFiles write(const std::string& root) {
    files_[root];
    files_["options.xml"];
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    for (const Enumeration& enumeration : program_.enumerations)
      if (used_.count(enumeration.name.text) == 0)
        expressions_.cannot(enumeration.name.location,
                            "an enumeration without a symbol of its type");
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

  // --- Files

  /// A path that no other file has.
  std::string newPath(const std::string& folder, std::string_view name) {
    std::string path = folder + std::string(name) + ".xml";
    for (int i = 2; !files_.emplace(path, "").second; ++i)
      path = folder + std::string(name) + "-" + std::to_string(i) + ".xml";
    return path;
  }

  void finish(const std::string& path, const std::string& doctype = {}) {
    files_[path] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + doctype + out_.take();
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
    out_.open(kind, attributes);
    for (const Declaration* member : collection.members) this->member(collection, *member);
    out_.close(kind);
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
      if (&enumeration == &member && !enumeration.doc.empty()) out_.comment(enumeration.doc);
    for (const Symbol& symbol : program_.symbols)
      if (&symbol == &member) return this->symbol(symbol);
    for (const Constant& constant : program_.constants)
      if (&constant == &member) this->constant(constant);
  }

  void symbol(const Symbol& symbol) {
    Attributes attributes = named(symbol);
    if (!symbol.range.empty())
      reporter_.warning(symbol.name.location, "XABSL 2.1 has no ranges of symbols; that of " +
                                                  inQuotes(symbol.name.text) + " is left out");
    const bool input = symbol.kind == SymbolKind::input;
    if (symbol.kind == SymbolKind::internal)
      return expressions_.cannot(symbol.name.location, "an internal symbol");
    if (symbol.type.kind == ValueKind::enumeration) {
      if (!symbol.parameters.empty())
        return expressions_.cannot(symbol.name.location, "an enumerated symbol with parameters");
      return enumeratedSymbol(symbol, input, attributes);
    }
    if (!input)
      return expressions_.cannot(symbol.name.location, "an output symbol that is not enumerated");
    if (symbol.type.kind == ValueKind::boolean) {
      if (!symbol.parameters.empty())
        return expressions_.cannot(symbol.name.location, "a boolean symbol with parameters");
      return out_.empty("boolean-input-symbol", attributes);
    }
    attributes.push_back({"measure", std::string(symbol.unit)});
    if (symbol.parameters.empty()) return out_.empty("decimal-input-symbol", attributes);
    out_.open("decimal-input-function", attributes);
    parameters(symbol.name.text, symbol.parameters);
    out_.close("decimal-input-function");
  }

  void enumeratedSymbol(const Symbol& symbol, bool input, const Attributes& attributes) {
    const char* kind = input ? "enumerated-input-symbol" : "enumerated-output-symbol";
    const Enumeration* const enumeration = expressions_.enumerationOf(symbol);
    if (!enumeration) return;  // an error of the program
    used_.insert(enumeration->name.text);
    if (enumeration->internal)
      expressions_.cannot(enumeration->name.location, "an internal enumeration");
    out_.open(kind, attributes);
    for (const Name& element : enumeration->elements)
      out_.empty("enum-element",
                 {{"name", XmlExpressionWriter::elementName(symbol, *enumeration, element.text)}});
    out_.close(kind);
  }

  void constant(const Constant& constant) {
    Attributes attributes = named(constant);
    attributes.push_back({"measure", std::string(constant.unit)});
    attributes.push_back(
        {"value", (constant.negative ? "-" : "") + XmlExpressionWriter::digits(constant.digits)});
    out_.empty("constant", attributes);
  }

  void prototype(const char* element, const Declaration& declaration,
                 const std::vector<Parameter>& sources) {
    if (sources.empty()) return out_.empty(element, named(declaration));
    out_.open(element, named(declaration));
    parameters(declaration.name.text, sources);
    out_.close(element);
  }

  void parameters(std::string_view owner, const std::vector<Parameter>& sources) {
    for (const Parameter& parameter : sources) {
      if (parameter.type.kind != ValueKind::number)
        expressions_.cannot(parameter.name.location, "a parameter that is not decimal");
      comments(parameter.extent.begin);
      out_.empty("parameter",
                 {{"name", std::string(owner) + "." + std::string(parameter.name.text)},
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
    out_.open("option-definitions", rootAttributes("option-definitions"));
    for (const Option& option : program_.options)
      prototype("option-definition", option, option.parameters);
    out_.close("option-definitions");
    finish("options.xml");
  }

  void writeRoot(const std::string& root) {
    Attributes attributes = rootAttributes("agent-collection");
    attributes.push_back({"xmlns:xi", "http://www.w3.org/2001/XInclude"});
    out_.open("agent-collection", attributes);
    const Header& header = program_.header;
    out_.line("<title>" + escaped(header.title) + "</title>");
    out_.line("<platform>" + escaped(header.platform) + "</platform>");
    out_.line("<software-environment>" + escaped(header.softwareEnvironment) +
              "</software-environment>");
    for (const Agent& agent : program_.agents) {
      comments(agent.extent.begin);
      out_.empty("agent", {{"id", std::string(agent.name.text)},
                           {"title", std::string(agent.title)},
                           {"description", std::string(agent.doc)},
                           {"root-option", std::string(agent.rootOption.text)}});
    }
    out_.line("&options;");
    out_.open("options", {});
    for (const std::string& path : paths_)
      out_.line("<xi:include href=\"" + escaped(path) + "\"/>");
    out_.close("options");
    for (const std::string& rest : comments_.rest()) out_.comment(rest);
    out_.close("agent-collection");
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
    expressions_.enter(option);
    Attributes attributes = rootAttributes("option");
    attributes.push_back({"name", std::string(option.name.text)});
    for (const State& state : option.states)
      if (state.initial) attributes.push_back({"initial-state", std::string(state.name.text)});
    out_.open("option", attributes);
    std::string doctype = "<!DOCTYPE option [\n";
    const auto include = [&](const std::string& entity, const std::string& file) {
      out_.line("&" + entity + ";");
      doctype +=
          "  <!ENTITY " + entity + " SYSTEM \"" + escaped(fromFolder(file, folder)) + "\">\n";
    };
    for (const bool behaviors : {false, true})
      for (const Included& included : included_)
        if (included.behaviors == behaviors) include(included.entity, included.path);
    include("options", "options.xml");
    if (option.commonDecision) {
      out_.open("common-decision-tree", {});
      statement(*option.commonDecision, nullptr);
      out_.close("common-decision-tree");
    }
    for (const State& state : option.states) this->state(state);
    out_.close("option");
    finish(path, doctype + "]>\n");
  }

  void state(const State& state) {
    comments(state.extent.begin);
    if (!state.doc.empty()) out_.comment(state.doc);
    if (state.cooperation.kind != Cooperation::Kind::none)
      expressions_.cannot(state.name.location, "a state in which robots cooperate");
    Attributes attributes = {{"name", std::string(state.name.text)}};
    if (state.target) attributes.push_back({"is-target-state", "true"});
    out_.open("state", attributes);
    actions(state);
    out_.open("decision-tree", {});
    if (state.decision)
      statement(*state.decision, &state);
    else
      transition(state.name.text);
    out_.close("decision-tree");
    out_.close("state");
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
        if (called && expressions_.isOption(called->name.text))
          expressions_.cannot(action.name.location,
                              "an output symbol set after an option is called");
        continue;
      }
      if (called)
        expressions_.cannot(action.name.location, "a second option or basic behavior in a state");
      called = &action;
    }
    if (!called)
      return expressions_.cannot(state.name.location, "a state without option or basic behavior");
    subsequent(*called);
    for (const Action* action : all)
      if (action->kind == Action::Kind::assignment) assignment(*action);
  }

  void subsequent(const Action& action) {
    comments(action.extent.begin);
    const bool option =
        action.kind == Action::Kind::callOption ||
        (action.kind == Action::Kind::call && expressions_.isOption(action.name.text));
    expressions_.writeValues(option ? "subsequent-option" : "subsequent-basic-behavior",
                             "set-parameter", action.name.text, action.arguments);
  }

  void assignment(const Action& action) {
    comments(action.extent.begin);
    const Symbol* const symbol = expressions_.output(action.name.text);
    const Enumeration* enumeration = symbol ? expressions_.enumerationOf(*symbol) : nullptr;
    if (!enumeration) return;  // the symbol is told already
    if (!XmlExpressionWriter::isElement(*enumeration, *action.value))
      return expressions_.cannot(action.value->location,
                                 "a value that is not an element of its symbol");
    out_.empty(
        "set-output-symbol",
        {{"ref", std::string(action.name.text)},
         {"value", XmlExpressionWriter::elementName(*symbol, *enumeration, action.value->name)}});
  }

  void statement(const Decision& decision, const State* state) {
    comments(decision.extent.begin);
    if (decision.kind == Decision::Kind::stay && !state)
      return expressions_.cannot(decision.extent.begin,
                                 "'stay' in a decision tree common to all states");
    if (decision.kind == Decision::Kind::stay) return transition(state->name.text);
    if (decision.kind == Decision::Kind::go) return transition(decision.target.text);
    const char* element = "if";
    for (const Arm& arm : decision.arms) {
      out_.open(element, {});
      out_.open("condition", {{"description", std::string(arm.doc)}});
      expressions_.write(*arm.condition);
      out_.close("condition");
      statement(*arm.decision, state);
      out_.close(element);
      element = "else-if";
    }
    if (!decision.otherwise) return;
    out_.open("else", {});
    statement(*decision.otherwise, state);
    out_.close("else");
  }

  void transition(std::string_view state) {
    out_.empty("transition-to-state", {{"ref", std::string(state)}});
  }

  void comments(Location place) {
    for (const std::string& text : comments_.before(place)) out_.comment(text);
  }

  const Program& program_;
  Reporter& reporter_;
  LooseComments comments_;
  XmlOutput out_;  // of the present file
  XmlExpressionWriter expressions_;
  std::set<std::string_view> used_;  // enumerations of symbols
  VirtualFiles files_;
  std::vector<Included> included_;
  std::vector<std::string> paths_;  // of the options
  const Option* option_ = nullptr;
};

}  // namespace

VirtualFiles writeXml(const Program& program, const std::string& root, Reporter& reporter) {
  return XmlWriter(program, reporter).write(root);
}

}  // namespace xabsl
