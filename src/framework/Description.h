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

/// A solution of a task, as described to tools.
struct SolutionDescription {
  std::string name;
  std::vector<std::string> inputs;
  std::vector<ParameterDescription> parameters;

  static constexpr auto fields() {
    return Fields{
        field<&SolutionDescription::name>(),
        field<&SolutionDescription::inputs>("names of the representations that the solution reads"),
        field<&SolutionDescription::parameters>()};
  }
};

/// A task of a process with its solutions and the active one.
struct TaskDescription {
  std::string name, active;
  std::vector<std::string> outputs;
  std::vector<SolutionDescription> solutions;

  static constexpr auto fields() {
    return Fields{
        field<&TaskDescription::name>(),
        field<&TaskDescription::active>("name of the active solution, or disabled"),
        field<&TaskDescription::outputs>("names of the representations that the task provides"),
        field<&TaskDescription::solutions>()};
  }
};

/// Where a process obtains a representation from.
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
        field<&R::name>(),
        field<&R::origin>(
            "source: a module of the process, another process, the platform, or the configuration"),
        field<&R::streamed>("whether the representation can be watched and set"),
        field<&R::schema>("id of the schema that its messages have")};
  }
};

/// The description of a process for tools: its tasks in the order of execution, with solutions and
/// parameters (which determine the module graph), its representations, and its debug keys. The
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

/// The execution times of the modules of a process since it started, by the machine's own clock
/// (report E.7). The difference of two messages is the time between them. Sent to tools on request;
/// see WatchRequest.
struct ModuleTimes {
  std::string process;
  std::vector<Stopwatch> modules;

  static constexpr auto fields() {
    return Fields{field<&ModuleTimes::process>(),
                  field<&ModuleTimes::modules>("execution times in the order of execution")};
  }
};

}  // namespace gt
