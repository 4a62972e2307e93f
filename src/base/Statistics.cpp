#include "base/Statistics.h"

#include <algorithm>
#include <numeric>

namespace gt {

void RunningStatistics::add(const RunningStatistics& other) {
  if (other.count_ == 0) return;
  const double difference = other.mean_ - mean_;
  const auto ours = static_cast<double>(count_), theirs = static_cast<double>(other.count_);
  count_ += other.count_;
  mean_ += difference * theirs / (ours + theirs);
  squares_ += other.squares_ + difference * difference * ours * theirs / (ours + theirs);
  low_ = std::min(low_, other.low_);
  high_ = std::max(high_, other.high_);
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), below, values.end());
  if (below + 1 == values.end()) return *below;
  const double next = *std::min_element(below + 1, values.end());
  return std::lerp(*below, next, place - std::floor(place));
}

}  // namespace gt
