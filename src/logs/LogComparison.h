#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "framework/Representation.h"

namespace gt {

/// One of two sides that are compared: the representations of a robot over time, as they were
/// recorded or as they are computed anew.
class ComparedSide {
 public:
  /// Takes a representation as CDR; `input` if it came from the robot's platform.
  using Handler = std::function<void(const RepresentationType& type, bool input, Time time,
                                     std::span<const std::byte> bytes)>;

  virtual ~ComparedSide() = default;
  /// Hands over what belongs to the next moment; false at the end.
  virtual Result<bool> next(const Handler& handle) = 0;
  /// When that moment was; the begin if none was handed over yet.
  virtual Time now() const = 0;
  virtual Time begin() const = 0;
  virtual Time end() const = 0;
  /// What was left out so far, since it is damaged or cannot be read.
  virtual std::vector<Error> lost() const { return {}; }
};

/// A log as it was recorded. Types that have changed since are read by the schemas in the log.
Result<std::unique_ptr<ComparedSide>> recordedSide(const std::string& log);

/// Whether messages of a type are compared: representations, but nothing that depends on the
/// machine's clock or on where files lie.
bool isCompared(const RepresentationType& type);

/// A number, truth value, enumeration or text of a representation in which two sides differ.
struct DifferentValue {
  /// Both sides at one time. Texts have no numbers.
  struct Point {
    Time time;
    double a = 0, b = 0;
  };

  std::string path;             ///< Such as BallModel.position.x.
  std::uint64_t different = 0;  ///< How often.
  Time first;
  std::string firstA, firstB;  ///< Both sides at the first time.
  double largest = 0;          ///< The largest difference of numbers,
  Time largestAt;              ///< and when it was.
  std::vector<Point> points;   ///< As long as there is room for them.
};

/// A representation on both sides.
struct ComparedTopic {
  std::string name;
  bool input = false;  ///< Sent by the robot's platform.
  std::uint64_t onlyA = 0, onlyB = 0;
  std::uint64_t compared = 0;   ///< Times at which both sides have it,
  std::uint64_t different = 0;  ///< and at how many of them they differ.
  std::vector<Time> times;      ///< When they differ.
  std::vector<DifferentValue> values;

  bool same() const { return different == 0 && onlyA == 0 && onlyB == 0; }
};

/// Where two sides differ.
struct LogComparison {
  Time begin, end;
  std::vector<ComparedTopic> topics;  ///< By name; inputs only if both sides have them.
  bool stopped = false;               ///< Not all was compared.
  std::vector<Error> lost{};          ///< What was left out, since it cannot be read.
};

/// Compares two sides bit by bit, at each time value by value. `progress` is called with the share
/// that is done, and returns false to stop; what was compared until then is returned.
Result<LogComparison> compareSides(ComparedSide& a, ComparedSide& b,
                                   const std::function<bool(double share)>& progress);

}  // namespace gt
