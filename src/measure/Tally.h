#pragma once
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/Statistics.h"

namespace gt {

/// One number of a summary: mean, median, p95 or worst.
struct SummaryValue {
  const char* name;
  double value;
};

/// What is reported of the sizes of errors: their mean, median, 95th percentile and worst case, so
/// that none of them stands alone. All 0 of none.
std::array<SummaryValue, 4> summaryOf(const std::vector<double>& sizes);

/// What one run counted and measured, by name.
class Tally {
 public:
  /// How often something was right of how often it was asked.
  struct Rate {
    int hits = 0, all = 0;

    double percent() const { return 100.0 * hits / all; }
  };
  /// Errors of one kind; they have a sign.
  struct Errors {
    std::string unit;
    std::vector<double> values;

    /// The mean of the errors with their signs.
    double bias() const { return gt::mean(values); }
    std::vector<double> sizes() const {
      std::vector<double> sizes;
      for (const double v : values) sizes.push_back(std::abs(v));
      return sizes;
    }
  };

  void count(const std::string& name, bool hit) {
    Rate& rate = rates[name];
    rate.hits += hit ? 1 : 0;
    ++rate.all;
  }
  void measure(const std::string& name, const char* unit, double error) {
    Errors& list = errors[name];
    list.unit = unit;
    list.values.push_back(error);
  }

  std::map<std::string, Rate> rates;
  std::map<std::string, Errors> errors;
};

}  // namespace gt
