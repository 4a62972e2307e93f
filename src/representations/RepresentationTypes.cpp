#include "representations/RepresentationTypes.h"

#include <array>
#include <vector>

#include "framework/RepresentationDefinition.h"
#include "representations/All.h"

namespace gt {

using RepresentationFunction = const RepresentationType& (*)();

template <typename... T>
struct FunctionList {
  static constexpr std::array<RepresentationFunction, sizeof...(T)> all{&representation<T>...};
};

/// Visible from outside, so that the compiler keeps each of the functions: other units call them.
extern const decltype(AllRepresentations<FunctionList>::all) representationFunctions;
decltype(representationFunctions) representationFunctions = AllRepresentations<FunctionList>::all;

std::span<const RepresentationType* const> representationTypes() {
  static const std::vector<const RepresentationType*> types = [] {
    std::vector<const RepresentationType*> list;
    for (const RepresentationFunction function : representationFunctions)
      list.push_back(&function());
    return list;
  }();
  return types;
}

}  // namespace gt
