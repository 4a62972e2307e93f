#include "measure/real/Labels.h"

#include <array>
#include <sstream>

#include "base/Enum.h"
#include "streams/File.h"

namespace gt {
namespace {

constexpr const char* ballHeading = "picture,time,class,x,y,r";

bool number(const std::string& text, double& value) {
  std::istringstream stream(text);
  return static_cast<bool>(stream >> value) && (stream >> std::ws).eof();
}

}  // namespace

Result<std::vector<BallLabel>> readLabels(const std::string& file) {
  const auto content = readFile(file);
  if (!content) return content.error();
  std::istringstream stream(*content);
  std::vector<BallLabel> labels;
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    if (line == 1 && text != ballHeading)
      return Error{.file = file, .line = line, .what = std::string{ballHeading} + " was expected"};
    if (line == 1 || text.empty()) continue;
    std::istringstream row(text);
    std::array<std::string, 6> cells;
    for (std::string& cell : cells) std::getline(row, cell, ',');
    std::array<double, 5> values{};
    constexpr std::array<std::size_t, 5> columns{0, 1, 3, 4, 5};
    constexpr std::array<const char*, 5> names{"picture", "time", "x", "y", "r"};
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!number(cells[columns[i]], values[i]))
        return Error{
            .file = file, .line = line, .field = names[i], .what = "a number was expected"};
    const auto view = enumValue<BallView>(cells[2]);
    if (!view)
      return Error{.file = file,
                   .line = line,
                   .field = "class",
                   .what = "whole, partial or none was expected"};
    labels.push_back({static_cast<int>(values[0]),
                      static_cast<std::int64_t>(values[1]),
                      *view,
                      {values[2], values[3]},
                      values[4]});
  }
  if (labels.empty()) return Error{.file = file, .what = "there are no labels"};
  return labels;
}

}  // namespace gt
