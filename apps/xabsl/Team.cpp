#include "Team.h"

#include <filesystem>

#include "Commands.h"
#include "base/DataRoot.h"
#include "xabsl/language/SourceFiles.h"

namespace xabsl::app {
namespace {

namespace fs = std::filesystem;

/// A path from a folder on; empty if it lies elsewhere.
fs::path within(const fs::path& file, const fs::path& folder) {
  const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(
      fs::absolute(folder).lexically_normal());
  return relative.empty() || *relative.begin() == ".." ? fs::path() : relative;
}

}  // namespace

gt::Result<Team> Team::open(const std::string& name) {
  const auto root = gt::DataRoot::find(gt::DataRoot::places(""));
  if (!root) return root.error();
  Team team;
  team.agents_ = root->path("behavior/GT2003.xabsl");
  const std::string ofRoot = root->path("teams/" + name);
  const bool isName = name.find('/') == std::string::npos && fs::is_directory(ofRoot);
  const fs::path folder = isName ? ofRoot : name;
  if (!fs::is_directory(folder / "behavior"))
    return gt::Error{.file = folder.string(), .what = "has no folder behavior"};
  team.folder_ = (folder / "behavior").string();
  return team;
}

Compilation Team::compile(const std::string& agents, Dialect dialect) const {
  if (folder_.empty()) return compileFile(agents, dialect);
  const bool ofTeam = !within(agents, folder_).empty();
  const fs::path base = fs::path(ofTeam ? agents_ : agents).parent_path();
  const auto placeOf = [&](const std::string& file) {
    const fs::path relative = within(file, ofTeam ? fs::path(folder_) : base);
    if (relative.empty()) return file;
    const fs::path own = folder_ / relative;
    return (fs::exists(own) ? own : base / relative).string();
  };
  Compilation compilation = xabsl::compile(
      agents,
      [&](const std::string& file, std::string& text) { return readFile(placeOf(file), text); },
      dialect);
  for (Diagnostic& diagnostic : compilation.diagnostics) diagnostic.file = placeOf(diagnostic.file);
  explainPart(agents, compilation);
  return compilation;
}

void addTeam(CLI::App& command, std::string& name) {
  command.add_option("--team", name,
                     "With the files of a team: a name of the folder teams, or a folder");
}

std::optional<Team> openTeam(const std::string& name) {
  if (name.empty()) return Team();
  auto team = Team::open(name);
  if (team) return *std::move(team);
  printError(team.error().file, team.error().what);
  return std::nullopt;
}

}  // namespace xabsl::app
