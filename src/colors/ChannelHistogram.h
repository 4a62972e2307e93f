#pragma once
#include <cstdint>
#include <vector>

#include "colors/ColorRanges.h"

namespace gt {

/// A histogram of the values of one channel, from which thresholds are derived.
class ChannelHistogram {
 public:
  /// A channel with the values 0 to size - 1, which may be circular.
  explicit ChannelHistogram(int size, bool circular = false)
      : counts_(static_cast<std::size_t>(size)), circular_(circular) {}

  void add(int value, std::uint64_t times = 1) {
    counts_[static_cast<std::size_t>(value)] += times;
    total_ += times;
  }
  const std::vector<std::uint64_t>& counts() const { return counts_; }
  std::uint64_t total() const { return total_; }

  /// The narrowest range that contains at least a share (above 0, up to 1) of the counted values;
  /// of equally narrow ranges the one that contains most. If nothing was counted, the range is
  /// empty.
  ColorRange narrowest(double share) const;

 private:
  std::vector<std::uint64_t> counts_;
  bool circular_;
  std::uint64_t total_ = 0;
};

}  // namespace gt
