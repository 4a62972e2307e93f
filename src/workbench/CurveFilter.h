#pragma once
#include <deque>
#include <optional>
#include <utility>

#include "base/Enum.h"

namespace gt {

/// The filters of a value over time.
enum class CurveFilterKind { none, derivative, mean200ms, mean1s };

/// Filters a value point by point.
class CurveFilter {
 public:
  explicit CurveFilter(CurveFilterKind kind = CurveFilterKind::none) : kind_{kind} {}

  CurveFilterKind kind() const { return kind_; }
  /// The filtered value at a time (s), which is not before the last one. Empty if it is not known
  /// yet: there is no derivative (1/s) at the first point.
  std::optional<double> take(double time, double value) {
    if (kind_ == CurveFilterKind::none) return value;
    if (kind_ == CurveFilterKind::derivative) {
      const auto before = std::exchange(last_, std::pair{time, value});
      if (!before || time <= before->first) return std::nullopt;
      return (value - before->second) / (time - before->first);
    }
    const double length = kind_ == CurveFilterKind::mean200ms ? 0.2 : 1;
    window_.emplace_back(time, value);
    // The sum is computed anew, so that rounding errors do not accumulate.
    while (window_.front().first < time - length) window_.pop_front();
    double sum = 0;
    for (const auto& [at, known] : window_) sum += known;
    return sum / static_cast<double>(window_.size());
  }

 private:
  CurveFilterKind kind_;
  std::optional<std::pair<double, double>> last_;
  std::deque<std::pair<double, double>> window_;
};

}  // namespace gt
