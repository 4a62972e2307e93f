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

/// The mean, median, 95th percentile and worst case of the absolute values of errors, which are
/// always reported together. All are 0 if there are no errors.
std::array<SummaryValue, 4> summaryOf(const std::vector<double>& sizes);

/// Counts and measurements of one run, by name.
class Tally {
 public:
  /// Number of successes among a number of trials.
  struct Rate {
    int hits = 0, all = 0;

    double percent() const { return 100.0 * hits / all; }
  };
  /// Signed errors of one kind.
  struct Errors {
    std::string unit;
    std::vector<double> values;

    /// Mean of the signed errors.
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
