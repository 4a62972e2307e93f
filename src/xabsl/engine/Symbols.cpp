#include "xabsl/engine/Symbols.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace xabsl {

std::string Symbols::enumerationName(const RegisteredType& type) const {
  if (!type.enumeration.empty()) return type.enumeration;
  for (const auto& [name, enumeration] : enumerations_)
    if (enumeration.type == type.type) return name;
  return {};
}

void Symbols::place(std::vector<std::string>& names, int value, const std::string& name) {
  constexpr int largest = 10'000;
  assert(value >= 0 && value <= largest && "values of enumerations are indices");
  names.resize(std::max(names.size(), static_cast<std::size_t>(value) + 1));
  names[at(value)] = name;
}

void Symbols::addEnumeration(const std::string& name, std::vector<std::string> elements,
                             std::type_index type) {
  RegisteredEnumeration& entry = enumerations_[name];
  entry.elements = std::move(elements);
  entry.type = type;
}

void Symbols::add(RegisteredFunction& entry, Function function, RegisteredType type,
                  std::vector<RegisteredType> arguments, const std::vector<ParameterName>& names) {
  assert(arguments.size() == names.size() && "one name per argument");
  entry.function = std::move(function);
  entry.type = std::move(type);
  entry.parameters.clear();
  for (std::size_t i = 0; i < names.size(); ++i) {
    RegisteredParameter parameter{names[i].name, std::move(arguments[i])};
    if (!names[i].enumeration.empty())
      parameter.type = {ValueKind::enumeration, typeid(void), names[i].enumeration};
    entry.parameters.push_back(std::move(parameter));
  }
}

void Symbols::setIndex(RegisteredFunction& entry, const std::string& enumeration) {
  entry.type.kind = ValueKind::enumeration;
  entry.type.type = typeid(void);
  entry.type.enumeration = enumeration;
}

}  // namespace xabsl
