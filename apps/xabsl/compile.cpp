#include <memory>
#include <string>

#include "Commands.h"
#include "xabsl/formats/intermediate/IntermediateCode.h"

namespace xabsl::app {

namespace {

struct CompileOptions {
  std::string agents;
  std::string output;
  std::string symbols;
  Reading reading;
};

bool compileTo(const CompileOptions& options) {
  const std::optional<Behavior> behavior = load(options.agents, options.reading);
  if (!behavior) return false;
  const Model& model = behavior->model();
  const IntermediateCode code = writeIntermediateCode(model, options.reading.dialect);
  return print(code.diagnostics) && writeFile(options.output, *code.text) &&
         (options.symbols.empty() || writeFile(options.symbols, writeDebugSymbols(model)));
}

}  // namespace

void addCompile(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("compile", "Write a behavior as intermediate code");
  auto options = std::make_shared<CompileOptions>();
  command->add_option("agents", options->agents, "The .xabsl file that declares the agents")
      ->required();
  command->add_option("-o,--output", options->output, "The file with the intermediate code")
      ->required();
  addDialect(*command, options->reading.dialect);
  addStrict(*command, options->reading.strict);
  command->add_option("--symbols", options->symbols, "A file for the debug symbols");
  command->callback([options, &status] { status = compileTo(*options) ? succeeded : wrong; });
}

}  // namespace xabsl::app
