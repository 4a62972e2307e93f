#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
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

/// The measured figures of an experiment, each with one stable name: printed as a table, written as
/// JSON.
class Figures {
 public:
  /// Adds a figure of which each run (seed) gave one value: their mean, the lowest and the highest.
  void add(std::string name, std::string unit, const std::vector<double>& runs, Aim aim = {}) {
    if (runs.empty()) return;
    Figure f{std::move(name), std::move(unit), 0, runs.size(), 0, 0, aim};
    f.value = mean(runs);
    f.low = *std::min_element(runs.begin(), runs.end());
    f.high = *std::max_element(runs.begin(), runs.end());
    figures_.push_back(std::move(f));
  }

  /// Adds how many times as large a figure is as another one, both measured before.
  void addRatio(std::string name, std::string_view figure, std::string_view to, Aim aim = {}) {
    const auto of = std::ranges::find(figures_, figure, &Figure::name);
    const auto by = std::ranges::find(figures_, to, &Figure::name);
    if (of == figures_.end() || by == figures_.end()) return;
    Figure f{std::move(name), "times", of->value / by->value, of->n, 0, 0, aim};
    f.low = of->low / by->high;
    f.high = of->high / by->low;
    figures_.push_back(std::move(f));
  }

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
      nlohmann::ordered_json object{{"name", f.name}, {"value", f.value}, {"unit", f.unit},
                                    {"n", f.n},       {"low", f.low},     {"high", f.high}};
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
  struct Figure {
    std::string name, unit;
    double value;
    std::size_t n;
    double low, high;
    Aim aim;
  };
  std::vector<Figure> figures_;
};

}  // namespace gt
