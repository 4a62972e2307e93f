#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "streams/Json.h"
#include "streams/MessageDefinition.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// Selects messages of a log: those of some topics in a time range.
struct Selection {
  std::vector<std::string> topics;   ///< Selected topics; all if empty.
  std::vector<std::string> without;  ///< Topics that are excluded.
  std::optional<double> from, to;    ///< Time range, in seconds; the end is excluded.

  /// Returns an error if the log lacks a topic, or the time range is invalid.
  Result<void> check(const McapReader& log, const std::string& path) const;
  bool holds(const McapChannel& channel) const;
  bool holds(std::uint64_t time) const;
  /// Time (ns) at which a reader can start, not after the first selected message.
  std::uint64_t begin() const;
  /// Calls visit(channel, message) for each selected message, in the order of the file, until visit
  /// returns an error. A topic that the log lacks is an error. Appends errors for damaged parts.
  using Visitor = std::function<Result<void>(const McapChannel&, const McapMessage&)>;
  Result<void> forEach(const std::string& path, const Visitor& visit,
                       std::vector<Error>& damage) const;
  /// Visits the selected messages as JSON. Unreadable channels and messages are skipped, and
  /// reported once for each channel, with the time range that is lost.
  using JsonVisitor =
      std::function<Result<void>(const McapChannel&, std::uint64_t time, const Json& message)>;
  Result<void> forEachJson(const std::string& path, const JsonVisitor& visit,
                           std::vector<Error>& lost) const;
};

/// Collects unreadable messages, to report one error per channel.
class LostMessages {
 public:
  void add(const McapChannel& channel, std::uint64_t time, const std::string& why);
  /// Number of unreadable messages of a channel so far.
  std::uint64_t of(const McapChannel& channel) const;
  std::vector<Error> errors(const std::string& file) const;

 private:
  struct Stretch {
    std::string topic, why;  ///< Error of the first unreadable message.
    std::uint64_t count = 0, first = 0, last = 0;
  };
  std::map<std::uint16_t, Stretch> channels_;
};

/// Whether a channel's messages are CDR with a schema of ROS 2, as in all logs of this system.
bool isRos2(const McapChannel& channel);

/// Caches the parsed definitions of a log's channels.
class Definitions {
 public:
  explicit Definitions(std::string file) : file_{std::move(file)} {}
  /// Returns an error if the channel's messages are not CDR with a schema of ROS 2, or the schema
  /// is damaged.
  Result<const MessageDefinition*> of(const McapChannel& channel);

 private:
  std::string file_;
  std::map<std::uint16_t, MessageDefinition> definitions_;
};

/// Converts a time of a log (ns) to seconds.
inline double seconds(std::uint64_t time) {
  return static_cast<double>(time) / 1e9;
}

}  // namespace gt
