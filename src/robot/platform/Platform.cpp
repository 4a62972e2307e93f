#include "robot/platform/Platform.h"

#include <algorithm>

#include "robot/platform/Body.h"

namespace gt {
namespace {

using Types = std::vector<const RepresentationType*>;

template <typename T>
using TypeSlot = std::type_identity<T>;

template <typename... T>
Types typesOf(std::tuple<std::type_identity<T>...>) {
  return {&representation<T>()...};
}

bool contains(const Types& types, const RepresentationType* type) {
  return std::ranges::find(types, type) != types.end();
}

}  // namespace

const Types& platformRepresentations() {
  static const Types list = typesOf(InputSlots<TypeSlot>{});
  return list;
}

Types representationsWithTruth() {
  Types list = platformRepresentations();
  list.push_back(&representation<OracledWorldState>());
  return list;
}

const Types& commandRepresentations() {
  static const Types list = typesOf(CommandSlots<TypeSlot>{});
  return list;
}

bool isCommand(const RepresentationType& type) {
  return contains(commandRepresentations(), &type);
}

std::string senderOf(const Plan& plan, const RepresentationType& type) {
  for (const Plan::Process& process : plan.processes)
    for (const Plan::Step& step : process.order)
      if (contains(step.task->outputs, &type)) return process.layout.name;
  if (&type != &representation<CameraSettings>()) return "";
  const auto picture = std::ranges::find_if(plan.connections, [](const Connection& connection) {
    return connection.from.empty() && connection.type == &representation<Image>();
  });
  return picture == plan.connections.end() ? "" : picture->to;
}

}  // namespace gt
