#include "robot/Solutions.h"

#include "modules/behavior/Tasks.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/Tasks.h"

namespace gt {
namespace {

template <typename... T>
void addTasks(SolutionTable& table, std::tuple<T...>*) {
  (table.addTask<T>(), ...);
}

}  // namespace

SolutionTable tasks() {
  SolutionTable table;
  addTasks(table, static_cast<PerceptionTasks*>(nullptr));
  addTasks(table, static_cast<ModelingTasks*>(nullptr));
  addTasks(table, static_cast<BehaviorTasks*>(nullptr));
  addTasks(table, static_cast<MotionTasks*>(nullptr));
  return table;
}

}  // namespace gt
