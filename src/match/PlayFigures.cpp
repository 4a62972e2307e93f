#include "match/PlayFigures.h"

#include "base/Statistics.h"

namespace gt {

void PlayFigures::spread(const std::string& name, const std::string& unit,
                         const std::vector<double>& values) {
  if (values.empty()) return;
  add(name + ".mean", unit, mean(values));
  add(name + ".median", unit, quantile(values, 0.5));
  add(name + ".p95", unit, quantile(values, 0.95));
  add(name + ".worst", unit, quantile(values, 1));
}

}  // namespace gt
