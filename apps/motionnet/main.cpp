// Checks motion descriptions and lists them for XABSL (report 5.4).
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/File.h"
#include "commandline/CommandLine.h"
#include "match/teams/TeamFolder.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "motionnet/Compiler.h"
#include "motionnet/Listing.h"

namespace {

using namespace gt;

/// Which motions: those of a folder, or those of a team laid over the project's.
struct Arguments {
  std::string folder, team, output;
  DataRoot root;
};

/// Reports every error but the last in a line of its own; returns that one. `named` gives an error
/// the name of its file as the user knows it.
Result<motionnet::Compilation> compile(const std::string& folder,
                                       const std::function<Error(Error)>& named) {
  auto compilation = motionnet::compileFolder(folder, motionRules());
  if (compilation) return compilation;
  std::vector<Error> errors;
  for (const auto& e : compilation.errors)
    errors.push_back(named({.file = e.file, .line = e.line, .field = e.field, .what = e.message}));
  for (std::size_t i = 0; i + 1 < errors.size(); ++i)
    std::fprintf(stderr, "motionnet: %s\n", errors[i].text().c_str());
  return errors.back();
}

Result<motionnet::Compilation> compile(const Arguments& arguments) {
  if (arguments.team.empty()) return compile(arguments.folder, [](Error error) { return error; });
  const auto team = TeamFolder::open(teamFolder(arguments.team, arguments.root),
                                     ConfigurationPaths::in(arguments.root));
  if (!team) return team.error();
  return compile((*team)->paths().motions,
                 [&](Error error) { return (*team)->named(std::move(error)); });
}

Result<void> check(const Arguments& arguments) {
  const auto compilation = compile(arguments);
  if (!compilation) return compilation.error();
  const std::string& name = arguments.team.empty() ? arguments.folder : arguments.team;
  const auto net = motionNetOf(compilation->net, name);
  if (!net) return net.error();
  std::printf("%s: %zu motions, %zu nodes\n", name.c_str(), compilation->net.motions.size(),
              compilation->net.nodes.size());
  return {};
}

Result<void> list(const Arguments& arguments) {
  const auto compilation = compile(arguments);
  if (!compilation) return compilation.error();
  const std::string text = motionnet::listing(compilation->net.names());
  if (!arguments.output.empty()) return writeFile(arguments.output, text);
  std::fputs(text.c_str(), stdout);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line{argc, argv, "Motion descriptions (.mof) of the special actions"};
  Arguments arguments{line.root().path("motions"), "", "", line.root()};
  CLI::App& checks = line.command("check", "Compiles a folder and reports what is wrong",
                                  [&] { return check(arguments); });
  CLI::App& lists = line.command("list", "Writes the motions as an enumeration of XABSL",
                                 [&] { return list(arguments); });
  lists.add_option("-o,--output", arguments.output, "File, instead of the standard output");
  for (CLI::App* command : {&checks, &lists}) {
    auto* folder = command->add_option("folder", arguments.folder, "Folder of the .mof files")
                       ->capture_default_str();
    command
        ->add_option("--team", arguments.team,
                     "Those of a team and the project's: a name of the folder teams, or a folder")
        ->excludes(folder);
  }
  return line.run();
}
