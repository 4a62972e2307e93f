#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "xabsl/formats/Compile.h"
#include "xabsl/language/Diagnostic.h"

namespace xabsl::test {

/// The messages, one per line, without warnings.
inline std::string errors(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == Diagnostic::Severity::error) text += toString(diagnostic) + "\n";
  return text;
}

/// The errors in one file.
inline std::string errorsIn(const std::string& text) {
  return errors(compile("main.xabsl", {{"main.xabsl", text}}).diagnostics);
}

/// Compiles one file that must be free of errors.
inline Behavior compiled(const std::string& text) {
  Compilation compilation = compile("main.xabsl", {{"main.xabsl", text}});
  EXPECT_EQ(errors(compilation.diagnostics), "");
  if (!compilation.behavior) throw std::runtime_error("the behavior does not compile");
  return *compilation.behavior;
}

/// Declarations that behaviors of tests use.
inline const std::string agentsText = R"(namespace main("Symbols") {
enum mode { fast, slow };
float input ball.distance "mm";
bool input ball.seen;
enum mode input how;
float input scaled(float value; enum mode by;);
float output speed;
bool output led;
enum mode output head;
float internal memory;
float const near = 150 "mm";
}
namespace main("Behaviors") { behavior walk { float x; enum mode how; } behavior stop { } behavior both { } }
option both { initial state s { action { } } }
option sub { float @v; bool @b; initial state s { action { } } }
agent main("Main", main);
)";
constexpr int symbolLines = 16;

/// The errors in a file whose option `main` has one state with the given parts; lines are counted
/// from the beginning of the parts.
inline std::string errorsInMain(const std::string& text) {
  const std::string all = errorsIn(agentsText + text);
  std::string result;
  std::size_t position = 0;
  while (position < all.size()) {
    const std::size_t end = all.find('\n', position);
    const std::string line = all.substr(position, end - position);
    const std::size_t number = line.find(':') + 1;
    const std::size_t rest = line.find(':', number);
    result +=
        std::to_string(std::stoi(line.substr(number)) - symbolLines) + line.substr(rest) + "\n";
    position = end + 1;
  }
  return result;
}

inline std::string errorsInDecision(const std::string& decision) {
  return errorsInMain("option main { initial state s { decision {\n" + decision +
                      "\n} action { } } }");
}
inline std::string errorsInAction(const std::string& action) {
  return errorsInMain("option main { initial state s { action {\n" + action + "\n} } }");
}
inline std::string errorsInValue(const std::string& value) {
  return errorsInAction("speed = " + value + ";");
}

}  // namespace xabsl::test
