#include "observer/MessageTypes.h"

#include <algorithm>

#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/Requests.h"
#include "observer/RecordedSetup.h"
#include "representations/All.h"

namespace gt {
namespace {

template <typename... T>
struct TypeList {
  static std::vector<const RepresentationType*> all() { return {&representation<T>()...}; }
};

}  // namespace

const std::vector<const RepresentationType*>& messageTypes() {
  static const std::vector<const RepresentationType*> list = [] {
    auto types = AllRepresentations<TypeList>::all();
    for (const auto* type :
         TypeList<HsiColors, TslColors, Text, Drawing, Plot, StopwatchTime, DroppedMessages,
                  ProcessDescription, RequestAnswer, ModuleTimes, RecordedSetup>::all())
      types.push_back(type);
    return types;
  }();
  return list;
}

const RepresentationType* messageType(std::uint32_t id) {
  static const std::vector<const RepresentationType*> sorted = [] {
    auto types = messageTypes();
    std::ranges::sort(types, {}, &RepresentationType::id);
    return types;
  }();
  const auto found = std::ranges::lower_bound(sorted, id, {}, &RepresentationType::id);
  return found == sorted.end() || (*found)->id != id ? nullptr : *found;
}

const RepresentationType* messageType(std::string_view name) {
  const auto& types = messageTypes();
  const auto found = std::ranges::find(types, name, &RepresentationType::name);
  return found == types.end() ? nullptr : *found;
}

}  // namespace gt
