#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"

/// The subcommands of the program xabsl. Each adds itself to the program, says what it does with
/// `--help`, and runs when it is called; it throws a Failure where it cannot go on.
namespace xabsl::app {

/// Ends the program with a status. What is wrong has been printed.
struct Failure {
  int status = 2;
};

/// Prints messages to the standard error, with the lines they are about.
void print(const std::vector<Diagnostic>& diagnostics);

/// Compiles the file with the agents, or reads intermediate code from a file `.dat` or `.ic`.
Compilation load(const std::string& path, Dialect dialect = Dialect::xabsl31);

/// Adds `--dialect` to a command.
void addDialect(CLI::App& command, Dialect& dialect);

/// Writes a file, or tells that it cannot.
void writeFile(const std::string& path, const std::string& text);

void addCheck(CLI::App& program);
void addCompile(CLI::App& program);
void addConvert(CLI::App& program);
void addDoc(CLI::App& program);
void addFormat(CLI::App& program);
void addHeader(CLI::App& program);
void addLsp(CLI::App& program);
void addTest(CLI::App& program);
void addTrace(CLI::App& program);

}  // namespace xabsl::app
