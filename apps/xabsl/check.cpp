#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Commands.h"
#include "xabsl/language/Behavior.h"

namespace xabsl::app {

namespace {

/// Compiles a behavior and prints what there is to say about it.
bool check(const std::string& path, Dialect dialect) {
  const Compilation compilation = load(path, dialect);
  print(compilation.diagnostics);
  if (!compilation.behavior) return false;
  const Model& model = compilation.behavior->model();
  std::cout << path << ": " << model.agents.size() << " agents, " << model.options.size()
            << " options, " << model.states.size() << " states, " << model.symbols.size()
            << " symbols, " << model.behaviors.size() << " basic behaviors\n";
  return true;
}

}  // namespace

void addCheck(CLI::App& program) {
  CLI::App* command = program.add_subcommand("check", "Tell the errors in behaviors");
  auto paths = std::make_shared<std::vector<std::string>>();
  command
      ->add_option("files", *paths,
                   "Files that declare the agents (.xabsl), or intermediate code (.dat)")
      ->required();
  auto dialect = std::make_shared<Dialect>(Dialect::xabsl31);
  addDialect(*command, *dialect);
  command->callback([paths, dialect] {
    bool sound = true;
    for (const std::string& path : *paths) sound = check(path, *dialect) && sound;
    if (!sound) throw Failure{};
  });
}

}  // namespace xabsl::app
