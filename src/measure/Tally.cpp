#include "measure/Tally.h"

namespace gt {

std::array<SummaryValue, 4> summaryOf(const std::vector<double>& sizes) {
  return {{{"mean", mean(sizes)},
           {"median", quantile(sizes, 0.5)},
           {"p95", quantile(sizes, 0.95)},
           {"worst", quantile(sizes, 1)}}};
}

}  // namespace gt
