#include "robot/Deployment.h"

#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr const char* seconds = "10";  ///< After which a host that does not answer is given up.

/// HOST:FOLDER, split; empty if the target is a folder of this machine.
std::optional<std::pair<std::string, std::string>> remote(const std::string& target) {
  const std::size_t colon = target.find(':');
  if (colon == target.npos || target.find('/') < colon) return std::nullopt;
  return std::pair{target.substr(0, colon), target.substr(colon + 1)};
}

/// Whether a shell takes a word as it is, and a program as no option.
bool isPlain(const std::string& word) {
  constexpr std::string_view others = "._/@-~+";
  return !word.empty() && word.front() != '-' && std::ranges::all_of(word, [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || others.find(c) != others.npos;
  });
}

/// Returns the paths of player.cfg and network.cfg below the folder: those of a location win.
Result<std::vector<std::string>> write(const Deployment& deployment, const fs::path& folder) {
  auto network = loadNetwork(deployment.config);
  if (!network) return network.error();
  network->robot = deployment.robot;
  if (!deployment.endpoint.empty()) network->tools = deployment.endpoint;
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure)
    fs::copy(deployment.config, folder,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing, failure);
  if (failure) return Error{.file = folder.string(), .what = failure.message()};
  if (!deployment.location.empty())
    if (auto done = writeFile((folder / "location.cfg").string(), deployment.location + "\n");
        !done)
      return done.error();
  const auto files = ConfigFolder::open(folder.string());
  if (!files) return files.error();
  std::vector<std::string> names;
  for (const auto& [name, text] : {std::pair{"player.cfg", writeConfig(deployment.player)},
                                   {"network.cfg", writeConfig(*network)}}) {
    const std::string file = files->path(name);
    if (auto done = writeFile(file, text); !done) return done.error();
    names.push_back(fs::path{file}.lexically_relative(folder).string());
  }
  return names;
}

/// What a command of the shell prints; an error with that if it fails.
Result<std::string> outputOf(const std::string& command, const std::string& host) {
  FILE* const pipe = popen(command.c_str(), "re");
  if (!pipe) return Error{.field = host, .what = "no program can be started"};
  std::string text;
  char part[256];
  while (std::fgets(part, sizeof part, pipe)) text += part;
  const int status = pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return text;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  return Error{.field = host, .what = text.substr(line == text.npos ? 0 : line + 1)};
}

}  // namespace

Result<std::string> deploy(const Deployment& deployment, const std::string& target) {
  const auto there = remote(target);
  if (!there) {
    const auto files = write(deployment, target);
    if (!files) return files.error();
    std::string text;
    for (const std::string& name : *files) {
      const auto content = readFile((fs::path{target} / name).string());
      if (!content) return content.error();
      text += *content;
    }
    return text;
  }
  const auto& [host, folder] = *there;
  for (const std::string& word : {host, folder})
    if (!isPlain(word)) return Error{.field = target, .what = "is no HOST:FOLDER without blanks"};
  const TemporaryFolder staged;
  const auto files = write(deployment, staged.path());
  if (!files) return files.error();
  std::string command = "{ tar -C '" + staged.path().string() +
                        "' -cf - . | ssh -o BatchMode=yes -o ConnectTimeout=" + seconds +
                        " -o ServerAliveInterval=" + seconds + " " + host + " 'mkdir -p " + folder +
                        " && tar -C " + folder + " -xf - && cd " + folder + " && cat";
  for (const std::string& name : *files) command += " " + name;
  return outputOf(command + "'; } 2>&1", host);
}

}  // namespace gt
