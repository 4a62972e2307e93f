#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/Module.h"

namespace gt {
namespace detail {

template <typename Task, typename M, typename Signature = decltype(&M::update)>
struct Provides;
template <typename Task, typename M, typename... A>
struct Provides<Task, M, void (M::*)(A...)> {
  template <typename T>
  static constexpr bool has = (std::is_same_v<A, T&> || ...);
  template <typename... O>
  static constexpr bool all(std::tuple<O...>*) {
    return (has<O> && ...) &&
           ((... + (std::is_lvalue_reference_v<A> && !std::is_const_v<std::remove_reference_t<A>> &&
                    !std::is_same_v<A, Debug&> && !std::is_same_v<A, Random&>)) == sizeof...(O));
  }
  static constexpr bool value = all(static_cast<typename Task::Outputs*>(nullptr));
};

}  // namespace detail

/// One way to solve a task (report E.6).
struct Solution {
  std::string name;
  std::vector<Port> ports;
  std::function<std::unique_ptr<AnyModule>(ModuleContext)> make;
};

/// One task of the robot's information processing, which modules solve (report 2.2.1).
struct Task {
  std::string name;
  std::vector<const RepresentationType*> outputs;
  std::vector<Solution> solutions;

  const Solution* find(std::string_view solution) const {
    for (const Solution& s : solutions)
      if (s.name == solution) return &s;
    return nullptr;
  }
};

/// All tasks and their solutions; the first solution of a task is its default. `disabled` is a
/// solution of every task.
class SolutionTable {
 public:
  static constexpr std::string_view disabled = "disabled";

  template <typename T, typename M>
  void add(std::string solution) {
    static_assert(detail::Provides<T, M>::value,
                  "a solution must provide the outputs of its task, all and no others");
    addTask<T>().solutions.push_back(
        {std::move(solution), ModuleAdapter<M>::ports(), [](ModuleContext context) {
           return std::make_unique<ModuleAdapter<M>>(std::move(context));
         }});
  }

  /// Makes a task known; without a solution if another program solves it.
  template <typename T>
  Task& addTask() {
    Task& task = tasks_[std::string{typeName<T>()}];
    task.name = typeName<T>();
    task.outputs = outputsOf(static_cast<typename T::Outputs*>(nullptr));
    return task;
  }

  const Task* find(std::string_view name) const {
    const auto task = tasks_.find(name);
    return task == tasks_.end() ? nullptr : &task->second;
  }
  const std::map<std::string, Task, std::less<>>& tasks() const { return tasks_; }

 private:
  template <typename... O>
  static std::vector<const RepresentationType*> outputsOf(std::tuple<O...>*) {
    return {&representation<O>()...};
  }
  std::map<std::string, Task, std::less<>> tasks_;
};

}  // namespace gt
