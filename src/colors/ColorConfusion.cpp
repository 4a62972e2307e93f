#include "colors/ColorConfusion.h"

#include <cstdio>

namespace gt {
namespace {

double shareOf(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(all);
}

std::string padded(std::string_view text, std::size_t width) {
  std::string result(width > text.size() ? width - text.size() : 0, ' ');
  return result += text;
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f%%", 100 * share);
  return text;
}

}  // namespace

std::uint64_t ColorConfusion::actualCount(ColorClass colorClass) const {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : counts_[colorClass]) sum += n;
  return sum;
}

std::uint64_t ColorConfusion::predictedCount(ColorClass colorClass) const {
  std::uint64_t sum = 0;
  for (const auto& row : counts_) sum += row[colorClass];
  return sum;
}

std::uint64_t ColorConfusion::total() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) sum += actualCount(static_cast<ColorClass>(i));
  return sum;
}

double ColorConfusion::precision(ColorClass colorClass) const {
  return shareOf(counts_[colorClass][colorClass], predictedCount(colorClass));
}

double ColorConfusion::recall(ColorClass colorClass) const {
  return shareOf(counts_[colorClass][colorClass], actualCount(colorClass));
}

double ColorConfusion::accuracy() const {
  std::uint64_t same = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) same += counts_.values[i].values[i];
  return shareOf(same, total());
}

std::string ColorConfusion::text(const std::string& rows, const std::string& columns) const {
  constexpr std::size_t width = 10;
  const auto name = [](std::size_t i) { return enumNames<ColorClass>[i]; };
  const auto exists = [&](std::size_t i) {
    const auto c = static_cast<ColorClass>(i);
    return actualCount(c) + predictedCount(c) > 0;
  };
  std::string text = padded(rows, width);
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (exists(i)) text += padded(name(i), width);
  text += padded("precision", width) + padded("recall", width) + "   columns: " + columns + "\n";
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (!exists(i)) continue;
    text += padded(name(i), width);
    for (std::size_t k = 0; k < counts_.size(); ++k)
      if (exists(k)) text += padded(std::to_string(counts_.values[i].values[k]), width);
    const auto c = static_cast<ColorClass>(i);
    text += padded(predictedCount(c) > 0 ? percent(precision(c)) : "-", width);
    text += padded(actualCount(c) > 0 ? percent(recall(c)) : "-", width) + "\n";
  }
  return text + "the same class: " + percent(accuracy()) + " of " + std::to_string(total()) + "\n";
}

ColorConfusion compareTables(const ColorTable64& a, const ColorTable64& b) {
  ColorConfusion confusion;
  for (std::size_t i = 0; i < a.classes.size(); ++i) confusion.add(a.classes[i], b.classes[i]);
  return confusion;
}

}  // namespace gt
