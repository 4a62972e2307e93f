#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/Statistics.h"

namespace gt {

/// What a figure should be at most or at least.
struct Aim {
  enum class Kind { none, atMost, atLeast } kind = Kind::none;
  double value = 0;

  static Aim atMost(double value) { return {Kind::atMost, value}; }
  static Aim atLeast(double value) { return {Kind::atLeast, value}; }
  bool met(double figure) const { return kind == Kind::atMost ? figure <= value : figure >= value; }
};

/// A measured figure: the mean over its runs (seeds), and how these spread.
struct Figure {
  std::string name, unit;
  double value = 0;
  std::size_t n = 0;
  double low = 0, high = 0, median = 0, p95 = 0;
  Aim aim;
};

/// The measured figures of an experiment, each with one stable name: printed as a table, written as
/// JSON.
class Figures {
 public:
  /// Adds a figure of which each run (seed) gave one value: their mean, the lowest and the highest.
  void add(std::string name, std::string unit, const std::vector<double>& runs, Aim aim = {}) {
    if (runs.empty()) return;
    figures_.push_back({std::move(name), std::move(unit), mean(runs), runs.size(),
                        quantile(runs, 0), quantile(runs, 1), quantile(runs, 0.5),
                        quantile(runs, 0.95), aim});
  }

  /// Adds how many times as large a figure is as another one, both measured before.
  void addRatio(std::string name, std::string_view figure, std::string_view to, Aim aim = {}) {
    const auto of = std::ranges::find(figures_, figure, &Figure::name);
    const auto by = std::ranges::find(figures_, to, &Figure::name);
    if (of == figures_.end() || by == figures_.end()) return;
    Figure f{std::move(name), "times", of->value / by->value, of->n, 0, 0, 0, 0, aim};
    f.low = of->low / by->high;
    f.high = of->high / by->low;
    f.median = of->median / by->median;
    f.p95 = of->p95 / by->p95;
    figures_.push_back(std::move(f));
  }

  const std::vector<Figure>& all() const { return figures_; }

  void print() const {
    fmt::print("{:<52} {:>9} {:<9} {:>4} {:>9} {:>9}  {}\n", "figure", "value", "unit", "n", "low",
               "high", "aim");
    for (const Figure& f : figures_) {
      std::string aim;
      if (f.aim.kind != Aim::Kind::none)
        aim = fmt::format("{} {:g}  {}", f.aim.kind == Aim::Kind::atMost ? "<=" : ">=", f.aim.value,
                          f.aim.met(f.value) ? "met" : "MISSED");
      fmt::print("{:<52} {:>9.1f} {:<9} {:>4} {:>9.1f} {:>9.1f}  {}\n", f.name, f.value, f.unit,
                 f.n, f.low, f.high, aim);
    }
  }

  /// Writes an array of objects; false if the file cannot be written.
  bool write(const std::string& path) const {
    auto list = nlohmann::ordered_json::array();
    for (const Figure& f : figures_) {
      nlohmann::ordered_json object{{"name", f.name},     {"value", f.value}, {"unit", f.unit},
                                    {"n", f.n},           {"low", f.low},     {"high", f.high},
                                    {"median", f.median}, {"p95", f.p95}};
      if (f.aim.kind != Aim::Kind::none) {
        object["aim"] = f.aim.value;
        object["met"] = f.aim.met(f.value);
      }
      list.push_back(std::move(object));
    }
    std::ofstream file{path};
    file << list.dump(2) << '\n';
    return file.good();
  }

 private:
  std::vector<Figure> figures_;
};

}  // namespace gt
