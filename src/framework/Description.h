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
    return Fields{field<&ParameterDescription::path>(),
                  field<&ParameterDescription::value>(),
                  field<&ParameterDescription::unit>(),
                  field<&ParameterDescription::doc>(),
                  field<&ParameterDescription::low>(
                      "least value; any value is allowed if low is not below high"),
                  field<&ParameterDescription::high>()};
  }
};

/// A solution of a task.
struct SolutionDescription {
  std::string name;
  std::vector<std::string> inputs;
  std::vector<ParameterDescription> parameters;

  static constexpr auto fields() {
    return Fields{field<&SolutionDescription::name>(),
                  field<&SolutionDescription::inputs>("representations it reads"),
                  field<&SolutionDescription::parameters>()};
  }
};

/// A task of a process: who can solve it, and who does.
struct TaskDescription {
  std::string name, active;
  std::vector<std::string> outputs;
  std::vector<SolutionDescription> solutions;

  static constexpr auto fields() {
    return Fields{field<&TaskDescription::name>(),
                  field<&TaskDescription::active>("the solution that runs, or disabled"),
                  field<&TaskDescription::outputs>("representations it provides"),
                  field<&TaskDescription::solutions>()};
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
    return Fields{field<&R::name>(),
                  field<&R::origin>(
                      "a module of the process, another process, the platform, or from the start"),
                  field<&R::streamed>("whether it can be watched and set"),
                  field<&R::schema>("id of the schema that its messages have")};
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
    return Fields{field<&ProcessDescription::process>(), field<&ProcessDescription::tasks>(),
                  field<&ProcessDescription::representations>(),
                  field<&ProcessDescription::debugKeys>()};
  }
};

/// How long the modules of a process took since it started, by the machine's own clock (report
/// E.7). Two of them tell what was between. Sent to who watches it; see WatchRequest.
struct ModuleTimes {
  std::string process;
  std::vector<Stopwatch> modules;

  static constexpr auto fields() {
    return Fields{field<&ModuleTimes::process>(),
                  field<&ModuleTimes::modules>("in the order in which they run")};
  }
};

}  // namespace gt
