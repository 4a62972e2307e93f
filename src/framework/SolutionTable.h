#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "framework/Module.h"

namespace gt {
namespace detail {

template <typename A>
constexpr bool isOutput =
    std::is_lvalue_reference_v<A> && !std::is_const_v<std::remove_reference_t<A>> &&
    !std::is_same_v<A, Debug&> && !std::is_same_v<A, Random&>;

/// The parameters of update(), with each bundle replaced by its parts.
template <typename A>
struct PartsOf {
  using Type = std::tuple<A>;
};
template <Bundle A>
struct PartsOf<A> {
  using Type = typename A::Parts;
};
template <typename... A>
auto flattened(std::type_identity<std::tuple<A...>>)
    -> std::type_identity<decltype(std::tuple_cat(std::declval<typename PartsOf<A>::Type>()...))>;

/// Do not compile if the outputs of a solution differ from those of its task; the compiler's next
/// lines name the solution and the output.
template <typename Solution, typename Output, bool provided>
struct OutputOfTask {
  static_assert(provided, "a solution must provide every output of its task: this one is missing");
  static constexpr bool value = provided;
};
template <typename Solution, typename Output, bool wanted>
struct OutputOfSolution {
  static_assert(wanted, "a solution provides outputs of its task only: this one is none");
  static constexpr bool value = wanted;
};

template <typename M, typename... A, typename... O>
constexpr bool checkOutputs(std::type_identity<std::tuple<A...>>,
                            std::type_identity<std::tuple<O...>>) {
  constexpr auto isProvided = []<typename T>(std::type_identity<T>) {
    return (std::is_same_v<A, T&> || ...);
  };
  constexpr auto isWanted = []<typename T>(std::type_identity<T>) {
    return !isOutput<T> || (std::is_same_v<T, O&> || ...);
  };
  return (OutputOfTask<M, O, isProvided(std::type_identity<O>{})>::value && ...) &&
         (OutputOfSolution<M, A, isWanted(std::type_identity<A>{})>::value && ...);
}

}  // namespace detail

/// A solution of a task (report E.6).
struct Solution {
  std::string name;
  std::vector<Port> ports;
  std::function<std::unique_ptr<AnyModule>(ModuleContext)> make;
  bool added = false;  ///< Whether `SolutionTable::add` added it at run time.
};

/// A task of the robot's information processing, which modules solve (report 2.2.1).
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
    using Arguments =
        decltype(detail::flattened(std::type_identity<typename detail::Ports<M>::Arguments>{}));
    static_assert(detail::checkOutputs<M>(Arguments{}, std::type_identity<typename T::Outputs>{}));
    addTask<T>().solutions.push_back(
        {std::move(solution), ModuleAdapter<M>::ports(), [](ModuleContext context) {
           return std::make_unique<ModuleAdapter<M>>(std::move(context));
         }});
  }

  /// Adds a solution at run time, or replaces one of the same name that was added at run time.
  /// Returns an error if there is no such task, the name is used by another solution, or the
  /// outputs are not those of the task.
  Result<void> add(std::string_view task, Solution solution);

  /// Adds a task; it has no solution if another program solves it.
  template <typename T>
  Task& addTask() {
    Task& task = tasks_[std::string{typeName<T>()}];
    task.name = typeName<T>();
    task.outputs = outputsOf(std::type_identity<typename T::Outputs>{});
    return task;
  }

  const Task* find(std::string_view name) const {
    const auto task = tasks_.find(name);
    return task == tasks_.end() ? nullptr : &task->second;
  }
  const std::map<std::string, Task, std::less<>>& tasks() const { return tasks_; }

 private:
  template <typename... O>
  static std::vector<const RepresentationType*> outputsOf(std::type_identity<std::tuple<O...>>) {
    return {&representation<O>()...};
  }
  std::map<std::string, Task, std::less<>> tasks_;
};

}  // namespace gt
