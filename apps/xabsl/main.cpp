#include <CLI/CLI.hpp>
#include <iostream>

#include "Commands.h"

int main(int argc, char** argv) {
  CLI::App program("Works on behaviors written in XABSL");
  program.require_subcommand(1);
  xabsl::app::addCheck(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : xabsl::app::Failure{}.status;
  } catch (const xabsl::app::Failure& failure) {
    return failure.status;
  }
  return 0;
}

void xabsl::app::print(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    std::cerr << toStringWithSource(diagnostic) << '\n';
}
