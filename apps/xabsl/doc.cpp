#include <iostream>
#include <memory>
#include <string>

#include "Commands.h"
#include "xabsl/tools/documentation/Documentation.h"

namespace xabsl::app {

namespace {

struct DocOptions {
  std::string agents;
  std::string folder;
  Reading reading;
};

bool document(const DocOptions& options) {
  const std::optional<Behavior> behavior = load(options.agents, options.reading);
  if (!behavior) return false;
  if (const auto failure = writeDocumentation(behavior->model(), options.folder))
    return print({*failure});
  std::cout << options.folder << "/index.html\n";
  return true;
}

}  // namespace

void addDoc(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("doc", "Write pages with charts about a behavior");
  auto options = std::make_shared<DocOptions>();
  command
      ->add_option("agents", options->agents,
                   "The file that declares the agents, or intermediate code (.dat)")
      ->required();
  command->add_option("-o,--output", options->folder, "The folder for the pages")->required();
  addStrict(*command, options->reading.strict);
  command->callback([options, &status] { status = document(*options) ? succeeded : wrong; });
}

}  // namespace xabsl::app
