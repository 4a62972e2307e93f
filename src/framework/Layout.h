#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "framework/SolutionTable.h"

namespace gt {

/// One process of a layout and the tasks that it solves.
struct ProcessLayout {
  /// Tasks that run together. The groups of a process run in the order of the file.
  struct Group {
    std::string trigger;             ///< If not empty, the group only runs in cycles in which this
                                     ///< representation is new.
    std::vector<std::string> tasks;  ///< In the order of the file.
    std::vector<int> taskLines;
    int line = 0;
  };
  std::string name;
  std::string trigger;            ///< The representation whose arrival starts a cycle.
  bool collectsMessages = false;  ///< Whether it is the Debug process, which passes message queues
                                  ///< on and runs no modules.
  std::vector<Group> groups;
  int line = 0;
};

/// Assigns modules to processes, as defined by a layout file (report 2.2.3):
///
///     process Cognition on Image
///       SensorDataProcessor
///       ImageProcessor
///     process Motion on SensorDataBuffer
///       WalkingEngine
///     process Debug on messages
///
/// A process begins a cycle when the representation after `on` arrives from the platform or from
/// another process. A line `on REPRESENTATION` inside a process begins a group of tasks that run
/// only in cycles in which that representation is new. A line `on cycle` begins a group of tasks
/// that run in each cycle. Thus one process can run at two rates. `//` and `#` begin comments.
struct Layout {
  std::string file;
  std::vector<ProcessLayout> processes;
};

Result<Layout> parseLayout(std::string_view text, const std::string& file);
Result<Layout> loadLayout(const std::string& file);

/// A representation that is sent from one process to another; the sender is empty for the platform.
struct Connection {
  const RepresentationType* type;
  std::string from;
  std::string to;
  bool blocking;
};

/// The order of the tasks in each process and the connections between processes. Computed from a
/// layout and the signatures of all modules.
struct Plan {
  /// A task in the order of execution; the trigger is null if it runs in each cycle.
  struct Step {
    const Task* task;
    const RepresentationType* trigger;
  };
  struct Process {
    ProcessLayout layout;
    std::vector<Step> order;
    std::vector<const RepresentationType*> platform;  ///< Representations that the platform sends
                                                      ///< to it.
    /// Representations that only another platform sends: solutions that read them cannot be
    /// selected.
    std::vector<const RepresentationType*> missing;
    /// Representations that it sends to tools that name no process; see WatchRequest.
    std::vector<const RepresentationType*> answersFor;
  };
  std::string file;  ///< Path of the layout file.
  std::vector<Process> processes;
  std::vector<Connection> connections;

  /// Whether a process provides, receives or knows a representation of that name.
  bool has(std::string_view representation) const;
};

/// Works out the plan, for all solutions of each task so that they can be switched at run time.
/// Inside a group the signatures give the order; what an earlier group reads of a later one is of
/// the last cycle, as between processes. `platform` names what the platform sends, `given` what
/// lies on every blackboard from the start. A task's default has all that it reads; another
/// solution of the table may read what no task provides and this platform does not send: then it
/// cannot be chosen. Errors: unknown tasks or triggers, a task listed twice, a missing provider,
/// two providers, a circle, something that crosses but cannot be streamed, two representations of
/// one name.
Result<Plan> makePlan(const Layout& layout, const SolutionTable& table,
                      const std::vector<const RepresentationType*>& platform,
                      const std::vector<const RepresentationType*>& given);

}  // namespace gt
