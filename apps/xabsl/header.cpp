#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "Commands.h"
#include "xabsl/formats/intermediate/SymbolsHeader.h"
#include "xabsl/language/SourceFiles.h"

namespace xabsl::app {

namespace {

struct HeaderOptions {
  std::string agents;
  std::string output;
  std::string dependencies;
  std::vector<std::string> enumerations, registered;
  SymbolsHeaderSettings settings;
  Reading reading;
};

bool fail(const std::string& message) {
  printError("xabsl header", message);
  return false;
}

bool isCppName(std::string_view name) {
  const auto mayBeIn = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (name.starts_with("::")) name.remove_prefix(2);
  for (;;) {
    const auto end = std::find_if_not(name.begin(), name.end(), mayBeIn);
    if (end == name.begin() || std::isdigit(static_cast<unsigned char>(name.front()))) return false;
    name.remove_prefix(static_cast<std::size_t>(end - name.begin()));
    if (name.empty()) return true;
    if (!name.starts_with("::")) return false;
    name.remove_prefix(2);
  }
}

/// `name=Type` of the command line; the behavior must have the enumeration.
bool bindEnumerations(const Model& model, const std::vector<std::string>& entries,
                      HeaderOptions& options) {
  for (const std::string& entry : entries) {
    const std::size_t sign = entry.find('=');
    const std::string name = entry.substr(0, sign);
    const std::string type = sign == std::string::npos ? "" : entry.substr(sign + 1);
    if (!isCppName(type)) return fail(inQuotes(entry) + " is not NAME=TYPE");
    if (std::none_of(model.enumerations.begin(), model.enumerations.end(),
                     [&](const Enumeration& known) { return known.name == name; }))
      return fail("the behavior has no enumeration " + inQuotes(name));
    options.settings.enumerations[name] = type;
    if (&entries == &options.registered) options.settings.registered.insert(name);
  }
  return true;
}

/// The rule of make that lists which files the header depends on.
std::string dependencies(const HeaderOptions& options, const Model& model) {
  const auto escaped = [](const std::string& path) {
    std::string text;
    for (const char c : path) text += c == ' ' || c == '#' ? std::string{'\\', c} : std::string{c};
    return text;
  };
  std::string text = escaped(options.output) + ":";
  for (const std::string& file : model.files)
    text += " \\\n  " + escaped(std::filesystem::absolute(file).lexically_normal().string());
  return text + "\n";
}

/// Writes the header unless the file is just that: what includes it would be compiled again.
bool update(const std::string& path, const std::string& text) {
  std::string present;
  return (!readFile(path, present) && present == text) || writeFile(path, text);
}

bool writeHeader(HeaderOptions& options) {
  if (!isCppName(options.settings.space))
    return fail(inQuotes(options.settings.space) + " is no namespace of C++");
  const std::optional<Behavior> behavior = load(options.agents, options.reading);
  if (!behavior) return false;
  const Model& model = behavior->model();
  if (!bindEnumerations(model, options.enumerations, options) ||
      !bindEnumerations(model, options.registered, options))
    return false;
  std::error_code ignored;  // writing the file fails, too
  std::filesystem::create_directories(std::filesystem::path(options.output).parent_path(), ignored);
  return update(options.output, writeSymbolsHeader(model, options.settings)) &&
         (options.dependencies.empty() ||
          writeFile(options.dependencies, dependencies(options, model)));
}

}  // namespace

void addHeader(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand(
      "header", "Write a C++ header with the symbols and basic behaviors to be implemented");
  auto options = std::make_shared<HeaderOptions>();
  command->add_option("agents", options->agents, "The file that declares the agents")->required();
  command->add_option("-o,--output", options->output, "The header")->required();
  command->add_option("--namespace", options->settings.space, "The C++ namespace")
      ->capture_default_str();
  command->add_option("--enumeration", options->enumerations,
                      "NAME=TYPE: a C++ type that stands for an enumeration");
  command->add_option("--registered", options->registered,
                      "NAME=TYPE: the same, but the program registers the elements itself");
  command->add_option("--include", options->settings.includes, "A header with such types");
  command->add_option("--depfile", options->dependencies,
                      "A file for the sources of the behavior, as a rule of make");
  addStrict(*command, options->reading.strict);
  command->callback([options, &status] { status = writeHeader(*options) ? succeeded : wrong; });
}

}  // namespace xabsl::app
