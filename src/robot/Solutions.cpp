#include "robot/Solutions.h"

#include <type_traits>

#include "colors/HsiColors.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/QueueFill.h"
#include "framework/Requests.h"
#include "modules/behavior/Tasks.h"
#include "modules/behavior/control/BehaviorControlRequest.h"
#include "modules/behavior/control/BehaviorRequest.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/Tasks.h"
#include "observer/RecordedSetup.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/BehaviorTrace.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/motion/JointDataSequence.h"
#include "robot/platform/Platform.h"

namespace gt {
namespace {

template <typename... T>
void addTasks(SolutionTable& table, std::type_identity<std::tuple<T...>>) {
  (table.addTask<T>(), ...);
}

}  // namespace

std::vector<const RepresentationType*> RobotModules::given() const {
  std::vector<const RepresentationType*> types{
      &representation<Player>(), &representation<FrameInfo>(),
      &representation<BehaviorControlRequest>(), &representation<JointDataSequence>()};
  for (const ConfigurationPart& part : parts) types.push_back(part.type);
  return types;
}

std::vector<const RepresentationType*> RobotModules::messageTypes() const {
  std::vector<const RepresentationType*> types{&representation<BehaviorRequest>(),
                                               &representation<BehaviorState>(),
                                               &representation<BehaviorTrace>(),
                                               &representation<DebugRequest>(),
                                               &representation<DescriptionRequest>(),
                                               &representation<Drawing>(),
                                               &representation<DroppedMessages>(),
                                               &representation<GenericDebugData>(),
                                               &representation<HsiColors>(),
                                               &representation<LayoutRequest>(),
                                               &representation<ModuleTimes>(),
                                               &representation<OracledWorldState>(),
                                               &representation<ParameterRequest>(),
                                               &representation<Plot>(),
                                               &representation<ProcessDescription>(),
                                               &representation<QueueFillRequest>(),
                                               &representation<RecordedSetup>(),
                                               &representation<RequestAnswer>(),
                                               &representation<SetupRequest>(),
                                               &representation<SolutionRequest>(),
                                               &representation<Text>(),
                                               &representation<ValueRequest>(),
                                               &representation<WatchRequest>()};
  const auto add = [&](const std::vector<const RepresentationType*>& more) {
    types.insert(types.end(), more.begin(), more.end());
  };
  add(platformRepresentations());
  add(commandRepresentations());
  add(given());
  for (const auto& [name, task] : solutions.tasks()) add(task.outputs);
  return types;
}

RobotModules tasks() {
  RobotModules modules{{}, commonParts()};
  addTasks(modules.solutions, std::type_identity<PerceptionTasks>{});
  addTasks(modules.solutions, std::type_identity<ModelingTasks>{});
  addTasks(modules.solutions, std::type_identity<BehaviorTasks>{});
  addTasks(modules.solutions, std::type_identity<MotionTasks>{});
  return modules;
}

}  // namespace gt
