#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "debug/DebugKey.h"
#include "debug/Drawing.h"
#include "streams/MessageQueue.h"

/// Requests of tools to a robot, sent as messages. They cover everything that can be read from and
/// changed in a robot. Requests are sent to the Debug process, which passes them to all processes.
/// Each process executes the requests that concern it at the beginning of its next cycle, and
/// answers.
///
/// | wanted | message | comes back |
/// | --- | --- | --- |
/// | processes, tasks, solutions, parameters, keys | DescriptionRequest | ProcessDescription |
/// | a representation, once or again and again | WatchRequest | the representation |
/// | how long modules take | WatchRequest of ModuleTimes | ModuleTimes |
/// | drawings, plots | DebugRequest | Drawing, Plot |
/// | another solution, a parameter | SolutionRequest, ParameterRequest, GenericDebugData | |
/// | a field of a representation or of the configuration, set or held | ValueRequest | |
/// | a whole representation or piece of configuration set (ColorTable64, TslColors, ...) | itself | |
/// | another layout, another behavior | LayoutRequest, BehaviorRequest | |
/// | how the queue to the tools is filled | QueueFillRequest | |
/// | the files from which the robot was made | SetupRequest | RecordedSetup |
///
/// Besides, each process answers each request by a RequestAnswer. The requests that each part
/// executes are listed in `ModuleProcess::Requests`, `DebugProcess::Requests` and
/// `Robot::Requests`; that of a BehaviorRequest, in the ConfigurationPart of the behavior. Robot,
/// Debug process and other processes execute theirs in this order.
namespace gt {

/// The result of a request in a process.
enum class RequestOutcome { done, notConcerned, refused };

/// The answer of a process to a message of the tools. Requests are always answered, representations
/// only if they are refused. A request that concerned no process had no effect (`concernsNobody`).
struct RequestAnswer {
  std::uint32_t request = 0;
  Time asked;
  std::string process;
  RequestOutcome outcome = RequestOutcome::done;
  std::string what;
  std::uint32_t of = 1;

  static constexpr auto fields() {
    return Fields{field<&RequestAnswer::request>("message id of the request"),
                  field<&RequestAnswer::asked>(Unit::ms, "time stamp of the request"),
                  field<&RequestAnswer::process>(),
                  field<&RequestAnswer::outcome>(),
                  field<&RequestAnswer::what>("why the request was refused"),
                  field<&RequestAnswer::of>("number of answers that the request gets")};
  }
};

/// Makes the answer to a request that was executed or refused.
RequestAnswer answerTo(const Message& request, std::string process, const Result<void>& done);
/// Makes the answer of a process that a request does not concern.
RequestAnswer notConcerned(const Message& request, std::string process);

/// Asks a robot's processes to switch a task to another solution (report E.6).
struct SolutionRequest {
  std::string task;
  std::string solution;

  static constexpr auto fields() {
    return Fields{field<&SolutionRequest::task>(),
                  field<&SolutionRequest::solution>("name of the solution, or disabled")};
  }
};

/// Sets the state of a debug key in all processes that know it (report E.3).
struct DebugRequest {
  std::string key;
  DebugKeyMode mode = DebugKeyMode::disabled;
  std::int64_t n = 0;

  static constexpr auto fields() {
    return Fields{field<&DebugRequest::key>(), field<&DebugRequest::mode>(),
                  field<&DebugRequest::n>("number of the mode: times, or ms")};
  }
};

/// Asks for a representation to be sent after cycles of a process that provides, receives or knows
/// it. The rate is given by the state of a debug key (report E.3). With mode `times` and n = 1 it
/// is sent once.
///
/// Without a process the request reaches exactly one in an ordinary robot: the process that
/// provides the representation. What the platform sends (Image, SensorDataBuffer) comes from the
/// process that begins its cycles with it, otherwise from the first one of the layout that receives
/// it; configuration (ColorTable64, RobotCalibration) from the first process of the layout. All
/// processes send their ModuleTimes.
struct WatchRequest {
  std::string representation;
  std::string process;
  DebugKeyMode mode = DebugKeyMode::always;
  std::int64_t n = 0;

  static constexpr auto fields() {
    return Fields{field<&WatchRequest::representation>(),
                  field<&WatchRequest::process>(
                      "name of the process; empty: the one that provides the representation"),
                  field<&WatchRequest::mode>(),
                  field<&WatchRequest::n>("number of the mode: times, or ms")};
  }
};

enum class ValueMode {
  set,     ///< Once, at the beginning of a cycle.
  hold,    ///< Set again whenever it may have changed, until released.
  release  ///< Ends holding; the empty path releases all fields of a representation.
};

/// Sets a field of a representation in a running robot. It is set where the representation enters
/// the robot, and reaches the other processes from there: in the process that provides it, or in
/// all that receive it from the platform; configuration is set in all processes. A value that was
/// set lasts until the module that provides it or the platform says otherwise: of configuration
/// forever, of a disabled task until it is enabled. A value that is held is seen by all who run
/// after its provider.
struct ValueRequest {
  std::string representation;
  std::string path;
  std::string value;
  ValueMode mode = ValueMode::set;

  static constexpr auto fields() {
    return Fields{
        field<&ValueRequest::representation>(),
        field<&ValueRequest::path>("path of the field, such as translation.x"),
        field<&ValueRequest::value>("new value, as in a config file; not read by release"),
        field<&ValueRequest::mode>()};
  }
};

/// Redistributes a robot's modules to the processes of another layout while it is running.
struct LayoutRequest {
  std::string name;
  std::string text;

  static constexpr auto fields() {
    return Fields{field<&LayoutRequest::name>("name of the layout file, for messages"),
                  field<&LayoutRequest::text>("content of the layout file")};
  }
};

/// Asks processes to describe themselves (`ProcessDescription`).
struct DescriptionRequest {
  std::string about;

  static constexpr auto fields() {
    return Fields{
        field<&DescriptionRequest::about>("name of the process or task to describe; empty: all")};
  }
};

/// Sets one parameter of a solution.
struct ParameterRequest {
  std::string task;
  std::string solution;
  std::string path;
  std::string value;

  static constexpr auto fields() {
    return Fields{field<&ParameterRequest::task>(),
                  field<&ParameterRequest::solution>("name of the solution; empty: the active one"),
                  field<&ParameterRequest::path>(), field<&ParameterRequest::value>()};
  }
};

/// The error of a request that no process of a robot is concerned with.
Error concernsNobody(const SolutionRequest& request);
Error concernsNobody(const DebugRequest& request);
Error concernsNobody(const WatchRequest& request);
Error concernsNobody(const ValueRequest& request);
Error concernsNobody(const ParameterRequest& request);
Error concernsNobody(const DescriptionRequest& request);
Error concernsNobody(const GenericDebugData& data);

}  // namespace gt
