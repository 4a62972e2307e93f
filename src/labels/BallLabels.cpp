#include "labels/BallLabels.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/Enum.h"
#include "base/File.h"
#include "base/Lines.h"
#include "base/Number.h"

namespace gt {
namespace {

constexpr double largest = 1e15;  ///< Whole numbers are exact up to there.
constexpr const char* ballHeading = "picture,time,class,x,y,r";

bool number(const std::string& text, double& value) {
  const auto found = numberFrom<double>(text);
  if (found) value = *found;
  return found && std::isfinite(value) && std::abs(value) < largest;
}

}  // namespace

Result<std::vector<BallLabel>> parseLabels(std::string_view content, const std::string& file) {
  LineReader reader{content};
  std::vector<BallLabel> labels;
  while (const auto next = reader.next()) {
    const int line = reader.number();
    const std::string text{*next};
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
    if (std::abs(values[0]) > std::numeric_limits<int>::max())
      return Error{.file = file, .line = line, .field = names[0], .what = "is too large"};
    labels.push_back({static_cast<int>(values[0]),
                      static_cast<std::int64_t>(values[1]),
                      *view,
                      {values[2], values[3]},
                      values[4]});
  }
  if (labels.empty()) return Error{.file = file, .what = "there are no labels"};
  return labels;
}

Result<std::vector<BallLabel>> readLabels(const std::string& file) {
  const auto content = readFile(file);
  if (!content) return content.error();
  return parseLabels(*content, file);
}

std::string labelTable(const std::vector<BallLabel>& labels) {
  std::string text = std::string{ballHeading} + "\n";
  for (const BallLabel& label : labels)
    text += std::to_string(label.picture) + "," + std::to_string(label.time) + "," +
            std::string{enumName(label.view)} + "," + numberText(label.center.x()) + "," +
            numberText(label.center.y()) + "," + numberText(label.radius) + "\n";
  return text;
}

}  // namespace gt
