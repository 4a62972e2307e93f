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

/// One of two compared sides: the representations of a robot over time, either as recorded or as
/// computed again.
class ComparedSide {
 public:
  /// Receives a representation as CDR; `input` is set if it came from the robot's platform.
  using Handler = std::function<void(const RepresentationType& type, bool input, Time time,
                                     std::span<const std::byte> bytes)>;

  virtual ~ComparedSide() = default;
  /// Calls the handler for the data of the next moment. Returns false at the end.
  virtual Result<bool> next(const Handler& handle) = 0;
  /// Time of the moment that was handled last; the log's begin if there was none.
  virtual Time now() const = 0;
  virtual Time begin() const = 0;
  virtual Time end() const = 0;
  /// Parts skipped so far, because they are damaged or unreadable.
  virtual std::vector<Error> lost() const { return {}; }
};

/// A log as recorded. Types that have changed since are read by the schemas in the log.
Result<std::unique_ptr<ComparedSide>> recordedSide(const std::string& log);

/// Whether messages of a type are compared. Representations are compared, except those that depend
/// on the machine's clock or the location of files.
bool isCompared(const RepresentationType& type);

/// A number, boolean, enumeration or text of a representation that differs between two sides.
struct DifferentValue {
  /// The values of both sides at one time. Texts have no numbers.
  struct Point {
    Time time;
    double a = 0, b = 0;
  };

  std::string path;             ///< Such as BallModel.position.x.
  std::uint64_t different = 0;  ///< Number of differences.
  Time first;
  std::string firstA, firstB;  ///< Values of both sides at the first difference.
  double largest = 0;          ///< Largest difference of numbers.
  Time largestAt;              ///< Time of the largest difference.
  std::vector<Point> points;   ///< Differences over time, up to a limit.
};

/// A representation on both sides.
struct ComparedTopic {
  std::string name;
  bool input = false;  ///< Whether the robot's platform sent it.
  std::uint64_t onlyA = 0, onlyB = 0;
  std::uint64_t compared = 0;   ///< Number of times at which both sides have it.
  std::uint64_t different = 0;  ///< Number of times at which they differ.
  std::vector<Time> times;      ///< Times at which they differ.
  std::vector<DifferentValue> values;

  bool same() const { return different == 0 && onlyA == 0 && onlyB == 0; }
};

/// The differences between two sides.
struct LogComparison {
  Time begin, end;
  std::vector<ComparedTopic> topics;  ///< Sorted by name; inputs only if both sides have them.
  bool stopped = false;               ///< Whether the comparison was stopped before the end.
  std::vector<Error> lost{};          ///< Parts skipped because they are unreadable.
};

/// Compares two sides bit by bit, each value at each time. `progress` is called with the share that
/// is done (0 .. 1) and returns false to stop; the result up to then is returned.
Result<LogComparison> compareSides(ComparedSide& a, ComparedSide& b,
                                   const std::function<bool(double share)>& progress);

}  // namespace gt
