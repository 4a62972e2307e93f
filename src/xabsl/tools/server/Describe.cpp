#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/tools/server/Project.h"

namespace xabsl::server {

namespace {

using Kind = Entity::Kind;

/// An element of a list, or null if the index is out of range, which is possible after errors.
template <typename List>
auto find(const List& list, int index) -> decltype(list.data()) {
  return index >= 0 && static_cast<std::size_t>(index) < list.size() ? &list[at(index)] : nullptr;
}

std::string measure(const std::string& range, const std::string& unit) {
  return (range.empty() ? "" : " [" + range + "]") + (unit.empty() ? "" : " \"" + unit + "\"");
}

std::string list(const Model& model, const std::vector<Parameter>& parameters) {
  std::string text;
  for (const Parameter& parameter : parameters)
    text += " " + describe(model, parameter.type) + " " + parameter.name +
            measure(parameter.range, parameter.unit) + ";";
  return text;
}

const std::vector<Parameter>* ownersParameters(const Model& model, const Entity& entity) {
  if (entity.kind == Kind::symbolParameter)
    if (const auto* owner = find(model.symbols, entity.index)) return &owner->parameters;
  if (entity.kind == Kind::behaviorParameter)
    if (const auto* owner = find(model.behaviors, entity.index)) return &owner->parameters;
  if (entity.kind == Kind::optionParameter)
    if (const auto* owner = find(model.options, entity.index)) return &owner->parameters;
  return nullptr;
}

/// The description of an entity: its declaration and its documentation.
struct About {
  std::string signature;
  std::string doc;
};

About aboutSymbol(const Model& model, const Symbol& symbol) {
  const std::string kind = std::string(" ") + wordOf(symbol.kind) + " ";
  std::string text =
      describe(model, symbol.type) + kind + symbol.name + measure(symbol.range, symbol.unit);
  if (!symbol.parameters.empty()) text += " (" + list(model, symbol.parameters) + " )";
  return {text, symbol.doc};
}

About aboutEnumeration(const Enumeration& enumeration) {
  std::string elements;
  for (const EnumerationElement& element : enumeration.elements)
    elements += (elements.empty() ? " " : ", ") + element.name;
  return {"enum " + enumeration.name + " {" + elements + " }", enumeration.doc};
}

About aboutParameter(const Model& model, const Entity& entity) {
  const auto* parameters = ownersParameters(model, entity);
  const auto* parameter = parameters ? find(*parameters, entity.part) : nullptr;
  if (!parameter) return {};
  const std::string sign = entity.kind == Kind::optionParameter ? " @" : " ";
  return {describe(model, parameter->type) + sign + parameter->name +
              measure(parameter->range, parameter->unit),
          parameter->doc};
}

About about(const Model& model, const Entity& entity) {
  switch (entity.kind) {
    case Kind::symbol:
      if (const auto* symbol = find(model.symbols, entity.index))
        return aboutSymbol(model, *symbol);
      break;
    case Kind::constant:
      if (const auto* constant = find(model.constants, entity.index))
        return {"float const " + constant->name + " = " + constant->digits +
                    measure("", constant->unit),
                constant->doc};
      break;
    case Kind::behavior:
      if (const auto* behavior = find(model.behaviors, entity.index))
        return {"behavior " + behavior->name + " {" + list(model, behavior->parameters) + " }",
                behavior->doc};
      break;
    case Kind::option:
      if (const auto* option = find(model.options, entity.index))
        return {"option " + option->name + " {" + list(model, option->parameters) + " }",
                option->doc};
      break;
    case Kind::state:
      if (const auto* state = find(model.states, entity.index))
        return {(state->target ? "target state " : "state ") + state->name, state->doc};
      break;
    case Kind::enumeration:
    case Kind::element:
      if (const auto* enumeration = find(model.enumerations, entity.index))
        return aboutEnumeration(*enumeration);
      break;
    case Kind::agent:
      if (const auto* agent = find(model.agents, entity.index))
        return {"agent " + agent->name + "(\"" + agent->title + "\")", agent->doc};
      break;
    case Kind::space:
      if (const auto* space = find(model.namespaces, entity.index))
        return {"namespace " + space->name + "(\"" + space->title + "\")", space->doc};
      break;
    default:
      return aboutParameter(model, entity);
  }
  return {};
}

}  // namespace

std::string signatureOf(const Project& project, const Entity& entity) {
  return about(project.model(), entity).signature;
}

std::string describeEntity(const Project& project, const Entity& entity) {
  const About found = about(project.model(), entity);
  if (found.signature.empty()) return {};
  return "```xabsl\n" + found.signature + "\n```" + (found.doc.empty() ? "" : "\n\n" + found.doc);
}

}  // namespace xabsl::server
