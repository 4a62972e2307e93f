#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "xabsl/formats/Lowering.h"
#include "xabsl/formats/SourceWriter.h"
#include "xabsl/formats/XmlOperators.h"
#include "xabsl/formats/XmlOutput.h"
#include "xabsl/formats/XmlTree.h"
#include "xabsl/language/Model.h"

namespace xabsl {

using xml::Attributes;
using xml::escaped;
using xml::XmlOutput;

namespace {

constexpr const char* doctypeFile = "symbol-and-basic-behavior-files.dtd";
constexpr const char* optionsEntity = "options";

/// What the names of elements about a type begin with.
std::string kindOf(Type type) {
  return type.kind == ValueKind::number    ? "decimal"
         : type.kind == ValueKind::boolean ? "boolean"
                                           : "enumerated";
}

/// Writes from the model, since there each element is named by the type of what it stands for;
/// comments and the order of declarations come from the syntax tree.
class Xml31Writer {
 public:
  Xml31Writer(const syntax::Program& program, const Model& model)
      : program_(program), model_(model), comments_(program) {}

  VirtualFiles write(const std::string& root) {
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    for (const Option& option : model_.options) writeOption(option);
    writeDefinitions();
    writeDoctype();
    writeRoot(root);
    return std::move(files_);
  }

 private:
  struct Included {
    std::string entity;
    std::string path;
    std::string space;
    bool behaviors;
  };

  // --- Files

  void finish(const std::string& path, const std::string& doctype, std::string text) {
    files_[path] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + doctype + std::move(text);
  }

  static Attributes rootAttributes() {
    return {{"xmlns", std::string(xml::namespace31)},
            {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}};
  }

  void writeCollection(const Collection& collection) {
    const syntax::Namespace& space = *collection.space;
    const std::string name(space.name.text);
    const char* kind = collection.behaviors ? "basic-behaviors" : "symbols";
    comments(space.extent.begin);
    Attributes attributes = rootAttributes();
    attributes.insert(attributes.end(), {{"id", name},
                                         {"title", std::string(space.title)},
                                         {"description", std::string(space.doc)}});
    out_.open(kind, attributes);
    for (const syntax::Declaration* member : collection.members) this->member(*member);
    out_.close(kind);
    const std::string path =
        (collection.behaviors ? "BasicBehaviors/" : "Symbols/") + name + ".xml";
    finish(path, "", out_.take());
    std::string entity = name;
    const auto taken = [&](const Included& other) { return other.entity == entity; };
    while (entity == optionsEntity || std::any_of(included_.begin(), included_.end(), taken))
      entity += "-2";
    included_.push_back({entity, path, name, collection.behaviors});
  }

  /// Model and syntax tree list the same declarations in the same order.
  template <typename Source, typename Resolved>
  static const Resolved* resolved(const std::vector<Source>& sources,
                                  const std::vector<Resolved>& models,
                                  const syntax::Declaration& member) {
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (&sources[i] == &member) return &models[i];
    return nullptr;
  }

  void member(const syntax::Declaration& member) {
    comments(member.extent.begin);
    if (const auto* one = resolved(program_.enumerations, model_.enumerations, member))
      enumeration(*one);
    else if (const auto* symbol = resolved(program_.symbols, model_.symbols, member))
      this->symbol(*symbol);
    else if (const auto* constant = resolved(program_.constants, model_.constants, member))
      this->constant(*constant);
    else if (const auto* behavior = resolved(program_.behaviors, model_.behaviors, member))
      function("basic-behavior", {{"name", behavior->name}, {"description", behavior->doc}},
               behavior->name, behavior->parameters);
  }

  void enumeration(const Enumeration& enumeration) {
    Attributes attributes = {{"name", enumeration.name}, {"description", enumeration.doc}};
    if (enumeration.internal) attributes.push_back({"internal", "true"});
    out_.open("enumeration", attributes);
    for (const EnumerationElement& element : enumeration.elements)
      out_.empty("enum-element", {{"name", enumeration.name + "." + element.name}});
    out_.close("enumeration");
  }

  void symbol(const Symbol& symbol) {
    const bool input = symbol.kind == SymbolKind::input;
    Attributes attributes = typed(symbol.name, symbol.type, symbol.doc, symbol.unit, symbol.range);
    if (symbol.kind == SymbolKind::internal) attributes.push_back({"internal", "true"});
    function(kindOf(symbol.type) + (input ? "-input-symbol" : "-output-symbol"), attributes,
             symbol.name, symbol.parameters);
  }

  Attributes typed(const std::string& name, Type type, const std::string& doc,
                   const std::string& unit, const std::string& range) const {
    if (type.kind == ValueKind::boolean) return {{"name", name}, {"description", doc}};
    if (type.kind == ValueKind::enumeration)
      return {{"name", name},
              {"enumeration", model_.enumerations[at(type.enumeration)].name},
              {"description", doc}};
    return {{"name", name}, {"description", doc}, {"measure", unit}, {"range", range}};
  }

  void function(const std::string& element, const Attributes& attributes, const std::string& owner,
                const std::vector<Parameter>& parameters) {
    if (parameters.empty()) return out_.empty(element, attributes);
    out_.open(element, attributes);
    for (const Parameter& parameter : parameters) {
      comments(parameter.location);
      out_.empty(kindOf(parameter.type) + "-parameter",
                 typed(owner + "." + parameter.name, parameter.type, parameter.doc, parameter.unit,
                       parameter.range));
    }
    out_.close(element);
  }

  void constant(const Constant& constant) {
    out_.empty("constant", {{"name", constant.name},
                            {"value", constant.digits},
                            {"measure", constant.unit},
                            {"description", constant.doc}});
  }

  void writeDefinitions() {
    out_.open("option-definitions", rootAttributes());
    for (const Option& option : model_.options)
      function("option-definition", {{"name", option.name}, {"description", option.doc}},
               option.name, option.parameters);
    out_.close("option-definitions");
    finish("options.xml", "", out_.take());
  }

  void writeDoctype() {
    std::string text;
    const auto entity = [&](const std::string& name, const std::string& path) {
      text += "<!ENTITY " + name + " SYSTEM \"" + escaped(path) + "\">\n";
    };
    for (const Included& included : included_) entity(included.entity, included.path);
    entity(optionsEntity, "options.xml");
    finish(doctypeFile, "", text);
  }

  void writeRoot(const std::string& root) {
    Attributes attributes = rootAttributes();
    attributes.push_back({"xmlns:xi", "http://www.w3.org/2003/XInclude"});
    out_.open("agent-collection", attributes);
    out_.line("<title>" + escaped(model_.title) + "</title>");
    out_.line("<platform>" + escaped(model_.platform) + "</platform>");
    out_.line("<software-environment>" + escaped(model_.softwareEnvironment) +
              "</software-environment>");
    for (const Agent& agent : model_.agents) {
      comments(agent.location);
      out_.empty("agent", {{"id", agent.name},
                           {"title", agent.title},
                           {"description", agent.doc},
                           {"root-option", model_.options[at(agent.rootOption)].name}});
    }
    out_.line("&options;");
    out_.open("options", {});
    for (const Option& option : model_.options)
      out_.empty("xi:include", {{"href", pathOf(option)}});
    out_.close("options");
    for (const std::string& rest : comments_.rest()) out_.comment(rest);
    out_.close("agent-collection");
    finish(root, "<!DOCTYPE options [\n    <!ENTITY options SYSTEM \"options.xml\">\n]>\n",
           out_.take());
  }

  static std::string pathOf(const Option& option) { return "Options/" + option.name + ".xml"; }

  // --- Options

  void writeOption(const Option& option) {
    comments(option.location);
    used_.clear();
    Attributes attributes = rootAttributes();
    attributes.insert(
        attributes.end(),
        {{"name", option.name}, {"initial-state", model_.states[at(option.initialState)].name}});
    out_.open("option", attributes);
    const std::string head = out_.take();
    // Only a state's own decision tree can tell to stay in it: then each has the whole.
    const bool copied = stays(option.commonDecision);
    if (option.commonDecision.kind != Branch::Kind::none && !copied) {
      out_.open("common-decision-tree", {});
      statement(option.commonDecision, nullptr);
      out_.close("common-decision-tree");
    }
    if (option.commonActions.count > 0) {
      out_.open("common-action", {});
      actions(option.commonActions);
      out_.close("common-action");
    }
    for (int i = 0; i < option.states.count; ++i)
      state(option.states.first + i, copied ? &option.commonDecision : nullptr);
    out_.close("option");
    const std::string body = out_.take();
    std::string entities;
    for (const Included& included : included_)
      if (used_.count({included.space, included.behaviors}) > 0)
        entities += "  &" + included.entity + ";\n";
    entities += std::string("  &") + optionsEntity + ";\n";
    finish(pathOf(option),
           std::string("<!DOCTYPE symbol-and-basic-behavior-files SYSTEM \"../") + doctypeFile +
               "\">\n",
           head + entities + body);
  }

  bool stays(Branch branch) const {
    for (; branch.kind == Branch::Kind::decision;
         branch = model_.decisions[at(branch.index)].otherwise)
      if (stays(model_.decisions[at(branch.index)].then)) return true;
    return branch.kind == Branch::Kind::stay;
  }

  void state(int index, const Branch* common) {
    const State& state = model_.states[at(index)];
    state_ = index;
    comments(state.location);
    if (!state.doc.empty()) out_.comment(state.doc);
    Attributes attributes = {{"name", state.name}};
    if (state.target) attributes.push_back({"is-target-state", "true"});
    if (state.cooperation.kind != Cooperation::Kind::none)
      attributes.push_back(
          {state.cooperation.kind == Cooperation::Kind::capacity ? "capacity" : "synchronized",
           std::to_string(state.cooperation.agents)});
    out_.open("state", attributes);
    actions(state.actions);
    out_.open("decision-tree", {});
    statement(common ? *common : state.decision, common ? &state.decision : nullptr);
    out_.close("decision-tree");
    out_.close("state");
  }

  void actions(Span span) {
    for (int i = span.first; i < span.first + span.count; ++i) action(model_.actions[at(i)]);
  }

  void action(const Action& action) {
    comments(action.location);
    if (action.kind == Action::Kind::assignment) {
      const Symbol& symbol = model_.symbols[at(action.target)];
      const std::string element = "set-" + kindOf(symbol.type) + "-output-symbol";
      use(symbol.space);
      out_.open(element, {{"ref", symbol.name}});
      expression(action.operand);
      out_.close(element);
    } else if (action.kind == Action::Kind::option) {
      const Option& option = model_.options[at(action.target)];
      values("subsequent-option", "set-parameter", option.name, option.parameters, action.operand);
    } else {
      const BasicBehavior& behavior = model_.behaviors[at(action.target)];
      used_.insert({model_.namespaces[at(behavior.space)].name, true});
      values("subsequent-basic-behavior", "set-parameter", behavior.name, behavior.parameters,
             action.operand);
    }
  }

  void values(const std::string& element, const char* inner, const std::string& name,
              const std::vector<Parameter>& parameters, int first) {
    const bool some = !parameters.empty() && model_.argumentOrder[at(first)] >= 0;
    if (!some) return out_.empty(element, {{"ref", name}});
    out_.open(element, {{"ref", name}});
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const int parameter = model_.argumentOrder[at(first) + i];
      if (parameter < 0) break;
      out_.open(inner, {{"ref", name + "." + parameters[at(parameter)].name}});
      expression(model_.operands[at(first + parameter)]);
      out_.close(inner);
    }
    out_.close(element);
  }

  /// `else if` is an `if` in an `else` here: they are opened in a loop, and closed at the end. What
  /// decides nothing goes on with `rest`.
  void statement(Branch branch, const Branch* rest) {
    int open = 0;
    for (;;) {
      if (branch.kind == Branch::Kind::none && rest) branch = *std::exchange(rest, nullptr);
      if (branch.kind != Branch::Kind::decision) break;
      const Decision& decision = model_.decisions[at(branch.index)];
      out_.open("if", {});
      out_.open("condition", {{"description", decision.doc}});
      expression(decision.condition);
      out_.close("condition");
      statement(decision.then, nullptr);
      out_.close("if");
      branch = decision.otherwise;
      if (branch.kind == Branch::Kind::none && !rest) break;
      out_.open("else", {});
      ++open;
    }
    const int target = branch.kind == Branch::Kind::stay ? state_ : branch.index;
    if (branch.kind != Branch::Kind::none)
      out_.empty("transition-to-state", {{"ref", model_.states[at(target)].name}});
    for (; open > 0; --open) out_.close("else");
  }

  // --- Expressions

  void use(int space) { used_.insert({model_.namespaces[at(space)].name, false}); }

  void expression(int index) {
    const Expression& expression = model_.expressions[at(index)];
    switch (expression.operation) {
      case Operator::constant:
        return constant(expression);
      case Operator::element: {
        const Enumeration& enumeration = model_.enumerations[at(expression.a)];
        use(enumeration.space);
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
        return symbolReference(expression);
      case Operator::stateTime:
        return out_.empty("time-of-state-execution", {});
      case Operator::optionTime:
        return out_.empty("time-of-option-execution", {});
      case Operator::actionDone:
        return out_.empty("subsequent-option-reached-target-state", {});
      case Operator::conflict:
        return out_.empty("conflict", {});
      case Operator::negate:
        return negation(expression);
      case Operator::conditional:
        return conditional(expression);
      default:
        operation(index);
    }
  }

  void constant(const Expression& expression) {
    if (expression.a >= 0) {
      const Constant& constant = model_.constants[at(expression.a)];
      use(constant.space);
      return out_.empty("constant-ref", {{"ref", constant.name}});
    }
    if (expression.b >= 0)
      return out_.empty("boolean-value", {{"value", expression.number != 0 ? "true" : "false"}});
    out_.empty("decimal-value", {{"value", decimalText(expression.number)}});
  }

  void symbolReference(const Expression& expression) {
    const Symbol& symbol = model_.symbols[at(expression.a)];
    const bool input = expression.operation == Operator::input;
    use(symbol.space);
    values(kindOf(symbol.type) + (input ? "-input-symbol-ref" : "-output-symbol-ref"),
           "with-parameter", symbol.name, symbol.parameters, expression.b);
  }

  /// A number gets the sign itself, anything else is taken from 0.
  void negation(const Expression& expression) {
    if (const std::optional<double> number = signedNumber(model_, expression))
      return out_.empty("decimal-value", {{"value", decimalText(*number)}});
    out_.open("minus", {});
    out_.empty("decimal-value", {{"value", "0"}});
    this->expression(expression.a);
    out_.close("minus");
  }

  void conditional(const Expression& expression) {
    out_.open("conditional-expression", {});
    for (const auto& [name, operand] :
         {std::pair("condition", expression.a), std::pair("expression1", expression.b),
          std::pair("expression2", expression.c)}) {
      out_.open(name, {});
      this->expression(operand);
      out_.close(name);
    }
    out_.close("conditional-expression");
  }

  void operation(int index) {
    const Expression& expression = model_.expressions[at(index)];
    using xml::operators;
    std::string_view name = std::find_if(std::begin(operators), std::end(operators),
                                         [&](const xml::OperatorElement& element) {
                                           return element.operation == expression.operation;
                                         })
                                ->name;
    const bool equality =
        expression.operation == Operator::equal || expression.operation == Operator::notEqual;
    const bool enumerated = equality && isEnumerated(model_, expression.a);
    const bool differs = enumerated && expression.operation == Operator::notEqual;
    if (enumerated) name = "enumerated-input-symbol-comparison";
    if (differs) out_.open("not", {});
    out_.open(name, {});
    if (expression.operation == Operator::logicalAnd || expression.operation == Operator::logicalOr)
      for (const int operand : flattened(model_, index)) this->expression(operand);
    else
      for (const int operand : {expression.a, expression.b})
        if (operand >= 0) this->expression(operand);
    out_.close(name);
    if (differs) out_.close("not");
  }

  void comments(Location place) {
    for (const std::string& text : comments_.before(place)) out_.comment(text);
  }

  const syntax::Program& program_;
  const Model& model_;
  LooseComments comments_;
  XmlOutput out_;  // of the present file
  VirtualFiles files_;
  std::vector<Included> included_;
  std::set<std::pair<std::string, bool>> used_;  // namespaces by the present option
  int state_ = -1;
};

}  // namespace

VirtualFiles writeXml31(const syntax::Program& program, const Model& model,
                        const std::string& root) {
  return Xml31Writer(program, model).write(root);
}

}  // namespace xabsl
