#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace gt {

/// Mean, variance and extremes of numbers that come one after another (Welford 1962): no number is
/// kept, and large means take nothing from small variances.
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
  /// As if all that was added to another had been added to this.
  void add(const RunningStatistics& other);
  void clear() { *this = {}; }

  std::size_t count() const { return count_; }
  /// 0 of nothing.
  double mean() const { return mean_; }
  /// Of the numbers themselves; 0 of nothing.
  double variance() const { return count_ > 0 ? squares_ / static_cast<double>(count_) : 0; }
  double standardDeviation() const { return std::sqrt(variance()); }
  /// Infinite of nothing.
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

/// The mean of numbers; 0 of none.
double mean(const std::vector<double>& values);

/// The value below which a share (0 .. 1) of the values lies, linear between two of them: 0.5 is
/// the median, 0.95 the 95th percentile; 0 of none.
double quantile(std::vector<double> values, double share);

}  // namespace gt
