#include "xabsl/formats/intermediate/EnumerationInference.h"

#include <utility>

#include "xabsl/engine/Symbols.h"
#include "xabsl/language/Text.h"

namespace xabsl {

int EnumerationInference::named(std::string_view name) {
  const auto found = names_.find(name);
  if (found != names_.end()) return found->second;
  const int domain = fresh();
  domains_.back().name = name;
  names_.emplace(std::string(name), domain);
  return domain;
}

int EnumerationInference::fresh() {
  const int domain = static_cast<int>(domains_.size());
  domains_.push_back({domain, {}});
  return domain;
}

int EnumerationInference::declare(std::string_view name,
                                  const std::vector<std::string_view>& elements,
                                  Location location) {
  Enumeration enumeration{std::string(name), {}, location, true};
  for (const std::string_view element : elements)
    enumeration.elements.push_back({std::string(withoutOwner(element, name)), location});
  if (!declared_.emplace(std::string(name), std::move(enumeration)).second)
    reporter_.error(location, "enumeration '" + std::string(name) + "' is declared twice");
  return named(name);
}

int EnumerationInference::root(int domain) {
  while (domains_[at(domain)].parent != domain) {
    int& parent = domains_[at(domain)].parent;
    parent = domains_[at(parent)].parent;  // shortens the way for the next time
    domain = parent;
  }
  return domain;
}

bool EnumerationInference::unite(int a, int b) {
  a = root(a);
  b = root(b);
  if (a == b) return true;
  // The named one stays the root, so that its number identifies its name.
  if (domains_[at(a)].name.empty()) std::swap(a, b);
  if (!domains_[at(b)].name.empty()) return false;
  domains_[at(b)].parent = a;
  return true;
}

int EnumerationInference::mention(int domain, std::string_view text, Location location) {
  mentions_.push_back({domain, text, location});
  return static_cast<int>(mentions_.size()) - 1;
}

bool EnumerationInference::isKnown(std::string_view name) const {
  return names_.find(name) != names_.end() ||
         (registered_ && registered_->findEnumeration(std::string(name)));
}

/// The longest `name` such that all elements begin with `name.`; a known one is preferred.
std::string EnumerationInference::inferredName(const std::vector<int>& mentions) const {
  if (mentions.empty()) return {};
  const std::string_view first = mentions_[at(mentions.front())].text;
  std::string_view longest;
  for (std::size_t dot = first.rfind('.'); dot != std::string_view::npos && dot > 0;
       dot = first.rfind('.', dot - 1)) {
    const std::string_view name = first.substr(0, dot);
    bool common = true;
    for (const int mention : mentions) {
      const std::string_view text = mentions_[at(mention)].text;
      common =
          common && text.size() > dot + 1 && text.substr(0, dot + 1) == first.substr(0, dot + 1);
    }
    if (!common) continue;
    if (isKnown(name)) return std::string(name);
    if (longest.empty()) longest = name;
  }
  return std::string(longest);
}

int EnumerationInference::enumerationNamed(const std::string& name,
                                           std::vector<Enumeration>& enumerations) {
  const auto [entry, added] = resolved_.emplace(name, static_cast<int>(enumerations.size()));
  if (!added) return entry->second;
  Enumeration enumeration{name, {}, {}};
  const auto declared = declared_.find(name);
  if (declared != declared_.end()) {
    enumeration = declared->second;
  } else if (const RegisteredEnumeration* known =
                 registered_ ? registered_->findEnumeration(name) : nullptr) {
    for (const std::string& element : known->elements)
      enumeration.elements.push_back({element, {}});
  }
  elements_.emplace_back();
  for (std::size_t i = 0; i < enumeration.elements.size(); ++i)
    elements_.back().emplace(enumeration.elements[i].name, static_cast<int>(i));
  enumerations.push_back(std::move(enumeration));
  return entry->second;
}

void EnumerationInference::addElement(Mention& mention, std::vector<Enumeration>& enumerations) {
  const int index = enumeration(mention.domain);
  Enumeration& enumeration = enumerations[at(index)];
  const std::string name(withoutOwner(mention.text, enumeration.name));
  const auto [entry, added] =
      elements_[at(index)].emplace(name, static_cast<int>(enumeration.elements.size()));
  mention.element = entry->second;
  if (!added) return;
  if (declared_.count(enumeration.name) > 0)
    reporter_.error(mention.location, "enumeration '" + enumeration.name + "' has no element '" +
                                          std::string(mention.text) + "'");
  // Of others than the declared ones, the linker knows the elements.
  enumeration.elements.push_back({name, mention.location});
}

std::vector<Enumeration> EnumerationInference::resolve() {
  std::vector<std::vector<int>> mentionsOf(domains_.size());
  for (std::size_t i = 0; i < mentions_.size(); ++i)
    mentionsOf[at(root(mentions_[i].domain))].push_back(static_cast<int>(i));
  std::vector<Enumeration> enumerations;
  for (const auto& [name, enumeration] : declared_) enumerationNamed(name, enumerations);
  for (std::size_t i = 0; i < domains_.size(); ++i) {
    if (domains_[i].parent != static_cast<int>(i)) continue;
    const std::string name =
        domains_[i].name.empty() ? inferredName(mentionsOf[i]) : domains_[i].name;
    domains_[i].enumeration = enumerationNamed(name, enumerations);
  }
  for (Mention& mention : mentions_) addElement(mention, enumerations);
  for (Enumeration& enumeration : enumerations)
    if (enumeration.elements.empty()) enumeration.elements.push_back({"", {}});
  return enumerations;
}

int EnumerationInference::enumeration(int domain) {
  return domains_[at(root(domain))].enumeration;
}

}  // namespace xabsl
