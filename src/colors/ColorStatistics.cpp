#include "colors/ColorStatistics.h"

#include <algorithm>
#include <numeric>

#include "colors/TslHistogram.h"

namespace gt {
namespace {

/// The class of a color's neighbors that have one; noColor if they differ.
ColorClass neighborsClass(const ColorTable64& table, std::size_t color) {
  const int y = static_cast<int>(color >> 12), cb = color >> 6 & 63, cr = color & 63;
  ColorClass found = ColorClass::noColor;
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, 63); ++ny)
    for (int nb = std::max(cb - 1, 0); nb <= std::min(cb + 1, 63); ++nb)
      for (int nr = std::max(cr - 1, 0); nr <= std::min(cr + 1, 63); ++nr) {
        const ColorClass c = table.classes[static_cast<std::size_t>(ny << 12 | nb << 6 | nr)];
        if (c == ColorClass::noColor || c == found) continue;
        if (found != ColorClass::noColor) return ColorClass::noColor;
        found = c;
      }
  return found;
}

std::uint64_t sum(const EnumArray<ColorClass, std::uint32_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

}  // namespace

ColorStatistics::ColorStatistics() : counts_(ColorTable64{}.classes.size()) {}

ColorTable64 ColorStatistics::table(int growth, std::uint32_t leastPixels) const {
  ColorTable64 table;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const auto best = std::max_element(counts_[i].begin(), counts_[i].end());
    const std::uint64_t all = sum(counts_[i]);
    if (all >= std::max(leastPixels, 1u) && 10ull * *best >= 7 * all)
      table.classes[i] = static_cast<ColorClass>(best - counts_[i].begin());
  }
  for (int i = 0; i < growth; ++i) grow(table, leastPixels);
  return table;
}

void ColorStatistics::grow(ColorTable64& table, std::uint32_t leastPixels) const {
  const ColorTable64 before = table;
  const auto seen = [&](std::size_t i) {
    return *std::max_element(counts_[i].begin(), counts_[i].end()) >= std::max(leastPixels, 1u);
  };
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (before.classes[i] == ColorClass::noColor && !seen(i))
      table.classes[i] = neighborsClass(before, i);
}

template <typename Visit>
void ColorStatistics::forEachColor(Visit visit) const {
  const auto middle = [](std::size_t cube) { return 4.0 * static_cast<double>(cube) + 1.5; };
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (sum(counts_[i]) > 0)
      visit(rgbOf(middle(i >> 12), middle(i >> 6 & 63), middle(i & 63)), counts_[i]);
}

TslColors ColorStatistics::tsl(double share) const {
  EnumArray<ColorClass, TslHistogram> histograms;
  forEachColor([&](const Rgb& color, const Counts& counts) {
    for (std::size_t c = 1; c < counts.size(); ++c)
      if (counts.values[c] > 0) histograms.values[c].add(tslOf(color), counts.values[c]);
  });
  TslColors colors;
  for (std::size_t c = 1; c < colors.classes.size(); ++c)
    colors.classes.values[c] = histograms.values[c].thresholds(share);
  setPriorities(colors);
  return colors;
}

void ColorStatistics::setPriorities(TslColors& colors) const {
  EnumArray<ColorClass, std::uint64_t> own, all;
  forEachColor([&](const Rgb& color, const Counts& counts) {
    const Tsl tsl = tslOf(color);
    for (std::size_t c = 1; c < counts.size(); ++c) {
      if (!colors.classes.values[c].contains(tsl)) continue;
      own.values[c] += counts.values[c];
      all.values[c] += sum(counts);
    }
  });
  const auto purity = [&](ColorClass c) {
    return static_cast<double>(own[c]) / static_cast<double>(std::max<std::uint64_t>(all[c], 1));
  };
  std::vector<ColorClass> order = colors.order();
  std::ranges::stable_sort(order, std::greater{}, purity);
  for (std::size_t i = 0; i < order.size(); ++i)
    colors.classes[order[i]].priority = static_cast<int>(i + 1);
}

HsiColors ColorStatistics::hsi(double share) const {
  struct Histogram {
    ChannelHistogram hue{360, true}, saturation{101}, intensity{101};
  };
  EnumArray<ColorClass, Histogram> histograms;
  forEachColor([&](const Rgb& color, const Counts& counts) {
    const Hsi hsi = hsiOf(color);
    for (std::size_t c = 1; c < counts.size(); ++c) {
      if (counts.values[c] == 0) continue;
      histograms.values[c].hue.add(hsi.hue, counts.values[c]);
      histograms.values[c].saturation.add(hsi.saturation, counts.values[c]);
      histograms.values[c].intensity.add(hsi.intensity, counts.values[c]);
    }
  });
  HsiColors colors;
  for (std::size_t c = 1; c < colors.ranges.size(); ++c) {
    const auto& [hue, saturation, intensity] = histograms.values[c];
    if (hue.total() == 0) continue;
    HsiRange& range = colors.ranges.values[c];
    range = {hue.narrowest(share), saturation.narrowest(share), intensity.narrowest(share)};
    if (circularWidth(range.hue, 360) <= 180) continue;
    range.hue = {0, 360};  // grays, as in TslHistogram
    range.saturation[0] = 0;
  }
  return colors;
}

}  // namespace gt
