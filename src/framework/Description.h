#pragma once
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// A parameter of a solution as a tool lists and edits it.
struct ParameterDescription {
  std::string path, value, unit, doc;
  double low = 0, high = 0;

  static constexpr auto fields() {
    return Fields{
        field("path", &ParameterDescription::path),
        field("value", &ParameterDescription::value),
        field("unit", &ParameterDescription::unit),
        field("doc", &ParameterDescription::doc),
        field("low", &ParameterDescription::low, "", "of its range; none if not below high"),
        field("high", &ParameterDescription::high)};
  }
};
static_assert(complete<ParameterDescription>);

/// A solution of a task.
struct SolutionDescription {
  std::string name;
  std::vector<std::string> inputs;
  std::vector<ParameterDescription> parameters;

  static constexpr auto fields() {
    return Fields{field("name", &SolutionDescription::name),
                  field("inputs", &SolutionDescription::inputs, "", "representations it reads"),
                  field("parameters", &SolutionDescription::parameters)};
  }
};
static_assert(complete<SolutionDescription>);

/// A task of a process: who can solve it, and who does.
struct TaskDescription {
  std::string name, active;
  std::vector<std::string> outputs;
  std::vector<SolutionDescription> solutions;

  static constexpr auto fields() {
    return Fields{
        field("name", &TaskDescription::name),
        field("active", &TaskDescription::active, "", "the solution that runs, or disabled"),
        field("outputs", &TaskDescription::outputs, "", "representations it provides"),
        field("solutions", &TaskDescription::solutions)};
  }
};
static_assert(complete<TaskDescription>);

/// All that a tool can ask a process for: its tasks in the order in which they run, with solutions
/// and parameters (the module graph follows from it), and its debug keys. The answer to a
/// DescriptionRequest.
struct ProcessDescription {
  std::string process;
  std::vector<TaskDescription> tasks;
  std::vector<std::string> debugKeys;

  static constexpr auto fields() {
    return Fields{field("process", &ProcessDescription::process),
                  field("tasks", &ProcessDescription::tasks),
                  field("debugKeys", &ProcessDescription::debugKeys)};
  }
};
static_assert(complete<ProcessDescription>);

}  // namespace gt
