#include "xabsl/formats/Convert.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "Commands.h"

namespace xabsl::app {

namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  Form form = Form::xml21;  // of XML
  bool strict = false;
};

bool convertTo(const ConvertOptions& options) {
  const std::filesystem::path root(options.output);
  const bool toXml = root.extension() == ".xml";
  if (!toXml && root.extension() != ".xabsl") {
    printError(options.output, "expected a name that ends with .xml or .xabsl");
    return false;
  }
  const Conversion conversion =
      convert(options.input, toXml ? options.form : Form::text31, root.filename().string());
  if (!print(conversion.diagnostics, options.strict)) return false;
  return std::all_of(conversion.files->begin(), conversion.files->end(), [&](const auto& file) {
    const std::filesystem::path target = root.parent_path() / file.first;
    std::error_code ignored;  // writing the file fails, too
    std::filesystem::create_directories(target.parent_path(), ignored);
    return writeFile(target.string(), file.second);
  });
}

}  // namespace

void addConvert(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand(
      "convert", "Write a behavior in another form: XABSL 2.1 or 3.1 in XML, or XABSL 3.1 as text");
  auto options = std::make_shared<ConvertOptions>();
  command->add_option("agents", options->input, "The file that declares the agents")->required();
  command
      ->add_option("-o,--output", options->output,
                   "The new file with the agents; its ending `.xml` or `.xabsl` selects the form. "
                   "The other files are written beside it")
      ->required();
  const std::map<std::string, Form> dialects = {{"2.1", Form::xml21}, {"3.1", Form::xml31}};
  command
      ->add_option("--dialect", options->form,
                   "The version of XABSL in XML: 2.1 (the default) or 3.1")
      ->transform(CLI::CheckedTransformer(dialects));
  addStrict(*command, options->strict);
  command->callback([options, &status] { status = convertTo(*options) ? succeeded : wrong; });
}

}  // namespace xabsl::app
