#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Commands.h"
#include "Team.h"
#include "xabsl/language/Warnings.h"

namespace xabsl::app {

namespace {

struct CheckOptions {
  std::vector<std::string> paths;
  std::string team;
  Reading reading;
  bool unused = false;
};

/// Prints the errors and warnings of a behavior and counts what is in it.
bool check(const std::string& path, const Team& team, const CheckOptions& options) {
  const Compilation compilation = team.compile(path, options.reading.dialect);
  if (!print(compilation.diagnostics, options.reading.strict)) return false;
  const Model& model = compilation.behavior->model();
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
  command->add_option("files", options->paths,
                      "Files that declare the agents (.xabsl), or intermediate code (.dat)");
  addTeam(*command, options->team);
  addDialect(*command, options->reading.dialect);
  addStrict(*command, options->reading.strict);
  command->add_flag("--unused", options->unused, "List each unused declaration with its place");
  command->callback([options, &status] {
    const std::optional<Team> team = openTeam(options->team);
    if (!team) {
      status = wrong;
      return;
    }
    if (options->paths.empty()) {
      if (options->team.empty()) throw CLI::RequiredError("files");
      options->paths.push_back(team->agents());
    }
    for (const std::string& path : options->paths)
      if (!check(path, *team, *options)) status = wrong;
  });
}

}  // namespace xabsl::app
