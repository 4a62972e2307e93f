#pragma once
#include <cstdint>
#include <string>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// A confusion matrix of color classes: how often colors of one class are classified as another.
class ColorConfusion {
 public:
  void add(ColorClass actual, ColorClass predicted, std::uint64_t times = 1) {
    counts_[actual][predicted] += times;
  }
  std::uint64_t count(ColorClass actual, ColorClass predicted) const {
    return counts_[actual][predicted];
  }

  /// The number of samples of a class, and the number of samples that are classified as it.
  std::uint64_t actualCount(ColorClass colorClass) const;
  std::uint64_t predictedCount(ColorClass colorClass) const;
  std::uint64_t total() const;

  /// The share of samples classified as a class that belong to it; 1 if there are none.
  double precision(ColorClass colorClass) const;
  /// The share of samples of a class that are classified as it; 1 if there are none.
  double recall(ColorClass colorClass) const;
  /// The share of all samples that are classified correctly.
  double accuracy() const;

  /// A table for people: a row for each class that occurs, with its precision and recall.
  std::string text(const std::string& rows, const std::string& columns) const;

 private:
  EnumArray<ColorClass, EnumArray<ColorClass, std::uint64_t>> counts_;
};

/// Compares the classes of all colors in two tables; the first table is considered the truth.
ColorConfusion compareTables(const ColorTable64& a, const ColorTable64& b);

}  // namespace gt
