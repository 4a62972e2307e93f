#include "console/Commands.h"

#include <cmath>
#include <filesystem>

#include "base/Number.h"

namespace gt {

Result<double> numberOf(const std::string& word) {
  const auto number = numberFrom<double>(word);
  if (!number || !std::isfinite(*number)) return Error{.field = word, .what = "is no number"};
  return *number;
}

Result<double> numberOf(const std::string& word, double low, double high) {
  const auto number = numberOf(word);
  if (number && (*number < low || *number > high))
    return Error{.field = word,
                 .what = "is not from " + numberText(low) + " to " + numberText(high)};
  return number;
}

Error wrongArguments(const Words& words) {
  const Command* command = Console::find(words.front());
  return {
      .field = words.front(),
      .what = "expected: " + words.front() + " " + std::string{command ? command->arguments : ""}};
}

std::string withDefaults(const std::string& file, const std::string& folder,
                         const std::string& extension) {
  std::filesystem::path path{file};
  if (!path.has_parent_path()) path = std::filesystem::path{folder} / path;
  if (!path.has_extension()) path += extension;
  return path.string();
}

std::string dataFile(Console& console, const std::string& file, const std::string& folder,
                     const std::string& extension) {
  return withDefaults(file, console.session().options().root.path(folder), extension);
}

void printWritten(Console& console, const std::string& file) {
  console.print("written: " + file);
}

void list(Console& console, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) console.print(line);
}

}  // namespace gt
