#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The result of reading a file of traces; if there are no traces, the diagnostics have the errors.
struct TraceReading {
  std::vector<Trace> traces;
  std::vector<Diagnostic> diagnostics;
};

// A trace is text, line by line. What a line is about stands in its first word, names and texts
// that may contain blanks stand last. First the subject, whose lists count from 0:
//
//     xabsl trace 1
//     file PATH
//     enumeration NAME           then its elements:   element VALUE NAME
//     symbol KIND TYPE NAME      KIND: input output internal; TYPE: float bool, or the index of an
//                                enumeration; then its parameters:   parameter TYPE NAME
//     behavior NAME              then its parameters
//     option FILE LINE TREE NAME           then its parameters and states:
//     state FILE LINE KIND TREE NAME       KIND: normal initial target both
//     decision FILE LINE TREE TREE CONDITION     where it leads to if the condition holds, if not
//     read TYPE SYMBOL TEXT      an expression; SYMBOL is -1 if it is not that of a symbol
//     none                       an expression that the trace says nothing about
//
// A TREE is `stay`, `none`, or the index of a decision `d3` or a state `s3`; that of an option is
// its common decision tree. Behind the word `cycles` stand the events, index and value with a
// letter in front:
//
//     c TIME                     a cycle begins, time in ms
//     o OPTION DEPTH             an option is called; until its state follows it decides:
//     p PARAMETER VALUE            argument of the function that is read next
//     r EXPRESSION VALUE           what was read
//     d DECISION 0|1               whether its condition held
//     g STATE STATE                the transition from one to another
//     s STATE TIME               its state, and for how long
//     t OPTION TIME              for how long the option has been active
//     v PARAMETER VALUE          its parameters, those of a basic behavior
//     b BEHAVIOR DEPTH           a basic behavior is called
//     = SYMBOL VALUE             an output or internal symbol is set
//
// Behind the events another trace may follow. A last line without an end is not read: so what was
// written before a crash is readable.

/// The letters of the events, in the order of TraceEvent::Kind.
constexpr std::string_view traceLetters = "corpdgstbv=";

/// The text of a subject, up to the word `cycles`.
std::string toText(const TraceSubject& subject);
/// The text of events, to be appended to that of their subject.
std::string toText(const std::vector<TraceEvent>& events);

/// Reads traces from a text. `name` is used in messages.
TraceReading readTraces(const std::string& name, std::string_view text);
/// Appends the events of a text to a trace that was read. Returns the first error, if there is one;
/// the events before it are appended.
std::optional<Diagnostic> readMore(Trace& trace, const std::string& name, std::string_view text);
/// Reads traces from a file of at most 128 MiB.
TraceReading loadTraces(const std::string& path);

}  // namespace xabsl
