// Checks motion descriptions and lists them for XABSL (report 5.4).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "modules/motion/specialactions/MotionNetLoader.h"
#include "motionnet/Compiler.h"
#include "motionnet/Listing.h"

namespace {

constexpr int badData = 2;  // exit status

/// Tells every error in one line each.
bool report(const motionnet::Compilation& compilation) {
  for (const auto& error : compilation.errors) std::fprintf(stderr, "%s\n", error.text().c_str());
  return static_cast<bool>(compilation);
}

int check(const std::string& folder) {
  const auto compilation = motionnet::compileFolder(folder, gt::motionRules());
  if (!report(compilation)) return badData;
  const auto net = gt::motionNetOf(compilation.net, folder);
  if (!net) {
    std::fprintf(stderr, "%s\n", net.error().text().c_str());
    return badData;
  }
  std::printf("%s: %zu motions, %zu nodes\n", folder.c_str(), compilation.net.motions.size(),
              compilation.net.nodes.size());
  return 0;
}

int list(const std::string& folder) {
  const auto compilation = motionnet::compileFolder(folder, gt::motionRules());
  if (!report(compilation)) return badData;
  std::fputs(motionnet::listing(compilation.net).c_str(), stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Motion descriptions (.mof) of the special actions"};
  app.require_subcommand(1);
  std::string folder = "motions";
  auto* checkCommand = app.add_subcommand("check", "compile a folder and tell what is wrong");
  auto* listCommand = app.add_subcommand("list", "the motions as XML for XABSL");
  for (auto* command : {checkCommand, listCommand})
    command->add_option("folder", folder, "folder of the .mof files")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : badData;
  }
  return checkCommand->parsed() ? check(folder) : list(folder);
}
