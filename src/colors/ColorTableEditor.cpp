#include "colors/ColorTableEditor.h"

#include <algorithm>
#include <cstdlib>

namespace gt {
namespace {

constexpr int side = 64;
constexpr std::size_t mostChanges = 4'000'000;

/// A way from one cube of the table to another one.
struct Offset {
  int y, cb, cr;
};

/// All ways to other cubes that are not longer than a distance.
std::vector<Offset> offsetsWithin(double distance) {
  std::vector<Offset> offsets;
  const int most = static_cast<int>(distance);
  for (int y = -most; y <= most; ++y)
    for (int cb = -most; cb <= most; ++cb)
      for (int cr = -most; cr <= most; ++cr) {
        const int square = y * y + cb * cb + cr * cr;
        if (square > 0 && square <= distance * distance) offsets.push_back({y, cb, cr});
      }
  return offsets;
}

/// Calls visit(neighbor) for the cubes around one.
template <typename Visit>
void forEachNeighbor(std::size_t color, const std::vector<Offset>& offsets, Visit visit) {
  const int y = static_cast<int>(color >> 12), cb = color >> 6 & 63, cr = color & 63;
  for (const Offset& offset : offsets) {
    const int ny = y + offset.y, ncb = cb + offset.cb, ncr = cr + offset.cr;
    if (((ny | ncb | ncr) & ~(side - 1)) == 0)
      visit(static_cast<std::size_t>(ny << 12 | ncb << 6 | ncr));
  }
}

/// How many colors of a class lie around each color.
std::vector<std::uint16_t> countsAround(const ColorTable64& table, ColorClass colorClass,
                                        const std::vector<Offset>& offsets) {
  std::vector<std::uint16_t> counts(table.classes.size());
  for (std::size_t i = 0; i < table.classes.size(); ++i)
    if (table.classes[i] == colorClass)
      forEachNeighbor(i, offsets, [&](std::size_t neighbor) { ++counts[neighbor]; });
  return counts;
}

std::vector<ColorClass> classesOf(std::optional<ColorClass> selected) {
  if (selected) return {*selected};
  std::vector<ColorClass> all;
  for (std::size_t i = 1; i < enumCount<ColorClass>; ++i) all.push_back(static_cast<ColorClass>(i));
  return all;
}

}  // namespace

void ColorTableEditor::assign(std::size_t color, ColorClass colorClass, Step& step) {
  ColorClass& now = table_.classes[color];
  if (now == colorClass) return;
  step.push_back({static_cast<std::uint32_t>(color), now});
  now = colorClass;
}

void ColorTableEditor::set(const Pixel& pixel, ColorClass colorClass) {
  Step step;
  assign(ColorTable64::index(pixel.y, pixel.cb, pixel.cr), colorClass, step);
  keep(std::move(step));
}

void ColorTableEditor::clear(ColorClass colorClass) {
  Step step;
  for (std::size_t i = 0; i < table_.classes.size(); ++i)
    if (table_.classes[i] == colorClass) assign(i, ColorClass::noColor, step);
  keep(std::move(step));
}

void ColorTableEditor::reset() {
  Step step;
  for (std::size_t i = 0; i < table_.classes.size(); ++i) assign(i, ColorClass::noColor, step);
  keep(std::move(step));
}

void ColorTableEditor::removeIsolated(std::optional<ColorClass> selected) {
  keep(isolated(selected));
}

void ColorTableEditor::median(const MedianRule& rule, std::optional<ColorClass> selected) {
  keep(added(rule, selected));
}

void ColorTableEditor::onPicture(const AutomaticFilters& filters) {
  Step step;
  if (!steps_.empty()) {
    step = std::move(steps_.back());
    steps_.pop_back();
  }
  const auto append = [&](const Step& more) { step.insert(step.end(), more.begin(), more.end()); };
  if (filters.remove) append(isolated(filters.selected));
  if (filters.median) append(added(filters.rule, filters.selected));
  keep(std::move(step));
}

ColorTableEditor::Step ColorTableEditor::isolated(std::optional<ColorClass> selected) {
  const std::vector<Offset> touching = offsetsWithin(1.8);  // corner to corner: sqrt(3)
  std::vector<std::size_t> alone;
  for (std::size_t i = 0; i < table_.classes.size(); ++i) {
    const ColorClass own = table_.classes[i];
    if (own == ColorClass::noColor || (selected && own != *selected)) continue;
    bool found = false;
    forEachNeighbor(i, touching, [&](std::size_t n) { found |= table_.classes[n] == own; });
    if (!found) alone.push_back(i);
  }
  Step step;
  for (const std::size_t i : alone) assign(i, ColorClass::noColor, step);
  return step;
}

ColorTableEditor::Step ColorTableEditor::added(const MedianRule& rule,
                                               std::optional<ColorClass> selected) {
  const std::vector<Offset> offsets = offsetsWithin(std::clamp(rule.distance, 1, 8));
  const int least = std::max(rule.neighbors, 1);
  std::vector<std::uint16_t> most(table_.classes.size());
  std::vector<ColorClass> best = {table_.classes.begin(), table_.classes.end()};
  for (const ColorClass colorClass : classesOf(selected)) {
    if (colorClass == ColorClass::noColor) continue;
    const std::vector<std::uint16_t> counts = countsAround(table_, colorClass, offsets);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const ColorClass own = table_.classes[i];
      if (counts[i] < least || (own != ColorClass::noColor && !rule.reassign)) continue;
      if (counts[i] < most[i] || (counts[i] == most[i] && own != colorClass)) continue;
      most[i] = counts[i];
      best[i] = colorClass;
    }
  }
  Step step;
  for (std::size_t i = 0; i < best.size(); ++i) assign(i, best[i], step);
  return step;
}

void ColorTableEditor::keep(Step step) {
  if (step.empty()) return;
  steps_.push_back(std::move(step));
  std::size_t changes = 0, oldest = steps_.size();
  while (oldest > 0 && changes + steps_[oldest - 1].size() <= mostChanges)
    changes += steps_[--oldest].size();
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(oldest));
}

bool ColorTableEditor::undo() {
  if (steps_.empty()) return false;
  const Step& step = steps_.back();
  for (auto change = step.rbegin(); change != step.rend(); ++change)
    table_.classes[change->color] = change->before;
  steps_.pop_back();
  return true;
}

}  // namespace gt
