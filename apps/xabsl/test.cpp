#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Commands.h"
#include "xabsl/formats/Sources.h"
#include "xabsl/tools/testing/TestFile.h"
#include "xabsl/tools/testing/TestRunner.h"
#include "xabsl/tools/trace/Coverage.h"
#include "xabsl/tools/trace/TraceFile.h"

namespace xabsl::app {

namespace {

struct Options {
  std::vector<std::string> files;
  std::string only;
  std::string trace;
  bool coverage = false;
  bool verbose = false;
};

/// A behavior that is tested, and what its tests covered.
struct Tested {
  std::optional<Behavior> behavior;
  std::optional<TraceSubject> subject;
  std::optional<Coverage> coverage;
};

/// Runs files of tests one after another.
class Tests {
 public:
  explicit Tests(const Options& options) : options_(options) {}

  void run(const std::string& path) {
    std::string text;
    if (const auto failure = readFile(path, text))
      return wrong({{Diagnostic::Severity::error, path, 0, 0, *failure}});
    std::vector<Diagnostic> diagnostics;
    const TestFile file = parseTests(path, text, diagnostics);
    if (hasErrors(diagnostics)) return wrong(diagnostics);
    Tested& tested = load(besides(file, file.behavior.text));
    if (!tested.behavior) return;
    for (const BehaviorTest& test : file.tests)
      if (test.name.find(options_.only) != std::string::npos)
        take(tested, runTest(*tested.behavior, file, test));
  }

  /// Prints the sums; ends the program where something is wrong.
  void conclude() const {
    if (!options_.trace.empty()) writeFile(options_.trace, traces_);
    if (options_.coverage)
      for (const auto& [path, tested] : tested_)
        if (tested.coverage) std::cout << tested.coverage->report();
    std::cout << passed_ << " tests passed, " << failed_ << " failed\n";
    if (wrong_) throw Failure{};
    if (failed_ > 0) throw Failure{1};
  }

 private:
  void wrong(const std::vector<Diagnostic>& diagnostics) {
    print(diagnostics);
    wrong_ = true;
  }

  Tested& load(const std::string& path) {
    const auto [place, isNew] = tested_.try_emplace(path);
    if (!isNew) return place->second;
    Compilation compilation = app::load(path);
    if (!compilation.behavior) wrong(compilation.diagnostics);
    place->second.behavior = std::move(compilation.behavior);
    return place->second;
  }

  void take(Tested& tested, TestResult result) {
    if (!result.errors.empty()) return wrong(result.errors);
    if (result.failure) {
      ++failed_;
      result.failure->message = result.name + ": " + result.failure->message;
      print({*result.failure});
      std::cerr << result.moment;
    } else {
      ++passed_;
    }
    if (options_.verbose)
      std::cout << (result.failure ? "failed  " : "passed  ") << result.name << '\n';
    if (!options_.trace.empty())
      traces_ += toText(result.trace.subject) + toText(result.trace.events);
    if (!options_.coverage) return;
    if (!tested.coverage) {
      tested.subject.emplace(std::move(result.trace.subject));
      tested.coverage.emplace(*tested.subject);
    }
    tested.coverage->add(result.trace.events);
  }

  const Options& options_;
  std::map<std::string, Tested> tested_;
  std::string traces_;
  int passed_ = 0;
  int failed_ = 0;
  bool wrong_ = false;
};

}  // namespace

void addTest(CLI::App& program) {
  CLI::App* command = program.add_subcommand("test", "Test what behaviors do");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "Files of tests (.xtest)")->required();
  command->add_option("--only", options->only, "Only tests with this in their names");
  command->add_option("--trace", options->trace, "A file for all that was done, for xabsl trace");
  command->add_flag("--coverage", options->coverage,
                    "Tell which states and transitions no test covers");
  command->add_flag("-v,--verbose", options->verbose, "Tell the tests that passed, too");
  command->callback([options] {
    Tests tests(*options);
    for (const std::string& file : options->files) tests.run(file);
    tests.conclude();
  });
}

}  // namespace xabsl::app
