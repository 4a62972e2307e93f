#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"
#include "xabsl/tools/testing/TestFile.h"
#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// What came of one test.
struct TestResult {
  std::string name;
  /// What the file demands wrongly: names that do not exist, a trace that cannot be read.
  std::vector<Diagnostic> errors;
  std::optional<Diagnostic> failure;
  std::string moment;  ///< of a failure: the last cycle, as TracePrinter shows it
  Trace trace;         ///< all cycles
};

/// Runs one test of a file with an engine of its own.
TestResult runTest(const Behavior& behavior, const TestFile& file, const BehaviorTest& test);

/// Where the file's behavior is, or another file that it names.
std::string besides(const TestFile& file, std::string_view path);

}  // namespace xabsl
