#include "match/teams/TeamProgram.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/File.h"
#include "base/FileDescriptor.h"
#include "base/Program.h"
#include "base/UserFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr const char* commitPrefix = "commit:";
constexpr const char* programPrefix = "program:";
constexpr const char* robotProgram = "gtrobot-robot";
/// A file that all commits have whose robots can play in lockstep.
constexpr const char* neededFile = "src/robot/linux/Lockstep.h";

struct Words {
  std::string what, team;
};

/// The text behind the prefix, split: WHAT[:TEAM].
Words wordsOf(const std::string& name, const char* prefix) {
  const std::string text = name.substr(std::string{prefix}.size());
  const auto colon = std::min(text.find(':'), text.size());
  return {text.substr(0, colon), text.substr(std::min(colon + 1, text.size()))};
}

/// The first line that git prints; nothing if git fails.
std::optional<std::string> git(const std::string& repository, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", repository});
  const auto done = runProgram(words);
  if (!done || done->status != 0) return std::nullopt;
  return done->output.substr(0, done->output.find('\n'));
}

/// The repository that the sources of a root belong to; nothing if they are in none.
std::optional<std::string> repositoryOf(const DataRoot& root) {
  for (const std::string& folder : {root.path("."), DataRoot::places("").sources})
    if (!folder.empty() && fs::exists(fs::path{folder} / ".git"))
      if (git(folder, {"rev-parse", "--git-dir"})) return fs::absolute(folder).lexically_normal();
  return std::nullopt;
}

bool isWholeHash(const std::string& text) {
  return text.size() == 40 &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// The folder of a commit in the cache.
Result<fs::path> cacheOf(const std::string& commit) {
  const std::string cache = userFolder(UserFolder::cache);
  if (!cache.empty()) return fs::path{cache} / "teams" / commit;
  return Error{.what = "there is no folder for the programs of commits: set XDG_CACHE_HOME"};
}

Result<std::string> resolve(const std::string& revision, const DataRoot& root) {
  if (isWholeHash(revision)) {
    // Its programs may have been built where the repository was.
    if (const auto cache = cacheOf(revision); cache && fs::exists(*cache / "built"))
      return revision;
  }
  const Error wrong{.field = commitPrefix + revision, .what = "is no commit of the repository"};
  const auto repository = repositoryOf(root);
  if (!repository)
    return Error{.field = wrong.field, .what = "needs the repository of the sources"};
  if (revision.empty() || revision.starts_with('-')) return wrong;
  const auto hash = git(*repository, {"rev-parse", "--verify", "--quiet", revision + "^{commit}"});
  if (!hash || !isWholeHash(*hash)) return wrong;
  return *hash;
}

/// Builds the robots' program of a commit in the folder of the cache.
class Build {
 public:
  Build(std::string commit, std::string repository, fs::path folder)
      : commit_{std::move(commit)},
        repository_{std::move(repository)},
        folder_{std::move(folder)} {}

  Result<void> run() {
    if (!git(repository_, {"cat-file", "-e", commit_ + ":" + neededFile}))
      return Error{
          .field = commitPrefix + commit_,
          .what = std::string{"its robots cannot play in lockstep: it has no "} + neededFile};
    const fs::path sources = folder_ / "tree", built = sources / "build/release";
    std::fprintf(stderr, "building the robots of commit %.12s in %s\n", commit_.c_str(),
                 folder_.c_str());
    std::error_code failed;
    fs::remove_all(sources, failed);
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"git", "clone", "--quiet", "--shared", "--no-checkout", repository_, sources},
             {"git", "-C", sources, "checkout", "--quiet", "--detach", commit_},
             // Without precompiled headers ccache can share what commits have in common.
             {"cmake", "-S", sources, "-B", built, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
              "-DGT_PRECOMPILE=OFF"},
             {"cmake", "-E", "env", "CCACHE_BASEDIR=" + sources.string(), "cmake", "--build", built,
              "--target", robotProgram}})
      if (auto done = perform(command); !done) return done;
    fs::rename(built / "bin" / robotProgram, folder_ / robotProgram, failed);
    if (failed) return Error{.file = folder_ / robotProgram, .what = failed.message()};
    fs::remove_all(sources / "build", failed);
    fs::remove_all(sources / ".git", failed);
    return writeFile(folder_ / "built", "");
  }

 private:
  Result<void> perform(const std::vector<std::string>& command) {
    const auto done = runProgram(command);
    if (!done) return done.error();
    log_ += done->output + done->errors;
    if (done->status == 0) return {};
    const fs::path file = folder_ / "log";
    const bool kept = static_cast<bool>(writeFile(file, log_));
    return Error{.field = commitPrefix + commit_,
                 .what = "cannot be built: '" + command.front() + "' failed" +
                         (kept ? ", see " + file.string() : "")};
  }

  std::string commit_, repository_;
  fs::path folder_;
  std::string log_;
};

/// The team of a commit, whose program is built unless it is in the cache.
Result<TeamProgram> ofCommit(const std::string& commit, const std::string& team,
                             const DataRoot& root) {
  const auto folder = cacheOf(commit);
  if (!folder) return folder.error();
  const fs::path built = *folder / "built";
  if (!fs::exists(built)) {
    const auto repository = repositoryOf(root);
    if (!repository)
      return Error{.field = commitPrefix + commit, .what = "needs the repository of the sources"};
    std::error_code failed;
    fs::create_directories(*folder, failed);
    const fs::path lock = *folder / "lock";
    const FileDescriptor locked{open(lock.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600)};
    if (!locked || flock(locked.number(), LOCK_EX) != 0)
      return Error{.file = lock, .what = "cannot be locked"};
    if (!fs::exists(built))
      if (auto done = Build{commit, *repository, *folder}.run(); !done) return done.error();
  }
  return TeamProgram{(*folder / robotProgram).string(), DataRoot{(*folder / "tree").string()},
                     team};
}

Result<TeamProgram> ofFile(const std::string& file, const std::string& team) {
  std::error_code failed;
  const fs::path path = fs::canonical(file, failed);
  if (failed || access(path.c_str(), X_OK) != 0 || fs::is_directory(path))
    return Error{.file = file, .what = "is no program"};
  const auto root = DataRoot::find({.option = "", .variable = "", .program = path, .sources = ""});
  if (!root) return Error{.file = file, .what = "belongs to no tree with a configuration"};
  return TeamProgram{path.string(), *root, team};
}

}  // namespace

bool namesProgram(const std::string& team) {
  return team.starts_with(commitPrefix) || team.starts_with(programPrefix);
}

Result<TeamProgram> teamProgram(const std::string& team, const DataRoot& root) {
  if (team.starts_with(programPrefix)) {
    const auto [file, name] = wordsOf(team, programPrefix);
    return ofFile(file, name);
  }
  const auto [revision, name] = wordsOf(team, commitPrefix);
  const auto commit = resolve(revision, root);
  if (!commit) return commit.error();
  return ofCommit(*commit, name, root);
}

Result<std::string> resolvedTeam(const std::string& team, const DataRoot& root) {
  if (!team.starts_with(commitPrefix)) return team;
  const auto [revision, name] = wordsOf(team, commitPrefix);
  const auto commit = resolve(revision, root);
  if (!commit) return commit.error();
  return commitPrefix + *commit + (name.empty() ? "" : ":" + name);
}

}  // namespace gt
