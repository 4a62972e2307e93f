#include "robot/ConfigFolder.h"

#include <sstream>

namespace gt {

namespace fs = std::filesystem;

Result<std::string> parseLocation(std::string_view text, const std::string& file) {
  std::istringstream lines{std::string{text}};
  std::string location;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min({line.size(), line.find("//"), line.find('#')}));
    std::istringstream words{line};
    for (std::string word; words >> word; location = word)
      if (!location.empty()) return Error{file, number, word, "expected the name of one folder"};
    if (location == "." || location == ".." || location.find_first_of("/\\") != location.npos ||
        location.find('\0') != location.npos)
      return Error{file, number, location, "expected the name of a folder in this one"};
  }
  return location;
}

Result<ConfigFolder> ConfigFolder::open(const std::string& folder) {
  if (!fs::is_directory(folder)) return Error{folder, 0, "", "is not a folder"};
  const std::string file = (fs::path{folder} / "location.cfg").string();
  if (!fs::exists(file)) return ConfigFolder{folder, ""};
  const auto text = readFile(file);
  if (!text) return text.error();
  auto location = parseLocation(*text, file);
  if (!location) return location.error();
  std::error_code failed;
  if (!location->empty() && !fs::is_directory(fs::path{folder} / *location, failed))
    return Error{file, 0, *location, "there is no such folder beside it"};
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

Result<RobotSections> robotSections(std::string_view text, const std::string& file) {
  RobotSections sections{{}, text.size()};
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    ++number;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::size_t open = line.find_first_not_of(" \t\r");
    if (open != line.npos && line[open] == '[') {
      sections.commonSize = std::min(sections.commonSize, at);
      const std::size_t close = std::min(line.find(']'), line.size());
      const std::string address{line.substr(open + 1, close - open - 1)};
      if (!isHardwareAddress(address))
        return Error{file, number, address, "expected a hardware address, as [00022D1F626B]"};
      if (std::find(sections.addresses.begin(), sections.addresses.end(), address) !=
          sections.addresses.end())
        return Error{file, number, address, "this robot has a section already"};
      sections.addresses.push_back(address);
    }
    at = end + 1;
  }
  return sections;
}

}  // namespace gt
