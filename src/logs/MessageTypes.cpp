#include "logs/MessageTypes.h"

#include <algorithm>

#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/QueueFill.h"
#include "framework/Requests.h"
#include "logs/RecordedSetup.h"
#include "representations/RepresentationTypes.h"

namespace gt {

const std::vector<const RepresentationType*>& messageTypes() {
  static const std::vector<const RepresentationType*> list = [] {
    const auto representations = representationTypes();
    std::vector<const RepresentationType*> types{representations.begin(), representations.end()};
    types.insert(types.end(), {&representation<DebugRequest>(),
                               &representation<DescriptionRequest>(),
                               &representation<Drawing>(),
                               &representation<DroppedMessages>(),
                               &representation<GenericDebugData>(),
                               &representation<HsiColors>(),
                               &representation<LayoutRequest>(),
                               &representation<ModuleTimes>(),
                               &representation<ParameterRequest>(),
                               &representation<Plot>(),
                               &representation<ProcessDescription>(),
                               &representation<QueueFillRequest>(),
                               &representation<RecordedSetup>(),
                               &representation<RequestAnswer>(),
                               &representation<SetupRequest>(),
                               &representation<SolutionRequest>(),
                               &representation<StopwatchTime>(),
                               &representation<Text>(),
                               &representation<TslColors>(),
                               &representation<ValueRequest>(),
                               &representation<WatchRequest>()});
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
