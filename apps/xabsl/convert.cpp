#include "xabsl/formats/Convert.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "Commands.h"

namespace xabsl::app {

void addConvert(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "convert", "Write a behavior in another form: XABSL 2.1 or 3.1 in XML, or XABSL 3.1 as text");
  auto input = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  command->add_option("agents", *input, "The file that declares the agents")->required();
  command
      ->add_option(
          "-o,--output", *output,
          "The new file with the agents; `.xml` or `.xabsl` says in which form. The others "
          "are written beside it")
      ->required();
  auto form = std::make_shared<Form>(Form::xml21);
  const std::map<std::string, Form> dialects = {{"2.1", Form::xml21}, {"3.1", Form::xml31}};
  command->add_option("--dialect", *form, "The version of XABSL in XML: 2.1 (the default) or 3.1")
      ->transform(CLI::CheckedTransformer(dialects));
  command->callback([input, output, form] {
    const std::filesystem::path root(*output);
    const bool toXml = root.extension() == ".xml";
    if (!toXml && root.extension() != ".xabsl") {
      std::cerr << *output << ": error: expected a name that ends with .xml or .xabsl\n";
      throw Failure{};
    }
    const Conversion conversion =
        convert(*input, toXml ? *form : Form::text31, root.filename().string());
    print(conversion.diagnostics);
    if (!conversion.files) throw Failure{};
    for (const auto& [path, text] : *conversion.files) {
      const std::filesystem::path target = root.parent_path() / path;
      std::error_code ignored;  // writing tells
      std::filesystem::create_directories(target.parent_path(), ignored);
      writeFile(target.string(), text);
    }
  });
}

}  // namespace xabsl::app
