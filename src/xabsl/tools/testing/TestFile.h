#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"

namespace xabsl {

// A file of tests for a behavior; comments as in XABSL.
//
//     behavior "../agents.xabsl";               the behavior, relative to this file
//     step 40;                                  ms from one cycle to the next; 40 if not given
//     function angle_to(x, y) = x + y;          what an input symbol with parameters returns;
//                                               min, max, abs, sqrt, sin, cos and atan2 of
//                                               numbers are known
//     ball.angle = 0.5;                         an input symbol; computed before each cycle
//
//     test "turns to the ball" {
//       agent player;                           selects an agent
//       option go_to_ball(speed = 200);         or what is executed instead of its root option
//       ball.seen = true;
//       run 400;                                executes cycles for so many ms; `run;`: one cycle
//       run 400 while walk.turn > 0;            and the condition must hold after each of them
//       until go_to_ball == kick within 2000;   executes at least one cycle, until it holds
//       expect kick && kick.id == push_strong;
//       replay "match.trace" from 1000 to 5000 while !kick;
//     }                                         cycles with the inputs that were recorded
//
// What stands before the first test holds for each of them. Expressions are those of XABSL, with
// the names that Question.h lists; they are about the last cycle. Time begins with 0 in each test.

/// A part of the file, for messages.
struct TestText {
  std::string_view text;
  Location location;
};

struct TestStatement {
  enum class Kind { step, agent, option, function, input, run, until, expect, replay };

  Kind kind = Kind::run;
  Location location;
  TestText name;                    ///< of an agent, option, function, symbol or file
  std::vector<TestText> arguments;  ///< names of a function's parameters or an option's arguments
  std::vector<TestText> values;     ///< of an option's arguments
  TestText expression;              ///< empty: none
  double time = 0;                  ///< ms: of a step, a run, at most, from
  double to = 0;                    ///< ms: of a replay
};

struct BehaviorTest {
  std::string name;
  Location location;
  std::vector<TestStatement> statements;
};

/// The content of a file of tests. All texts are views into the text of the file.
struct TestFile {
  std::string path;
  TestText behavior;
  std::vector<TestStatement> common;
  std::vector<BehaviorTest> tests;
};

/// Reads tests. Errors are appended to the diagnostics.
TestFile parseTests(const std::string& path, std::string_view text,
                    std::vector<Diagnostic>& diagnostics);

}  // namespace xabsl
