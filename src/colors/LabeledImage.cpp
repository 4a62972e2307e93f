#include "colors/LabeledImage.h"

#include <array>

#include "base/File.h"
#include "base/Lines.h"
#include "base/Number.h"

namespace gt {
namespace {

constexpr std::string_view heading = "picture,class,left,top,right,bottom";
constexpr std::array columns{"picture", "class", "left", "top", "right", "bottom"};

/// The cells of a row; an error states their number if it is wrong.
std::vector<std::string_view> cellsOf(std::string_view row) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto end = row.find(',');
    cells.push_back(row.substr(0, end));
    if (end == row.npos) return cells;
    row.remove_prefix(end + 1);
  }
}

Result<LabeledRegion> parseRow(std::string_view row, const std::string& file, int line) {
  const std::vector<std::string_view> cells = cellsOf(row);
  if (cells.size() != columns.size())
    return Error{.file = file, .line = line, .what = "expected " + std::string{heading}};
  if (cells[0].empty())
    return Error{.file = file, .line = line, .field = columns[0], .what = "is missing"};
  const auto colorClass = enumValue<ColorClass>(cells[1]);
  if (!colorClass)
    return Error{.file = file,
                 .line = line,
                 .field = columns[1],
                 .what = "there is no class '" + std::string{cells[1]} + "'"};
  std::array<int, 4> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string_view cell = cells[2 + i];
    corners[i] = numberFrom<int>(cell).value_or(-1);
    if (corners[i] < 0)
      return Error{.file = file,
                   .line = line,
                   .field = columns[2 + i],
                   .what = "expected a pixel's number instead of '" + std::string{cell} + "'"};
  }
  const auto [left, top, right, bottom] = corners;
  if (left > right)
    return Error{.file = file, .line = line, .field = "right", .what = "lies left of left"};
  if (top > bottom)
    return Error{.file = file, .line = line, .field = "bottom", .what = "lies above top"};
  return LabeledRegion{std::string{cells[0]}, *colorClass, {left, top, right, bottom}};
}

}  // namespace

Result<std::vector<LabeledRegion>> parseRegions(std::string_view text, const std::string& file) {
  std::vector<LabeledRegion> regions;
  LineReader reader{text};
  while (const auto row = reader.next()) {
    const int line = reader.number();
    if (line == 1 && *row != heading) break;
    if (line == 1 || row->empty()) continue;
    auto region = parseRow(*row, file, line);
    if (!region) return region.error();
    regions.push_back(*std::move(region));
  }
  if (regions.empty())
    return Error{
        .file = file, .line = 1, .what = "expected a table of labels: " + std::string{heading}};
  return regions;
}

Result<std::vector<LabeledRegion>> readRegions(const std::string& file) {
  const auto text = readFile(file);
  return text ? parseRegions(*text, file) : text.error();
}

}  // namespace gt
