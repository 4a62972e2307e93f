#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "streams/Mcap.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// Which messages of a log are meant: those of some topics in a stretch of time.
struct Selection {
  std::vector<std::string> topics;   ///< All if empty.
  std::vector<std::string> without;  ///< But not these.
  std::optional<double> from, to;    ///< Seconds; the end is excluded.

  /// An error if the log has no such topics, or the times are no stretch of time.
  Result<void> check(const McapReader& log, const std::string& path) const;
  bool holds(const McapChannel& channel) const;
  bool holds(std::int64_t time) const;
  /// Calls visit(channel, message) for each such message, in the order of the file, until it
  /// returns an error. A topic that the log does not have is an error, and so is damage.
  using Visitor = std::function<Result<void>(const McapChannel&, const McapMessage&)>;
  Result<void> forEach(const std::string& path, const Visitor& visit) const;
};

/// The definitions of a log's channels, each parsed once.
class Definitions {
 public:
  explicit Definitions(std::string file) : file_{std::move(file)} {}
  /// An error if the channel's messages are not CDR with a schema of ROS 2, or that is damaged.
  Result<const MessageDefinition*> of(const McapChannel& channel);

 private:
  std::string file_;
  std::map<std::uint16_t, MessageDefinition> definitions_;
};

/// Seconds, as people read them; logs have nanoseconds.
inline double seconds(std::int64_t time) {
  return static_cast<double>(time) / 1e9;
}

}  // namespace gt
