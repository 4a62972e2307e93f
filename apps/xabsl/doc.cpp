#include <iostream>
#include <memory>
#include <string>

#include "Commands.h"
#include "xabsl/language/Behavior.h"
#include "xabsl/tools/documentation/Documentation.h"

namespace xabsl::app {

void addDoc(CLI::App& program) {
  CLI::App* command = program.add_subcommand("doc", "Write pages with charts about a behavior");
  auto agents = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  command
      ->add_option("agents", *agents,
                   "The file that declares the agents, or intermediate code (.dat)")
      ->required();
  command->add_option("-o,--output", *folder, "The folder for the pages")->required();
  command->callback([agents, folder] {
    const Compilation compilation = load(*agents);
    print(compilation.diagnostics);
    if (!compilation.behavior) throw Failure{};
    if (const auto failure = writeDocumentation(compilation.behavior->model(), *folder)) {
      print({*failure});
      throw Failure{};
    }
    std::cout << *folder << "/index.html\n";
  });
}

}  // namespace xabsl::app
