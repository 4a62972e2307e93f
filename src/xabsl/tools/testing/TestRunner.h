#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"
#include "xabsl/tools/testing/TestFile.h"
#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The result of one test.
struct TestResult {
  std::string name;
  /// Errors in the file: names that do not exist, a trace that cannot be read.
  std::vector<Diagnostic> errors;
  std::optional<Diagnostic> failure;
  std::string moment;  ///< of a failure: the last cycle, as TracePrinter shows it
  Trace trace;         ///< all cycles
};

/// Runs one test of a file with a new engine.
TestResult runTest(const Behavior& behavior, const TestFile& file, const BehaviorTest& test);

/// The path of a file that the test file names, relative to the test file.
std::string besides(const TestFile& file, std::string_view path);

}  // namespace xabsl
