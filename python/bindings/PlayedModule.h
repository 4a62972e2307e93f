#pragma once
#include <nanobind/nanobind.h>

#include <memory>
#include <string>
#include <vector>

#include "debug/Debug.h"
#include "framework/SolutionTable.h"

namespace gt::python {

/// One solution of a task by itself, with a blackboard of its own that holds the configuration.
class PlayedModule {
 public:
  PlayedModule(const std::string& task, const std::string& solution, std::uint64_t seed,
               const std::string& root);

  /// Sets inputs by name (fields that a dict does not name, and inputs that are not given, keep
  /// their values), runs `update`, and returns the outputs: one, or several as a tuple.
  nanobind::object update(const nanobind::kwargs& inputs);
  /// A parameter by its path.
  nanobind::object get(const std::string& path);
  void set(const std::string& path, nanobind::handle value);
  nanobind::dict parameters();
  const std::string& task() const { return task_->name; }
  const std::string& solution() const { return solution_->name; }

 private:
  /// Robots run modules that look at images only once they have one.
  void requireImage();
  ConstValue parameter(const std::string& path);

  const Task* task_;
  const Solution* solution_;
  Blackboard blackboard_;
  Debug debug_;
  std::unique_ptr<AnyModule> module_;
};

/// The name by which `update` takes an input: that of the representation, in lower case with
/// underscores.
std::string inputName(const RepresentationType& type);

}  // namespace gt::python
