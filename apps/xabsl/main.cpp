#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "Commands.h"
#include "xabsl/formats/IntermediateCode.h"

int main(int argc, char** argv) {
  CLI::App program("Works on behaviors written in XABSL");
  program.require_subcommand(1);
  xabsl::app::addCheck(program);
  xabsl::app::addCompile(program);
  xabsl::app::addConvert(program);
  xabsl::app::addDoc(program);
  xabsl::app::addFormat(program);
  xabsl::app::addHeader(program);
  xabsl::app::addLsp(program);
  xabsl::app::addTest(program);
  xabsl::app::addTrace(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : xabsl::app::Failure{}.status;
  } catch (const xabsl::app::Failure& failure) {
    return failure.status;
  }
  return 0;
}

xabsl::Compilation xabsl::app::load(const std::string& path, Dialect dialect) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".dat" || extension == ".ic" ? loadIntermediateCode(path)
                                                   : compile(path, dialect);
}

void xabsl::app::addDialect(CLI::App& command, Dialect& dialect) {
  const std::map<std::string, Dialect> dialects = {{"3.0", Dialect::xabsl30},
                                                   {"3.1", Dialect::xabsl31}};
  command.add_option("--dialect", dialect, "The version of XABSL: 3.0 or 3.1 (the default)")
      ->transform(CLI::CheckedTransformer(dialects));
}

void xabsl::app::print(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    std::cerr << toStringWithSource(diagnostic) << '\n';
}

void xabsl::app::writeFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return;
  std::cerr << path << ": error: cannot write the file\n";
  throw Failure{};
}
