#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Commands.h"
#include "xabsl/formats/text/Formatter.h"
#include "xabsl/language/SourceFiles.h"

namespace xabsl::app {

namespace {

struct FormatOptions {
  std::vector<std::string> files;
  bool check = false;
  bool inPlace = false;
};

/// Formats or checks one file and returns the exit status.
int formatFile(const std::string& path, const FormatOptions& options) {
  std::string text;
  if (const auto failure = readFile(path, text)) {
    printError(path, *failure);
    return wrong;
  }
  Reporter reporter;
  const std::optional<std::string> formatted = format(reporter.addFile(path, text), text, reporter);
  if (!print(reporter.take())) return wrong;
  const bool same = *formatted == text;
  if (options.check) {
    if (!same) std::cerr << path << ": not formatted\n";
    return same ? succeeded : failed;
  }
  if (!options.inPlace)
    std::cout << *formatted;
  else if (!same && !writeFile(path, *formatted))
    return wrong;
  return succeeded;
}

}  // namespace

void addFormat(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("format", "Indent behaviors, keep comments and lines");
  auto options = std::make_shared<FormatOptions>();
  command->add_option("files", options->files, "Files in XABSL 3.1")->required();
  auto* check =
      command->add_flag("--check", options->check, "Only list files that are not formatted");
  command->add_flag("-i", options->inPlace, "Change the files")->excludes(check);
  command->callback([options, &status] {
    for (const std::string& path : options->files)
      status = std::max(status, formatFile(path, *options));
  });
}

}  // namespace xabsl::app
