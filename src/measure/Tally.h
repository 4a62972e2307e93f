#pragma once
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/Statistics.h"

namespace gt {

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

    double mean() const { return gt::mean(values); }
    double meanSize() const { return gt::mean(sizes()); }
    /// The size that a share (0 .. 1) of the errors does not exceed.
    double size(double share) const { return quantile(sizes(), share); }

   private:
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
