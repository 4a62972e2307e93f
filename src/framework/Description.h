#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "debug/Stopwatch.h"
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
        field("low", &ParameterDescription::low, "", "of its range; any value if not below high"),
        field("high", &ParameterDescription::high)};
  }
};

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

/// Where a process has a representation from.
enum class RepresentationOrigin { provided, received, platform, configuration };

/// A representation of a process.
struct RepresentationDescription {
  std::string name;
  RepresentationOrigin origin = RepresentationOrigin::provided;
  bool streamed = false;
  std::uint32_t schema = 0;

  static constexpr auto fields() {
    using R = RepresentationDescription;
    return Fields{
        field("name", &R::name),
        field("origin", &R::origin, "",
              "a module of the process, another process, the platform, or from the start"),
        field("streamed", &R::streamed, "", "whether it can be watched and set"),
        field("schema", &R::schema, "", "id of the schema that its messages have")};
  }
};

/// All that a tool can ask a process for: its tasks in the order in which they run, with solutions
/// and parameters (the module graph follows from it), its representations, and its debug keys. The
/// answer to a DescriptionRequest.
struct ProcessDescription {
  std::string process;
  std::vector<TaskDescription> tasks;
  std::vector<RepresentationDescription> representations;
  std::vector<std::string> debugKeys;

  static constexpr auto fields() {
    return Fields{field("process", &ProcessDescription::process),
                  field("tasks", &ProcessDescription::tasks),
                  field("representations", &ProcessDescription::representations),
                  field("debugKeys", &ProcessDescription::debugKeys)};
  }
};

/// How long the modules of a process took since it started, by the machine's own clock (report
/// E.7). Two of them tell what was between. Sent to who watches it; see WatchRequest.
struct ModuleTimes {
  std::string process;
  std::vector<Stopwatch> modules;

  static constexpr auto fields() {
    return Fields{field("process", &ModuleTimes::process),
                  field("modules", &ModuleTimes::modules, "", "in the order in which they run")};
  }
};

}  // namespace gt
