#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "xabsl/formats/Compile.h"
#include "xabsl/language/Diagnostic.h"

namespace xabsl::test {

/// The messages, one a line, without warnings.
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

/// Compiles one file that must be sound.
inline Behavior compiled(const std::string& text) {
  Compilation compilation = compile("main.xabsl", {{"main.xabsl", text}});
  EXPECT_EQ(errors(compilation.diagnostics), "");
  if (!compilation.behavior) throw std::runtime_error("the behavior does not compile");
  return *compilation.behavior;
}

}  // namespace xabsl::test
