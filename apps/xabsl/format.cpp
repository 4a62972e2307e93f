#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Commands.h"
#include "xabsl/formats/Formatter.h"

namespace xabsl::app {

namespace {

struct Options {
  std::vector<std::string> files;
  bool check = false;
  bool inPlace = false;
};

[[noreturn]] void fail(const std::string& path, const char* what) {
  std::cerr << path << ": error: " << what << '\n';
  throw Failure{};
}

/// True if the file was formatted already.
bool formatFile(const std::string& path, const Options& options) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) fail(path, "cannot read the file");
  Reporter reporter;
  const std::optional<std::string> formatted = format(reporter.addFile(path, text), text, reporter);
  print(reporter.take());
  if (!formatted) throw Failure{};
  const bool same = *formatted == text;
  if (options.check) {
    if (!same) std::cerr << path << ": is not formatted\n";
  } else if (!options.inPlace) {
    std::cout << *formatted;
  } else if (!same) {
    std::ofstream out(path, std::ios::binary);
    out << *formatted;
    out.close();
    if (!out) fail(path, "cannot write the file");
  }
  return same;
}

}  // namespace

void addFormat(CLI::App& program) {
  CLI::App* command = program.add_subcommand("format", "Indent behaviors, keep comments and lines");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "Files in XABSL 3.1")->required();
  auto* check = command->add_flag("--check", options->check, "Only tell what is not formatted");
  command->add_flag("-i", options->inPlace, "Change the files")->excludes(check);
  command->callback([options] {
    bool same = true;
    for (const std::string& path : options->files) same = formatFile(path, *options) && same;
    if (options->check && !same) throw Failure{1};
  });
}

}  // namespace xabsl::app
