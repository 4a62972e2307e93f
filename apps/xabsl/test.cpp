#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Commands.h"
#include "Team.h"
#include "xabsl/language/SourceFiles.h"
#include "xabsl/tools/testing/TestFile.h"
#include "xabsl/tools/testing/TestRunner.h"
#include "xabsl/tools/trace/Coverage.h"
#include "xabsl/tools/trace/TraceFile.h"

namespace xabsl::app {

namespace {

struct TestOptions {
  std::vector<std::string> files;
  std::string only;
  std::string team;
  std::string trace;
  bool coverage = false;
  bool strict = false;
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
  Tests(const TestOptions& options, const Team& team) : options_(options), team_(team) {}

  void run(const std::string& path) {
    std::string text;
    if (const auto failure = readFile(path, text))
      return refuse({{Diagnostic::Severity::error, path, 0, 0, *failure}});
    std::vector<Diagnostic> diagnostics;
    const TestFile file = parseTests(path, text, diagnostics);
    if (fails(diagnostics)) return refuse(diagnostics);
    Tested& tested = load(besides(file, file.behavior.text));
    for (const BehaviorTest& test : file.tests) {
      if (test.name.find(options_.only) == std::string::npos) continue;
      if (tested.behavior)
        take(tested, runTest(*tested.behavior, file, test));
      else
        ++notRun_;
    }
  }

  /// Prints the counts and returns the exit status.
  int conclude() {
    if (!options_.trace.empty() && !writeFile(options_.trace, traces_)) refused_ = true;
    if (options_.coverage)
      for (const auto& [path, tested] : tested_)
        if (tested.coverage) std::cout << tested.coverage->report();
    std::cout << passed_ << " tests passed, " << failed_ << " failed";
    if (notRun_ > 0) std::cout << ", " << notRun_ << " could not run";
    std::cout << '\n';
    return refused_ ? wrong : failed_ > 0 ? failed : succeeded;
  }

 private:
  void refuse(const std::vector<Diagnostic>& diagnostics) {
    print(diagnostics);
    refused_ = true;
  }

  /// Warnings of the behavior count if they are errors.
  Tested& load(const std::string& path) {
    const auto [place, isNew] = tested_.try_emplace(path);
    if (!isNew) return place->second;
    Compilation compilation = team_.compile(path);
    if (fails(compilation.diagnostics, options_.strict))
      refuse(compilation.diagnostics);
    else
      place->second.behavior = std::move(compilation.behavior);
    return place->second;
  }

  void take(Tested& tested, TestResult result) {
    if (!result.errors.empty()) {
      ++notRun_;
      return refuse(result.errors);
    }
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

  const TestOptions& options_;
  const Team& team_;
  std::map<std::string, Tested> tested_;
  std::string traces_;
  int passed_ = 0;
  int failed_ = 0;
  int notRun_ = 0;
  bool refused_ = false;
};

}  // namespace

void addTest(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("test", "Test what behaviors do");
  auto options = std::make_shared<TestOptions>();
  command->add_option("files", options->files, "Files of tests (.xtest)")->required();
  addTeam(*command, options->team);
  command->add_option("--only", options->only, "Only tests with this in their names");
  command->add_option("--trace", options->trace, "A file for all that was done, for xabsl trace");
  command->add_flag("--coverage", options->coverage,
                    "List the states and transitions that no test covers");
  addStrict(*command, options->strict);
  command->add_flag("-v,--verbose", options->verbose, "List the tests that passed, too");
  command->callback([options, &status] {
    const std::optional<Team> team = openTeam(options->team);
    if (!team) {
      status = wrong;
      return;
    }
    Tests tests(*options, *team);
    for (const std::string& file : options->files) tests.run(file);
    status = tests.conclude();
  });
}

}  // namespace xabsl::app
