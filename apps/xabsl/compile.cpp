#include <memory>
#include <string>

#include "Commands.h"
#include "xabsl/formats/IntermediateCode.h"
#include "xabsl/language/Behavior.h"

namespace xabsl::app {

namespace {

struct Options {
  std::string agents;
  std::string output;
  std::string symbols;
  Dialect dialect = Dialect::xabsl31;
};

void compileTo(const Options& options) {
  const Compilation compilation = load(options.agents, options.dialect);
  print(compilation.diagnostics);
  if (!compilation.behavior) throw Failure{};
  const Model& model = compilation.behavior->model();
  const IntermediateCode code = writeIntermediateCode(model, options.dialect);
  print(code.diagnostics);
  if (!code.text) throw Failure{};
  writeFile(options.output, *code.text);
  if (!options.symbols.empty()) writeFile(options.symbols, writeDebugSymbols(model));
}

}  // namespace

void addCompile(CLI::App& program) {
  CLI::App* command = program.add_subcommand("compile", "Write a behavior as intermediate code");
  auto options = std::make_shared<Options>();
  command->add_option("agents", options->agents, "The .xabsl file that declares the agents")
      ->required();
  command->add_option("-o,--output", options->output, "The file with the intermediate code")
      ->required();
  addDialect(*command, options->dialect);
  command->add_option("--symbols", options->symbols, "A file for the debug symbols");
  command->callback([options] { compileTo(*options); });
}

}  // namespace xabsl::app
