// Checks motion descriptions and lists them for XABSL (report 5.4).
#include <cstdio>
#include <string>

#include "commandline/CommandLine.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "motionnet/Compiler.h"
#include "motionnet/Listing.h"
#include "streams/File.h"

namespace {

using namespace gt;

/// Reports every error but the last in a line of its own; returns that one.
Result<motionnet::Compilation> compile(const std::string& folder) {
  auto compilation = motionnet::compileFolder(folder, motionRules());
  if (compilation) return compilation;
  for (std::size_t i = 0; i + 1 < compilation.errors.size(); ++i)
    std::fprintf(stderr, "motionnet: %s\n", compilation.errors[i].text().c_str());
  const auto& last = compilation.errors.back();
  return Error{.file = last.file, .line = last.line, .field = last.field, .what = last.message};
}

Result<void> check(const std::string& folder) {
  const auto compilation = compile(folder);
  if (!compilation) return compilation.error();
  const auto net = motionNetOf(compilation->net, folder);
  if (!net) return net.error();
  std::printf("%s: %zu motions, %zu nodes\n", folder.c_str(), compilation->net.motions.size(),
              compilation->net.nodes.size());
  return {};
}

Result<void> list(const std::string& folder, const std::string& output) {
  const auto compilation = compile(folder);
  if (!compilation) return compilation.error();
  const std::string text = motionnet::listing(compilation->net.names());
  if (!output.empty()) return writeFile(output, text);
  std::fputs(text.c_str(), stdout);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line{argc, argv, "Motion descriptions (.mof) of the special actions"};
  std::string folder = line.root().path("motions"), output;
  CLI::App& checks = line.command("check", "Compiles a folder and reports what is wrong",
                                  [&] { return check(folder); });
  CLI::App& lists = line.command("list", "Writes the motions as an enumeration of XABSL",
                                 [&] { return list(folder, output); });
  lists.add_option("-o,--output", output, "File, instead of the standard output");
  for (CLI::App* command : {&checks, &lists})
    command->add_option("folder", folder, "Folder of the .mof files")->capture_default_str();
  return line.run();
}
