#include "xabsl/Symbols.h"

#include <cassert>

namespace xabsl {

std::string Symbols::enumerationName(const RegisteredType& type) const {
  if (!type.enumeration.empty()) return type.enumeration;
  for (const auto& [name, enumeration] : enumerations_)
    if (enumeration.type == type.type) return name;
  return {};
}

std::vector<RegisteredParameter> Symbols::join(std::vector<RegisteredType> types,
                                               const std::vector<ParameterName>& names) {
  assert(types.size() == names.size() && "one name per argument");
  std::vector<RegisteredParameter> parameters;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (!names[i].enumeration.empty())
      types[i] = {ValueKind::enumeration, typeid(void), names[i].enumeration};
    parameters.push_back({names[i].name, std::move(types[i])});
  }
  return parameters;
}

}  // namespace xabsl
