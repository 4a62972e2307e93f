#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Commands.h"
#include "xabsl/language/Warnings.h"

namespace xabsl::app {

namespace {

struct CheckOptions {
  std::vector<std::string> paths;
  Reading reading;
  bool unused = false;
};

/// Prints the errors and warnings of a behavior and counts what is in it.
bool check(const std::string& path, const CheckOptions& options) {
  const std::optional<Behavior> behavior = load(path, options.reading);
  if (!behavior) return false;
  const Model& model = behavior->model();
  if (options.unused) print(everythingUnused(model));
  std::cout << path << ": " << model.agents.size() << " agents, " << model.options.size()
            << " options, " << model.states.size() << " states, " << model.symbols.size()
            << " symbols, " << model.behaviors.size() << " basic behaviors\n";
  return true;
}

}  // namespace

void addCheck(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("check", "Print the errors and warnings of behaviors");
  auto options = std::make_shared<CheckOptions>();
  command
      ->add_option("files", options->paths,
                   "Files that declare the agents (.xabsl), or intermediate code (.dat)")
      ->required();
  addDialect(*command, options->reading.dialect);
  addStrict(*command, options->reading.strict);
  command->add_flag("--unused", options->unused, "List each unused declaration with its place");
  command->callback([options, &status] {
    for (const std::string& path : options->paths)
      if (!check(path, *options)) status = wrong;
  });
}

}  // namespace xabsl::app
