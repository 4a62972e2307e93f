#include <cstdlib>
#include <string>

#include "Fuzz.h"
#include "xabsl/tools/trace/Coverage.h"
#include "xabsl/tools/trace/Moment.h"
#include "xabsl/tools/trace/Question.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

/// A trace that was read can be printed and asked, and is the same when it was written and read
/// again.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace xabsl;
  for (const Trace& trace : readTraces("fuzz.trace", gt::textOf(data, size)).traces) {
    Moment moment(trace.subject);
    Question::Making making =
        Question::make(moment, "time > 3", {ValueKind::boolean, -1}, "fuzz", {0, 1, 1});
    const TraceEvent* before = nullptr;
    std::size_t printed = 0;
    forEachCycle(trace.events, [&](const TraceEvent* first, const TraceEvent* last) {
      moment.take(first, last);
      if (making.question) making.question->answer();
      printed += printCycle(trace.subject, first, last, isEventful(first, last, before)).size();
      before = first;
    });
    Coverage coverage(trace.subject);
    coverage.add(trace.events);
    if (coverage.report().empty()) std::abort();
    const std::string text = toText(trace.subject) + toText(trace.events);
    const TraceReading again = readTraces("fuzz.trace", text);
    if (again.traces.size() != 1 ||
        toText(again.traces[0].subject) + toText(again.traces[0].events) != text)
      std::abort();
  }
  return 0;
}
