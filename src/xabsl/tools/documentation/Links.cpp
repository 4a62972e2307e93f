#include "xabsl/tools/documentation/Links.h"

#include <algorithm>

#include "xabsl/tools/documentation/Html.h"

namespace xabsl::documentation {

namespace {

/// The name of a page. Long names are cut and distinguished by the index.
std::string page(const std::string& kind, const std::string& name, int index) {
  constexpr std::size_t longest = 100;
  std::string encodedName = encoded(name);
  if (encodedName.size() > longest)
    encodedName = encodedName.substr(0, longest) + "~" + std::to_string(index);
  return kind + "-" + encodedName + ".html";
}

}  // namespace

Links::Links(const Model& model) : model_(model), optionOfState_(model.states.size(), -1) {
  for (std::size_t i = 0; i < model.options.size(); ++i)
    std::fill_n(optionOfState_.begin() + model.options[i].states.first,
                model.options[i].states.count, static_cast<int>(i));
  for (std::size_t i = 0; i < model.namespaces.size(); ++i) {
    const int index = static_cast<int>(i);
    std::string name = page("namespace", model.namespaces[i].name, index);
    // Namespaces may have the same name; that is but a warning.
    if (std::find(spaces_.begin(), spaces_.end(), name) != spaces_.end())
      name = page("namespace", model.namespaces[i].name + "~" + std::to_string(index), index);
    spaces_.push_back(std::move(name));
  }
}

std::string Links::agent(int agent) const {
  return page("agent", model_.agents[at(agent)].name, agent);
}

std::string Links::option(int option) const {
  return page("option", model_.options[at(option)].name, option);
}

std::string Links::state(int state) const {
  return option(optionOf(state)) + "#" + fragment("state", model_.states[at(state)].name);
}

std::string Links::commonDecision(int option) const {
  return Links::option(option) + "#common-decision";
}

std::string Links::space(int space) const {
  return space < 0 ? "namespaces-none.html" : spaces_[at(space)];
}

std::string_view Links::kindOf(const Symbol& symbol) {
  return symbol.kind == SymbolKind::input ? "input" : "symbol";
}

std::string Links::symbol(int symbol) const {
  const Symbol& found = model_.symbols[at(symbol)];
  return space(found.space) + "#" + fragment(kindOf(found), found.name);
}

std::string Links::constant(int constant) const {
  const Constant& found = model_.constants[at(constant)];
  return space(found.space) + "#" + fragment("constant", found.name);
}

std::string Links::enumeration(int enumeration) const {
  const Enumeration& found = model_.enumerations[at(enumeration)];
  return space(found.space) + "#" + fragment("enumeration", found.name);
}

std::string Links::behavior(int behavior) const {
  const BasicBehavior& found = model_.behaviors[at(behavior)];
  return space(found.space) + "#" + fragment("behavior", found.name);
}

std::string Links::target(const Thing& thing) const {
  switch (thing.kind) {
    case Thing::Kind::option:
      return option(thing.index);
    case Thing::Kind::behavior:
      return behavior(thing.index);
    case Thing::Kind::constant:
      return constant(thing.index);
    case Thing::Kind::element:
      return enumeration(thing.index);
    default:
      return symbol(thing.index);
  }
}

std::string Links::fragment(std::string_view kind, std::string_view name) {
  return std::string(kind) + "-" + encoded(name);
}

}  // namespace xabsl::documentation
