#include "FaultReport.h"

#include <fmt/core.h>
#include <sys/utsname.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/Program.h"
#include "base/TemporaryFolder.h"
#include "base/UnfinishedFile.h"
#include "crash/CrashHandler.h"
#include "robot/ProjectVersion.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// What robots, matches and experiments read.
constexpr const char* rootFolders[]{"behavior", "config", "layouts", "motions", "scenes"};

std::optional<std::string> newestCrash() {
  std::optional<fs::directory_entry> newest;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator{crashFolder(), failed})
    if (entry.is_regular_file() && (!newest || entry.last_write_time() > newest->last_write_time()))
      newest = entry;
  if (!newest) return std::nullopt;
  return newest->path().string();
}

Result<std::string> about(const FaultReportOptions& options) {
  const auto version = projectVersion(options.root);
  if (!version) return version.error();
  utsname machine{};
  uname(&machine);
  return fmt::format(
      "fault: {}\nversion: {} (commit of the program, fingerprint of the files)\ncompiler: {}\n"
      "machine: {} {} {}\n",
      options.note, *version, __VERSION__, machine.sysname, machine.release, machine.machine);
}

/// Collects files in a folder, under names of their own.
class Package {
 public:
  Result<void> add(const std::string& from, const std::string& to) {
    std::error_code failed;
    if (!fs::exists(from)) return Error{.file = from, .what = "there is no such file or folder"};
    fs::create_directories((folder_.path() / to).parent_path(), failed);
    fs::copy(from, folder_.path() / to, fs::copy_options::recursive, failed);
    if (failed) return Error{.file = from, .what = failed.message()};
    names_.push_back(to);
    return {};
  }
  Result<void> write(const std::string& name, const std::string& text) {
    names_.push_back(name);
    return writeFile((folder_.path() / name).string(), text);
  }
  Result<void> pack(const std::string& file) const {
    std::error_code ignored;  // then tar reports what is wrong
    fs::create_directories(fs::absolute(file).parent_path(), ignored);
    UnfinishedFile unfinished{file};
    const auto packed = runProgram({"tar", "-czf", unfinished.written(), "--sort=name", "--owner=0",
                                    "--group=0", "-C", folder_.path().string(), "."});
    if (packed && packed->status == 0) return unfinished.finish();
    if (!packed) return packed.error();
    return Error{.file = file, .what = packed->errors.substr(0, packed->errors.find('\n'))};
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> names_;
};

/// The name of a file or folder that is named with any path.
std::string lastName(const std::string& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

}  // namespace

Result<void> packFaultReport(const FaultReportOptions& options) {
  Package package;
  const auto text = about(options);
  if (!text) return text.error();
  if (auto done = package.write("about.txt", *text); !done) return done;
  std::vector<std::string> crashes = options.crashes;
  if (crashes.empty())
    if (auto newest = newestCrash()) crashes.push_back(*std::move(newest));
  for (const std::string& crash : crashes)
    if (auto done = package.add(crash, "crashes/" + lastName(crash)); !done) return done;
  for (const std::string& result : options.results)
    if (auto done = package.add(result, "results/" + lastName(result)); !done) return done;
  for (const char* folder : rootFolders)
    if (auto done = package.add(options.root.path(folder), std::string{"root/"} + folder); !done)
      return done;
  if (auto done = package.pack(options.out); !done) return done;
  fmt::print("{}:", options.out);
  for (const std::string& name : package.names()) fmt::print(" {}", name);
  fmt::print("\n");
  return {};
}

}  // namespace gt
