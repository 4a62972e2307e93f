#include "robot/Solutions.h"

#include <type_traits>

#include "logs/MessageTypes.h"
#include "modules/behavior/Tasks.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/Tasks.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/motion/JointDataSequence.h"

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
  // Those that tools know, too, and what the modules add.
  std::vector<const RepresentationType*> types = gt::messageTypes();
  const auto add = [&](const std::vector<const RepresentationType*>& more) {
    types.insert(types.end(), more.begin(), more.end());
  };
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
