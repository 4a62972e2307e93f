#include "xabsl/language/References.h"

namespace xabsl {

using Kind = Entity::Kind;

void References::add(const Entity& entity, std::string_view text, Location location) {
  all_.push_back({entity, text, location, false});
}

void References::addQualified(const Entity& owner, const Entity& entity, std::string_view text,
                              Location location, std::size_t ownerLength) {
  const bool qualified = ownerLength > 0 && ownerLength < text.size() && text[ownerLength] == '.';
  if (!qualified) return add(entity, text, location);
  add(owner, text.substr(0, ownerLength), location);
  location.column += static_cast<int>(ownerLength) + 1;
  add(entity, text.substr(ownerLength + 1), location);
}

void References::declare(const Entity& entity, const syntax::Name& name) {
  if (!name.text.empty()) all_.push_back({entity, name.text, name.location, true});
}

void References::declareParameters(Kind kind, int owner,
                                   const std::vector<syntax::Parameter>& parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    syntax::Name name = parameters[i].name;
    if (kind == Kind::optionParameter) ++name.location.column;  // behind the @
    declare({kind, owner, static_cast<int>(i)}, name);
  }
}

void References::declare(const syntax::Program& program) {
  const auto each = [](const auto& list, auto visit) {
    for (std::size_t i = 0; i < list.size(); ++i) visit(static_cast<int>(i), list[i]);
  };
  each(program.namespaces, [&](int i, const auto& space) {
    declare({Kind::space, i}, space.name);
  });
  each(program.enumerations, [&](int i, const auto& enumeration) {
    declare({Kind::enumeration, i}, enumeration.name);
    each(enumeration.elements, [&](int k, const syntax::Name& element) {
      const std::string_view owner = enumeration.name.text;
      const bool qualified = element.text.substr(0, owner.size()) == owner;
      addQualified({Kind::enumeration, i}, {Kind::element, i, k}, element.text, element.location,
                   qualified ? owner.size() : 0);
      all_.back().declares = true;
    });
  });
  each(program.symbols, [&](int i, const auto& symbol) {
    declare({Kind::symbol, i}, symbol.name);
    declareParameters(Kind::symbolParameter, i, symbol.parameters);
  });
  each(program.constants, [&](int i, const auto& constant) {
    declare({Kind::constant, i}, constant.name);
  });
  each(program.behaviors, [&](int i, const auto& behavior) {
    declare({Kind::behavior, i}, behavior.name);
    declareParameters(Kind::behaviorParameter, i, behavior.parameters);
  });
  int state = 0;
  each(program.options, [&](int i, const auto& option) {
    declare({Kind::option, i}, option.name);
    declareParameters(Kind::optionParameter, i, option.parameters);
    for (const syntax::State& source : option.states) declare({Kind::state, state++}, source.name);
  });
  each(program.agents, [&](int i, const auto& agent) { declare({Kind::agent, i}, agent.name); });
}

}  // namespace xabsl
