#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"

/// The subcommands of the program xabsl. Each one adds itself to the program and stores the exit
/// status of the program when it is called. Errors are printed before.
namespace xabsl::app {

/// Exit statuses: `failed` if a test failed or a condition never held, `wrong` after an error.
constexpr int succeeded = 0, failed = 1, wrong = 2;

/// Adds a command to the program; the command sets the exit status.
using AddCommand = void (*)(CLI::App& program, int& status);

/// The program with these commands. Returns its exit status.
int run(int argc, char** argv, std::initializer_list<AddCommand> commands);

/// How a behavior is read.
struct Reading {
  Dialect dialect = Dialect::xabsl31;  // of text
  bool strict = false;                 // warnings are errors
};

/// Adds `--dialect` and `--strict` to a command.
void addDialect(CLI::App& command, Dialect& dialect);
void addStrict(CLI::App& command, bool& strict);

/// Prints messages to the standard error, with the lines they are about. Returns false if one is an
/// error, or, if `strict`, a warning.
bool print(const std::vector<Diagnostic>& diagnostics, bool strict = false);

/// Prints an error about a file, or about the command line.
void printError(const std::string& about, const std::string& message);

/// Instead of a file's errors, if it is but a part of a behavior, has one that names the behavior.
void explainPart(const std::string& path, Compilation& compilation);

/// Compiles the file with the agents, or reads intermediate code from a file `.dat` or `.ic`.
Compilation compileFile(const std::string& path, Dialect dialect = Dialect::xabsl31);

/// The same, and prints the messages. Empty after an error.
std::optional<Behavior> load(const std::string& path, const Reading& reading = {});

/// Writes a file, whole or not at all. Prints an error and returns false if that is not possible.
bool writeFile(const std::string& path, const std::string& text);

void addCheck(CLI::App& program, int& status);
void addCompile(CLI::App& program, int& status);
void addConvert(CLI::App& program, int& status);
void addDoc(CLI::App& program, int& status);
void addFormat(CLI::App& program, int& status);
void addHeader(CLI::App& program, int& status);
void addLsp(CLI::App& program, int& status);
void addTest(CLI::App& program, int& status);
void addTrace(CLI::App& program, int& status);

}  // namespace xabsl::app
