#include "colors/ChannelHistogram.h"

#include <algorithm>
#include <cmath>

namespace gt {

ColorRange ChannelHistogram::narrowest(double share) const {
  const std::size_t size = counts_.size();
  if (total_ == 0) return nothing(static_cast<int>(size) - 1);
  const auto wanted = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total_) - 1e-9)));
  // A window slides over the channel; on a circle it may begin anywhere and lead across zero.
  std::size_t bestFrom = 0, bestWidth = size, to = 0;
  std::uint64_t held = 0, bestHeld = total_;
  for (std::size_t from = 0; from < size; ++from) {
    while (held < wanted && to < (circular_ ? from + size : size)) held += counts_[to++ % size];
    if (held < wanted) break;
    const std::size_t width = to - from;
    if (width < bestWidth || (width == bestWidth && held > bestHeld)) {
      bestFrom = from;
      bestWidth = width;
      bestHeld = held;
    }
    held -= counts_[from];
  }
  return {static_cast<int>(bestFrom), static_cast<int>((bestFrom + bestWidth - 1) % size)};
}

}  // namespace gt
