#include "xabsl/formats/XmlWriter.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "xabsl/formats/Lowering.h"
#include "xabsl/formats/XmlOperators.h"
#include "xabsl/language/ModelText.h"

namespace xabsl {

using xml::escaped;

namespace {

constexpr const char* optionsFile = "options.xml";
constexpr const char* optionsEntity = "options";

std::string_view elementOf(Operator operation) {
  return std::find_if(std::begin(xml::operators), std::end(xml::operators),
                      [&](const xml::OperatorElement& e) { return e.operation == operation; })
      ->name;
}

}  // namespace

XmlWriter::XmlWriter(const Style& style, const syntax::Program& program, const Model& model,
                     Reporter& reporter)
    : program_(program), model_(model), reporter_(reporter), style_(style), comments_(program) {}

VirtualFiles XmlWriter::write(const std::string& root) {
  files_[root];
  files_[optionsFile];
  for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
  writeOptions();
  writeDefinitions();
  writeRoot(root);
  return std::move(files_);
}

void XmlWriter::comments(Location place) {
  for (const std::string& text : comments_.before(place)) out_.comment(text);
}

void XmlWriter::comments(const syntax::Extent& extent, const syntax::Name& name) {
  comments(style_.commentsFirst ? extent.begin : name.location);
}

// --- Files

/// A path that no other file has.
std::string XmlWriter::newPath(const std::string& folder, std::string_view name) {
  std::string path = folder + std::string(name) + ".xml";
  for (int i = 2; !files_.emplace(path, "").second; ++i)
    path = folder + std::string(name) + "-" + std::to_string(i) + ".xml";
  return path;
}

void XmlWriter::finish(const std::string& path, const std::string& doctype,
                       const std::string& text) {
  files_[path] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + doctype + text;
}

/// What the root element of each file has.
XmlWriter::Attributes XmlWriter::rootAttributes(std::string_view schema) const {
  const std::string space{style_.space};
  Attributes attributes = {{"xmlns", space},
                           {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}};
  if (!style_.schemas.empty())
    attributes.push_back({"xsi:schemaLocation", space + " " + std::string(style_.schemas) +
                                                    std::string(schema) + ".xsd"});
  return attributes;
}

void XmlWriter::writeCollection(const Collection& collection) {
  const syntax::Namespace& space = *collection.space;
  const char* kind = collection.behaviors ? "basic-behaviors" : "symbols";
  const std::string folder = style_.keepsFolders    ? folderOf(program_, space.extent.begin)
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

void XmlWriter::writeDefinitions() {
  out_.open("option-definitions", rootAttributes("option-definitions"));
  for (const syntax::Option& option : program_.options)
    function("option-definition", named(option), option.name.text, option.parameters);
  out_.close("option-definitions");
  finish(optionsFile, "", out_.take());
}

std::string XmlWriter::entityDeclaration(const std::string& name, const std::string& path) {
  return "<!ENTITY " + name + " SYSTEM \"" + escaped(path) + "\">\n";
}

std::string XmlWriter::optionsDeclaration() {
  return entityDeclaration(optionsEntity, optionsFile);
}

void XmlWriter::writeRoot(const std::string& root) {
  Attributes attributes = rootAttributes("agent-collection");
  attributes.push_back({"xmlns:xi", std::string(style_.xincludeSpace)});
  out_.open("agent-collection", attributes);
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
  out_.open("options", {});
  for (const std::string& path : paths_) out_.empty("xi:include", {{"href", path}});
  out_.close("options");
  for (const std::string& rest : comments_.rest()) out_.comment(rest);
  out_.close("agent-collection");
  finish(root, std::string(style_.rootDoctype) + optionsDeclaration() + "]>\n", out_.take());
}

// --- Declarations

std::string XmlWriter::kindOf(ValueKind kind) {
  return kind == ValueKind::number    ? "decimal"
         : kind == ValueKind::boolean ? "boolean"
                                      : "enumerated";
}

std::string XmlWriter::qualified(const syntax::Enumeration& enumeration, std::string_view element) {
  const std::string prefix = std::string(enumeration.name.text) + ".";
  return element.starts_with(prefix) ? std::string(element) : prefix + std::string(element);
}

XmlWriter::Attributes XmlWriter::named(const syntax::Declaration& declaration) {
  return {{"name", std::string(declaration.name.text)},
          {"description", std::string(declaration.doc)}};
}

void XmlWriter::declare(const syntax::Behavior& behavior) {
  function("basic-behavior", named(behavior), behavior.name.text, behavior.parameters);
}

void XmlWriter::declare(const syntax::Constant& constant) {
  out_.empty("constant", attributesOf(constant));
}

void XmlWriter::function(const std::string& element, const Attributes& attributes,
                         std::string_view owner, const std::vector<syntax::Parameter>& parameters) {
  if (parameters.empty()) return out_.empty(element, attributes);
  out_.open(element, attributes);
  for (const syntax::Parameter& each : parameters)
    parameter(each, std::string(owner) + "." + std::string(each.name.text));
  out_.close(element);
}

// --- Options

void XmlWriter::writeOptions() {
  for (std::size_t i = 0; i < program_.options.size(); ++i)
    writeOption(program_.options[i], model_.options[i]);
}

void XmlWriter::writeOption(const syntax::Option& option, const Option& resolved) {
  std::string folder = style_.keepsFolders ? folderOf(program_, option.extent.begin) : "";
  if (folder.empty()) folder = "Options/";
  const std::string path = newPath(folder, option.name.text);
  paths_.push_back(path);
  used_.clear();
  comments(option.extent, option.name);
  Attributes attributes = rootAttributes("option");
  attributes.insert(attributes.end(),
                    {{"name", std::string(option.name.text)},
                     {"initial-state", model_.states[at(resolved.initialState)].name}});
  out_.open("option", attributes);
  const std::string head = out_.take();
  const Tree common{option.commonDecision.get(), resolved.commonDecision};
  const bool copied = common.source && copiesCommon(*common.source);
  state_ = nullptr;
  if (common.source && !copied) {
    out_.open("common-decision-tree", {});
    decision(common, nullptr);
    out_.close("common-decision-tree");
  }
  commonActions(option, resolved);
  for (std::size_t i = 0; i < option.states.size(); ++i) {
    state_ = &option.states[i];
    writeState(option, resolved, model_.states[at(resolved.states.first) + i],
               copied ? &common : nullptr);
  }
  out_.close("option");
  const std::string body = out_.take();
  const auto [entities, references] = inclusions(folder);
  finish(path, optionDoctype(entities), head + references + body);
}

/// The entities that an option's file includes: their declarations, and the references to them.
std::pair<std::string, std::string> XmlWriter::inclusions(const std::string& folder) const {
  std::string declarations, references;
  const auto include = [&](const std::string& entity, const std::filesystem::path& path) {
    references += "  &" + entity + ";\n";
    declarations +=
        "  " + entityDeclaration(entity, path.lexically_relative(folder).generic_string());
  };
  for (const Included& included : included_)
    if (style_.includesAll || used_.count({included.space, included.behaviors}) > 0)
      include(included.entity, included.path);
  include(optionsEntity, optionsFile);
  return {declarations, references};
}

void XmlWriter::writeState(const syntax::Option& option, const Option& resolvedOption,
                           const State& resolved, const Tree* common) {
  const syntax::State& state = *state_;
  comments(state.extent, state.name);
  if (!state.doc.empty()) out_.comment(state.doc);
  Attributes attributes = {{"name", std::string(state.name.text)}};
  if (state.target) attributes.push_back({"is-target-state", "true"});
  if (state.cooperation.kind != Cooperation::Kind::none) {
    const bool capacity = state.cooperation.kind == Cooperation::Kind::capacity;
    attributes.push_back(
        {capacity ? "capacity" : "synchronized", std::to_string(state.cooperation.agents)});
  }
  out_.open("state", attributes);
  stateActions(option, resolvedOption, resolved);
  const Tree own{state.decision.get(), resolved.decision};
  out_.open("decision-tree", {});
  decision(common ? *common : own, common ? &own : nullptr);
  out_.close("decision-tree");
  out_.close("state");
}

std::vector<XmlWriter::ActionPair> XmlWriter::pairs(const std::vector<syntax::Action>& sources,
                                                    Span span) const {
  std::vector<ActionPair> pairs;
  for (std::size_t i = 0; i < sources.size(); ++i)
    pairs.push_back({sources[i], model_.actions[at(span.first) + i]});
  return pairs;
}

void XmlWriter::actions(const std::vector<syntax::Action>& sources, Span span) {
  for (const ActionPair& each : pairs(sources, span)) action(each);
}

void XmlWriter::action(const ActionPair& action) {
  comments(action.source.extent, action.source.name);
  const int target = action.resolved.target;
  if (action.resolved.kind == Action::Kind::assignment) return assignment(action);
  if (action.resolved.kind == Action::Kind::behavior) use(model_.behaviors[at(target)].space, true);
  const bool option = action.resolved.kind == Action::Kind::option;
  arguments(option ? "subsequent-option" : "subsequent-basic-behavior", "set-parameter",
            action.source.name.text, parametersOf(model_, action.resolved), action.source.arguments,
            action.resolved.operand);
}

/// What decides nothing continues with `rest`.
void XmlWriter::decision(const Tree& tree, const Tree* rest) {
  const bool choose = tree.source && tree.source->kind == syntax::Decision::Kind::choose;
  const bool go = tree.source && tree.source->kind == syntax::Decision::Kind::go;
  if (choose) return choice(tree, rest);
  transition(go ? tree.source->target.text : state_->name.text);
}

void XmlWriter::choice(const Tree& tree, const Tree* rest) {
  const syntax::Decision& decision = *tree.source;
  std::size_t open = 0;
  Branch otherwise;
  for (std::size_t i = 0; i < decision.arms.size(); ++i) {
    const Decision& resolved = model_.decisions[at(tree.branch.index) + i];
    const char* element = style_.elseIf && i > 0 ? "else-if" : "if";
    if (!style_.elseIf && i > 0) {
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
    this->decision(decision.otherwise ? Tree{decision.otherwise.get(), otherwise} : *rest, nullptr);
    out_.close("else");
  }
  for (; open > 0; --open) out_.close("else");
}

void XmlWriter::transition(std::string_view state) {
  out_.empty("transition-to-state", {{"ref", std::string(state)}});
}

// --- Expressions

void XmlWriter::use(int space, bool behaviors) {
  used_.insert({program_.namespaces[at(space)].name.text, behaviors});
}

void XmlWriter::expression(const syntax::Expression& source, int index) {
  const Expression& expression = model_.expressions[at(index)];
  switch (expression.operation) {
    case Operator::constant:
      return constant(source, expression);
    case Operator::element: {
      const Enumeration& enumeration = model_.enumerations[at(expression.a)];
      use(enumeration.space, false);
      return out_.empty(
          "enum-element-ref",
          {{"ref", enumeration.name + "." + enumeration.elements[at(expression.b)].name}});
    }
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
      return out_.empty("conflict", {});
    case Operator::negate:
      return negation(source, expression);
    case Operator::conditional:
      return conditional(source, expression);
    default:
      operation(source, index);
  }
}

void XmlWriter::constant(const syntax::Expression& source, const Expression& expression) {
  if (expression.a >= 0) {
    const Constant& constant = model_.constants[at(expression.a)];
    use(constant.space, false);
    return out_.empty("constant-ref", {{"ref", constant.name}});
  }
  if (expression.b < 0) return number(digits(source, expression.number));
  out_.empty("boolean-value", {{"value", expression.number != 0 ? "true" : "false"}});
}

void XmlWriter::number(const std::string& value) {
  out_.empty("decimal-value", {{"value", value}});
}

void XmlWriter::symbol(const syntax::Expression& source, const Expression& expression) {
  const Symbol& symbol = model_.symbols[at(expression.a)];
  use(symbol.space, false);
  const char* kind = expression.operation == Operator::input ? "-input-" : "-output-";
  const std::string reference{symbol.parameters.empty() ? "symbol-ref" : style_.functionReference};
  arguments(kindOf(symbol.type.kind) + kind + reference, "with-parameter", symbol.name,
            symbol.parameters, source.arguments, expression.b);
}

void XmlWriter::arguments(const std::string& element, const char* inner, std::string_view name,
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
void XmlWriter::negation(const syntax::Expression& source, const Expression& expression) {
  const syntax::Expression& operand = *source.operands.front();
  if (const auto value = negated(operand, expression)) return number(*value);
  out_.open("minus", {});
  number("0");
  this->expression(operand, expression.a);
  out_.close("minus");
}

void XmlWriter::conditional(const syntax::Expression& source, const Expression& expression) {
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

void XmlWriter::operation(const syntax::Expression& source, int index) {
  const Expression& expression = model_.expressions[at(index)];
  const bool differs = expression.operation == Operator::notEqual;
  if ((!differs && expression.operation != Operator::equal) || !isComparison(source, expression))
    return element(elementOf(expression.operation), source, index);
  if (differs) out_.open("not", {});
  comparison(source, index);
  if (differs) out_.close("not");
}

void XmlWriter::element(std::string_view name, const syntax::Expression& source, int index) {
  out_.open(name, {});
  operands(source, index);
  out_.close(name);
}

void XmlWriter::operands(const syntax::Expression& source, int index) {
  const Expression& expression = model_.expressions[at(index)];
  const bool connection =
      expression.operation == Operator::logicalAnd || expression.operation == Operator::logicalOr;
  for (std::size_t i = 0; i < source.operands.size(); ++i) {
    const int operand = connection ? model_.operands[at(expression.b) + i]
                        : i == 0   ? expression.a
                                   : expression.b;
    const bool same = model_.expressions[at(operand)].operation == expression.operation;
    if (connection && same && !style_.keepsConnections)
      operands(*source.operands[i], operand);
    else
      this->expression(*source.operands[i], operand);
  }
}

VirtualFiles writeXml(const syntax::Program& program, const Model& model, Dialect dialect,
                      const std::string& root, Reporter& reporter) {
  return (dialect == Dialect::xabsl21 ? writeXml21 : writeXml31)(program, model, root, reporter);
}

}  // namespace xabsl
