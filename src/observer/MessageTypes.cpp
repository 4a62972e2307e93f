#include "observer/MessageTypes.h"

#include <algorithm>

#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/Requests.h"
#include "observer/RecordedSetup.h"
#include "representations/RepresentationTypes.h"

namespace gt {

const std::vector<const RepresentationType*>& messageTypes() {
  static const std::vector<const RepresentationType*> list = [] {
    const auto representations = representationTypes();
    std::vector<const RepresentationType*> types{representations.begin(), representations.end()};
    types.insert(types.end(),
                 {&representation<HsiColors>(), &representation<TslColors>(),
                  &representation<Text>(), &representation<Drawing>(), &representation<Plot>(),
                  &representation<StopwatchTime>(), &representation<DroppedMessages>(),
                  &representation<ProcessDescription>(), &representation<RequestAnswer>(),
                  &representation<ModuleTimes>(), &representation<RecordedSetup>()});
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
