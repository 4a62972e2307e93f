#include "match/teams/TeamFolder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/LinkFiles.h"
#include "match/teams/TeamProgram.h"
#include "robot/FileNames.h"
#include "robot/ProjectVersion.h"
#include "robot/TeamSolutions.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr std::array parts{"behavior", "config", "motions"};

/// Checks that a folder is a team's. It may hold any files beside the parts' folders.
Result<void> checkTeam(const std::string& folder) {
  const auto wrong = [&](const std::string& what) { return Error{.file = folder, .what = what}; };
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) return wrong("is no team: there is no such folder");
  int found = 0;
  for (fs::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed)) {
    if (!at->is_directory()) continue;
    const std::string name = at->path().filename().string();
    if (std::ranges::find(parts, name) == parts.end())
      return wrong("is no team: expected folders behavior, config, motions; not '" + name + "'");
    ++found;
  }
  if (failed) return wrong(failed.message());
  if (found == 0) return wrong("is no team: it has none of the folders behavior, config, motions");
  return {};
}

/// Keeps the project's modules.cfg and adds the team's beside it, since a team changes only the
/// tasks that it names.
Result<void> keepSolutions(const fs::path& base, const fs::path& own, const fs::path& links) {
  constexpr const char* solutions = "modules.cfg";
  if (!fs::exists(own / solutions) || !fs::exists(base / solutions)) return {};
  std::error_code failed;
  fs::rename(links / solutions, links / teamSolutions, failed);
  if (!failed) fs::create_symlink(base / solutions, links / solutions, failed);
  if (failed) return Error{.file = (links / solutions).string(), .what = failed.message()};
  return {};
}

/// The version of a team with a program. Fails if it is not named by a commit: a commit is its own
/// fingerprint; other files could change.
Result<std::string> versionOfProgram(const std::string& team, const DataRoot& root) {
  auto resolved = resolvedTeam(team, root);
  if (!resolved) return resolved;
  if (!resolved->starts_with("commit:"))
    return Error{.field = team, .what = "may change: expected commit:REVISION"};
  if (resolved->find_first_of("/ \t\n\r@") != resolved->npos)
    return Error{.field = team, .what = "expected a team of the commit's folder teams"};
  return resolved;
}

}  // namespace

Result<std::unique_ptr<TeamFolder>> TeamFolder::open(const std::string& folder,
                                                     const ConfigurationPaths& base) {
  if (auto done = checkTeam(folder); !done) return done.error();
  auto team = std::make_unique<TeamFolder>();
  team->folder_ = folder;
  const fs::path links = team->links_.path();
  if (links.empty()) return Error{.what = "there is no temporary folder"};
  const fs::path behavior = fs::absolute(base.behavior);
  for (const auto& [from, name] : {std::pair{behavior.parent_path(), "behavior"},
                                   {fs::absolute(base.config), "config"},
                                   {fs::absolute(base.motions), "motions"}}) {
    if (auto done = linkFiles(from.lexically_normal(), links / name); !done) return done.error();
    const fs::path own = fs::absolute(folder).lexically_normal() / name;
    if (!fs::is_directory(own)) continue;
    if (auto done = linkFiles(own, links / name); !done) return done.error();
    if (name != std::string_view{"config"}) continue;
    if (auto done = keepSolutions(from, own, links / name); !done) return done.error();
  }
  team->paths_ = base;
  team->paths_.behavior = (links / "behavior" / behavior.filename()).string();
  team->paths_.config = (links / "config").string();
  team->paths_.motions = (links / "motions").string();
  return team;
}

Error TeamFolder::named(Error error) const {
  return withFileNames(std::move(error), links_.path(), [&](const std::string& path) {
    std::error_code failed;
    const fs::path file = fs::read_symlink(path, failed);
    if (failed)
      return (fs::path{folder_} / fs::path{path}.lexically_relative(links_.path())).string();
    const fs::path shown = file.lexically_relative(fs::current_path());
    return (shown.empty() || *shown.begin() == ".." ? file : shown).string();
  });
}

std::string teamFolder(const std::string& team, const DataRoot& root) {
  if (team.empty() || team == TeamFolder::ownTeam) return "";
  const std::string ofRoot = root.path("teams/" + team);
  return team.find('/') == team.npos && fs::is_directory(ofRoot) ? ofRoot : team;
}

Result<std::string> teamVersion(const std::string& team, const DataRoot& root) {
  if (namesProgram(team)) return versionOfProgram(team, root);
  const std::string folder = teamFolder(team, root);
  if (folder.empty()) return std::string{TeamFolder::ownTeam};
  if (auto done = checkTeam(folder); !done) return done.error();
  Fingerprint sum;
  if (auto done = addFiles(folder, sum); !done) return done.error();
  std::error_code failed;
  const fs::path path = fs::canonical(folder, failed);
  if (failed) return Error{.file = folder, .what = failed.message()};
  const bool ofRoot = fs::equivalent(path.parent_path(), root.path("teams"), failed);
  const std::string name = ofRoot ? path.filename().string() : path.string();
  if (name.find_first_of(" \t\n\r@") != name.npos)
    return Error{.file = name, .what = "a team's path may have neither spaces nor @"};
  return name + '@' + digitsOf(sum);
}

Result<std::string> teamOfVersion(const std::string& version, const DataRoot& root) {
  if (namesProgram(version)) return version;
  const auto at = std::min(version.find('@'), version.size());
  const std::string name = version.substr(0, at), folder = teamFolder(name, root);
  if (at == version.size()) return folder;
  const auto now = teamVersion(name, root);
  if (!now) return now.error();
  const std::string sum = now->substr(std::min(now->find('@') + 1, now->size()));
  if (sum != version.substr(at + 1))
    return Error{.file = folder, .field = version, .what = "has changed since; it is @" + sum};
  return folder;
}

}  // namespace gt
