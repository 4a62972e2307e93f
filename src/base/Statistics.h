#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace gt {

/// Running mean, variance and extremes of a sequence of numbers (Welford 1962). No number is
/// stored, and the variance stays accurate if it is small compared to the mean.
class RunningStatistics {
 public:
  void add(double x) {
    ++count_;
    const double before = x - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (x - mean_);
    if (x < low_) low_ = x;
    if (x > high_) high_ = x;
  }
  /// Merges the statistics of another sequence into this one.
  void add(const RunningStatistics& other);
  void clear() { *this = {}; }

  std::size_t count() const { return count_; }
  /// Mean; 0 if no number was added.
  double mean() const { return mean_; }
  /// Population variance (divided by the count); 0 if no number was added.
  double variance() const { return count_ > 0 ? squares_ / static_cast<double>(count_) : 0; }
  double standardDeviation() const { return std::sqrt(variance()); }
  /// Smallest number; infinite if none was added.
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

/// Mean of the numbers; 0 if there are none.
double mean(const std::vector<double>& values);

/// The value below which a share (0 .. 1) of the values lies, interpolated linearly between two of
/// them: 0.5 is the median, 0.95 the 95th percentile. 0 if there are no values.
double quantile(std::vector<double> values, double share);

}  // namespace gt
