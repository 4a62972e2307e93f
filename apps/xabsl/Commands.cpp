#include "Commands.h"

#include <filesystem>
#include <iostream>
#include <map>

#include "base/File.h"
#include "base/Guarded.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/formats/Root.h"
#include "xabsl/formats/Sources.h"
#include "xabsl/formats/intermediate/IntermediateCode.h"

namespace xabsl::app {

int run(int argc, char** argv, std::initializer_list<AddCommand> commands) {
  CLI::App program("Works on behaviors written in XABSL");
  program.require_subcommand(1);
  int status = succeeded;
  for (const AddCommand add : commands) add(program, status);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? succeeded : wrong;
  } catch (const std::exception& exception) {
    std::cerr << "xabsl: " << gt::errorOf(exception).text() << '\n';
    return wrong;
  }
  return status;
}

void addDialect(CLI::App& command, Dialect& dialect) {
  const std::map<std::string, Dialect> dialects = {{"3.0", Dialect::xabsl30},
                                                   {"3.1", Dialect::xabsl31}};
  command.add_option("--dialect", dialect, "The version of XABSL: 3.0 or 3.1 (the default)")
      ->transform(CLI::CheckedTransformer(dialects));
}

void addStrict(CLI::App& command, bool& strict) {
  command.add_flag("--strict", strict, "Fail if there are warnings");
}

bool print(const std::vector<Diagnostic>& diagnostics, bool strict) {
  for (const Diagnostic& diagnostic : diagnostics)
    std::cerr << toStringWithSource(diagnostic) << '\n';
  return !fails(diagnostics, strict);
}

void printError(const std::string& about, const std::string& message) {
  print({{Diagnostic::Severity::error, about, 0, 0, message}});
}

namespace {

/// Whether a file and those that it includes declare no agent.
bool isPart(const std::string& path) {
  Reporter reporter;
  syntax::Program program;
  readSources(path, diskReader(), program, reporter);
  return !reporter.failed() && program.agents.empty();
}

/// The command that checks the behavior to which a file belongs; empty if it belongs to none.
std::string checkOfWhole(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path file = fs::absolute(path).lexically_normal();
  const std::string root = rootOf(file.generic_string(), diskLister(), diskReader());
  if (!root.empty())
    return "xabsl check " + fs::path(root).lexically_proximate(fs::current_path()).generic_string();
  // A team's folder holds what differs from the project's behavior.
  for (fs::path folder = file.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    const fs::path team = folder.parent_path();
    if (folder.filename() == "behavior" && team.parent_path().filename() == "teams")
      return "xabsl check --team " + team.filename().string();
  }
  return {};
}

}  // namespace

void explainPart(const std::string& path, Compilation& compilation) {
  if (compilation.behavior || !isPart(path)) return;
  if (const std::string command = checkOfWhole(path); !command.empty())
    compilation.diagnostics = {
        {Diagnostic::Severity::error, path, 0, 0,
         "has no agent, since it is a part of a behavior; to check that: " + command}};
}

Compilation compileFile(const std::string& path, Dialect dialect) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".dat" || extension == ".ic") return loadIntermediateCode(path);
  Compilation compilation = compile(path, dialect);
  explainPart(path, compilation);
  return compilation;
}

std::optional<Behavior> load(const std::string& path, const Reading& reading) {
  Compilation compilation = compileFile(path, reading.dialect);
  if (!print(compilation.diagnostics, reading.strict)) return std::nullopt;
  return std::move(compilation.behavior);
}

bool writeFile(const std::string& path, const std::string& text) {
  const auto done = gt::writeFile(path, text);
  if (!done) printError(path, done.error().what);
  return static_cast<bool>(done);
}

}  // namespace xabsl::app
