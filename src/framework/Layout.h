#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "framework/SolutionTable.h"

namespace gt {

/// One process of a layout and the tasks that it solves.
struct ProcessLayout {
  std::string name;
  std::string trigger;            ///< The representation whose arrival starts a cycle.
  bool collectsMessages = false;  ///< The Debug process: passes message queues on, runs no modules.
  std::vector<std::string> tasks;  ///< In the order of the file.
  int line = 0;
  std::vector<int> taskLines;
};

/// Which process runs which modules, as a layout file says it (report 2.2.3):
///
///     process Cognition on Image
///       SensorDataProcessor
///       ImageProcessor
///     process Debug on messages
///
/// `//` and `#` begin comments.
struct Layout {
  std::string file;
  std::vector<ProcessLayout> processes;
};

Result<Layout> parseLayout(std::string_view text, const std::string& file);
Result<Layout> loadLayout(const std::string& file);

/// A representation that crosses from one process to another; the sender is empty for the platform.
struct Connection {
  const RepresentationType* type;
  std::string from;
  std::string to;
  bool blocking;
};

/// What follows from a layout and the signatures of all modules: the order inside each process and
/// what crosses.
struct Plan {
  struct Process {
    ProcessLayout layout;
    std::vector<const Task*> order;
  };
  std::vector<Process> processes;
  std::vector<Connection> connections;
};

/// Works out the plan, for all solutions of each task so that they can be switched at run time.
/// `platform` names what the platform sends, `given` what lies on every blackboard from the start.
/// Errors: unknown tasks or triggers, a task listed twice, a missing provider, two providers, a
/// circle.
Result<Plan> makePlan(const Layout& layout, const SolutionTable& table,
                      const std::vector<const RepresentationType*>& platform,
                      const std::vector<const RepresentationType*>& given);

}  // namespace gt
