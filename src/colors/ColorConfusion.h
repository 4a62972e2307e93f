#pragma once
#include <cstdint>
#include <string>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// How often colors of one class are taken for which other one: a confusion matrix.
class ColorConfusion {
 public:
  void add(ColorClass actual, ColorClass predicted, std::uint64_t times = 1) {
    counts_[actual][predicted] += times;
  }
  std::uint64_t count(ColorClass actual, ColorClass predicted) const {
    return counts_[actual][predicted];
  }

  /// How many are of a class, and how many are classified as it.
  std::uint64_t actualCount(ColorClass colorClass) const;
  std::uint64_t predictedCount(ColorClass colorClass) const;
  std::uint64_t total() const;

  /// The share of what is classified as a class that is of it; 1 if nothing is.
  double precision(ColorClass colorClass) const;
  /// The share of what is of a class that is classified so; 1 if nothing is of it.
  double recall(ColorClass colorClass) const;
  /// The share of all that is classified correctly.
  double accuracy() const;

  /// As lines for people: a row for each class that there is, with its precision and recall.
  std::string text(const std::string& rows, const std::string& columns) const;

 private:
  EnumArray<ColorClass, EnumArray<ColorClass, std::uint64_t>> counts_;
};

/// How two tables agree about all colors: the first one's classes are the truth.
ColorConfusion compareTables(const ColorTable64& a, const ColorTable64& b);

}  // namespace gt
