#include <algorithm>
#include <iostream>
#include <limits>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "Commands.h"
#include "xabsl/tools/trace/Coverage.h"
#include "xabsl/tools/trace/Moment.h"
#include "xabsl/tools/trace/Question.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace xabsl::app {

namespace {

struct TraceOptions {
  std::string file;
  std::string first;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool all = false;
  bool coverage = false;
};

void printTrace(const Trace& trace, const TraceOptions& options) {
  const TraceEvent* before = nullptr;
  forEachCycle(trace.events, [&](const TraceEvent* first, const TraceEvent* last) {
    const bool wanted = first->value >= options.from && first->value <= options.to;
    if (wanted && (options.all || isEventful(first, last, before)))
      std::cout << printCycle(trace.subject, first, last, options.all);
    before = first;
  });
}

/// Traces of the same behavior count together.
void printCoverage(const std::vector<Trace>& traces) {
  std::list<std::pair<std::string, Coverage>> covered;
  for (const Trace& trace : traces) {
    const std::string subject = toText(trace.subject);
    auto found = std::find_if(covered.begin(), covered.end(),
                              [&](const auto& entry) { return entry.first == subject; });
    if (found == covered.end()) found = covered.emplace(found, subject, Coverage(trace.subject));
    found->second.add(trace.events);
  }
  for (const auto& [subject, coverage] : covered) std::cout << coverage.report();
}

/// Prints the first cycle for which the condition holds. Returns `failed` if there is none.
int printFirst(const Trace& trace, const TraceOptions& options) {
  Moment moment(trace.subject);
  Question::Making making =
      Question::make(moment, options.first, {ValueKind::boolean, -1}, "condition", {0, 1, 1});
  print(making.diagnostics);
  if (!making.question) return wrong;
  bool found = false;
  forEachCycle(trace.events, [&](const TraceEvent* first, const TraceEvent* last) {
    if (found) return;
    moment.take(first, last);
    if (first->value < options.from || first->value > options.to) return;
    if (making.question->answer().value_or(0) == 0) return;
    std::cout << printCycle(trace.subject, first, last, true);
    found = true;
  });
  return found ? succeeded : failed;
}

int show(const TraceOptions& options) {
  const TraceReading reading = loadTraces(options.file);
  print(reading.diagnostics);
  if (reading.traces.empty()) return wrong;
  if (options.coverage) {
    printCoverage(reading.traces);
    return succeeded;
  }
  for (const Trace& trace : reading.traces) {
    if (!options.first.empty()) {
      if (const int status = printFirst(trace, options); status != failed) return status;
      continue;
    }
    if (reading.traces.size() > 1)
      std::cout << "trace " << &trace - reading.traces.data() + 1 << " of " << reading.traces.size()
                << '\n';
    printTrace(trace, options);
  }
  if (options.first.empty()) return succeeded;
  std::cerr << options.file << ": this never holds: " << options.first << '\n';
  return failed;
}

}  // namespace

void addTrace(CLI::App& program, int& status) {
  CLI::App* command =
      program.add_subcommand("trace", "Show from a recorded trace what a behavior did and why");
  auto options = std::make_shared<TraceOptions>();
  command->add_option("file", options->file, "The trace")->required();
  auto* first = command->add_option(
      "--first", options->first,
      "Print the first cycle in which a condition holds: 'ball.distance < 200', 'OPTION == STATE', "
      "'OPTION.previous == STATE', 'OPTION.active', 'BASIC_BEHAVIOR'");
  auto* coverage = command->add_flag("--coverage", options->coverage,
                                     "List the states and transitions that never occurred");
  command->add_option("--from", options->from, "From this time, in ms");
  command->add_option("--to", options->to, "Up to this time, in ms");
  command->add_flag("--all", options->all,
                    "Print all cycles, conditions and outputs, not only where something changed");
  first->excludes(coverage);
  command->callback([options, &status] { status = show(*options); });
}

}  // namespace xabsl::app
