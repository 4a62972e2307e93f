#include "robot/Solutions.h"

#include <type_traits>

#include "modules/behavior/Tasks.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/Tasks.h"

namespace gt {
namespace {

template <typename... T>
void addTasks(SolutionTable& table, std::type_identity<std::tuple<T...>>) {
  (table.addTask<T>(), ...);
}

}  // namespace

SolutionTable tasks() {
  SolutionTable table;
  addTasks(table, std::type_identity<PerceptionTasks>{});
  addTasks(table, std::type_identity<ModelingTasks>{});
  addTasks(table, std::type_identity<BehaviorTasks>{});
  addTasks(table, std::type_identity<MotionTasks>{});
  return table;
}

}  // namespace gt
