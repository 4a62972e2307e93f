#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// The upper or lower limit that a figure should meet.
struct Aim {
  enum class Kind { none, atMost, atLeast };
  Kind kind = Kind::none;
  double value = 0;

  static Aim atMost(double value) { return {Kind::atMost, value}; }
  static Aim atLeast(double value) { return {Kind::atLeast, value}; }
  bool met(double figure) const { return kind == Kind::atMost ? figure <= value : figure >= value; }
  bool operator==(const Aim&) const = default;

  static constexpr auto fields() { return Fields{field<&Aim::kind>(), field<&Aim::value>()}; }
};
static_assert(complete<Aim>);

/// A measured figure: the mean over its runs (seeds or repetitions), and their distribution.
struct Figure {
  std::string name, unit;
  double value = 0;
  std::size_t n = 0;
  double low = 0, high = 0, median = 0, p95 = 0;
  Aim aim;
  std::vector<double> runs;  ///< The raw values; empty for a ratio of two figures.
  /// The seeds of the runs with the lowest and the highest value; empty if the runs have none.
  std::optional<std::uint64_t> lowSeed{}, highSeed{};
};

/// Measured figures, each with one stable name whose first word is its group.
class Figures {
 public:
  /// Adds a figure with one value for each run. Without runs nothing is added. `seeds` are those of
  /// the runs, if they have seeds.
  void add(std::string name, std::string unit, const std::vector<double>& runs, Aim aim = {},
           const std::vector<std::uint64_t>& seeds = {});
  /// Adds the ratio of a figure to another one, if both were added before.
  void addRatio(std::string name, std::string_view figure, std::string_view to, Aim aim = {});

  const std::vector<Figure>& all() const { return figures_; }
  /// Returns the figure with a name; null if there is none.
  const Figure* find(std::string_view name) const;

  /// Prints a table. The lowest and the highest value are followed by the seeds that caused them.
  void print() const;
  /// A JSON array of objects: name, value, unit, n, low, high, median, p95, runs; if there is an
  /// aim, also aim and met; if there are seeds, also lowSeed and highSeed.
  std::string json() const;
  /// Writes `json` to a file; creates its folder if necessary.
  Result<void> write(const std::string& path) const;

 private:
  std::vector<Figure> figures_;
};

}  // namespace gt
