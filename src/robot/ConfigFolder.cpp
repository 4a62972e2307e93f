#include "robot/ConfigFolder.h"

#include "base/Lines.h"

namespace gt {

namespace fs = std::filesystem;

Result<std::string> parseLocation(std::string_view text, const std::string& file) {
  std::string location;
  for (const Line& line : linesOf(text)) {
    const auto words = wordsOf(line.text);
    if (!words || words->size() > 1 || !location.empty())
      return Error{.file = file,
                   .line = line.number,
                   .field = std::string{line.text},
                   .what = "expected the name of one folder"};
    location = words->front().text;
    if (location == "." || location == ".." || location.find_first_of("/\\") != location.npos ||
        location.find('\0') != location.npos)
      return Error{.file = file,
                   .line = line.number,
                   .field = location,
                   .what = "expected the name of a folder in this one"};
  }
  return location;
}

Result<ConfigFolder> ConfigFolder::open(const std::string& folder) {
  if (!fs::is_directory(folder)) return Error{.file = folder, .what = "is not a folder"};
  const std::string file = (fs::path{folder} / "location.cfg").string();
  if (!fs::exists(file)) return ConfigFolder{folder, ""};
  const auto text = readFile(file);
  if (!text) return text.error();
  auto location = parseLocation(*text, file);
  if (!location) return location.error();
  std::error_code failed;
  if (!location->empty() && !fs::is_directory(fs::path{folder} / *location, failed))
    return Error{.file = file, .field = *location, .what = "there is no such folder beside it"};
  return ConfigFolder{folder, std::move(*location)};
}

std::string ConfigFolder::path(const std::string& file) const {
  const fs::path common = fs::path{folder_} / file;
  if (location_.empty()) return common.string();
  const fs::path own = fs::path{folder_} / location_ / file;
  return (fs::exists(own) ? own : common).string();
}

std::vector<std::string> ConfigFolder::paths(const std::string& file) const {
  std::vector<std::string> all{(fs::path{folder_} / file).string()};
  if (!location_.empty()) all.push_back((fs::path{folder_} / location_ / file).string());
  return all;
}

bool isHardwareAddress(std::string_view text) {
  return text.size() == 12 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F');
         });
}

std::vector<std::string> robotAddresses(std::string_view text, const std::string& file,
                                        Findings& findings) {
  std::vector<std::string> addresses;
  for (const ConfigSection& section : detail::configSections(text)) {
    const bool isKnown = std::ranges::find(addresses, section.name) != addresses.end();
    if (isHardwareAddress(section.name) && !isKnown)
      addresses.push_back(section.name);
    else
      findings.add({.file = file,
                    .line = section.line,
                    .field = section.name,
                    .what = isKnown ? "this robot has a section already"
                                    : "expected a hardware address, as [00022D1F626B]"});
  }
  return addresses;
}

}  // namespace gt
