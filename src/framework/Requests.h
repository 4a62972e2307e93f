#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "debug/DebugKey.h"
#include "streams/Reflection.h"

namespace gt {

/// Asks a robot's processes to solve a task by another solution (report E.6).
struct SolutionRequest {
  std::string task;
  std::string solution;

  static constexpr auto fields() {
    return Fields{field("task", &SolutionRequest::task),
                  field("solution", &SolutionRequest::solution, "", "or disabled")};
  }
};
static_assert(complete<SolutionRequest>);

/// Sets the state of a debug key in all processes (report E.3).
struct DebugRequest {
  std::string key;
  DebugKeyMode mode = DebugKeyMode::disabled;
  std::int64_t n = 0;

  static constexpr auto fields() {
    return Fields{field("key", &DebugRequest::key), field("mode", &DebugRequest::mode),
                  field("n", &DebugRequest::n, "", "times, or ms")};
  }
};
static_assert(complete<DebugRequest>);

/// Asks for a representation to be sent after cycles of the process that provides or receives it:
/// as often as a debug key of that state would be (report E.3).
struct WatchRequest {
  std::string representation;
  std::string process;
  DebugKeyMode mode = DebugKeyMode::always;
  std::int64_t n = 0;

  static constexpr auto fields() {
    return Fields{field("representation", &WatchRequest::representation),
                  field("process", &WatchRequest::process, "", "empty: whichever provides it"),
                  field("mode", &WatchRequest::mode),
                  field("n", &WatchRequest::n, "", "times, or ms")};
  }
};
static_assert(complete<WatchRequest>);

/// Regroups a robot's modules to the processes of another layout while it runs.
struct LayoutRequest {
  std::string name;
  std::string text;

  static constexpr auto fields() {
    return Fields{field("name", &LayoutRequest::name, "", "for messages: the file"),
                  field("text", &LayoutRequest::text, "", "as in a layout file")};
  }
};
static_assert(complete<LayoutRequest>);

/// Asks all processes to describe themselves (`ProcessDescription`).
struct DescriptionRequest {
  std::string about;

  static constexpr auto fields() {
    return Fields{
        field("about", &DescriptionRequest::about, "", "a process; all of them if empty")};
  }
};
static_assert(complete<DescriptionRequest>);

/// Sets one parameter of a solution.
struct ParameterRequest {
  std::string task;
  std::string solution;
  std::string path;
  std::string value;

  static constexpr auto fields() {
    return Fields{field("task", &ParameterRequest::task),
                  field("solution", &ParameterRequest::solution),
                  field("path", &ParameterRequest::path), field("value", &ParameterRequest::value)};
  }
};
static_assert(complete<ParameterRequest>);

}  // namespace gt
