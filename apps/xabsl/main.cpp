#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "xabsl/Behavior.h"

namespace {

constexpr int badInput = 2;

/// Compiles a behavior and prints what there is to say about it.
int check(const std::string& path) {
  const xabsl::Compilation compilation = xabsl::compile(path);
  for (const xabsl::Diagnostic& diagnostic : compilation.diagnostics)
    std::cerr << toString(diagnostic) << '\n';
  if (!compilation.behavior) return badInput;
  const xabsl::Model& model = compilation.behavior->model();
  std::cout << path << ": " << model.agents.size() << " agents, " << model.options.size()
            << " options, " << model.states.size() << " states, " << model.symbols.size()
            << " symbols, " << model.behaviors.size() << " basic behaviors\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Works on behaviors written in XABSL");
  app.require_subcommand(1);

  std::string path;
  CLI::App* checkCommand = app.add_subcommand("check", "Tell the errors in a behavior");
  checkCommand->add_option("agents", path, "The .xabsl file that declares the agents")->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : badInput;
  }
  return check(path);
}
