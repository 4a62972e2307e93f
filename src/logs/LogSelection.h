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

/// Which messages of a log are meant: those of some topics in a stretch of time.
struct Selection {
  std::vector<std::string> topics;   ///< All if empty.
  std::vector<std::string> without;  ///< But not these.
  std::optional<double> from, to;    ///< Seconds; the end is excluded.

  /// An error if the log has no such topics, or the times are no stretch of time.
  Result<void> check(const McapReader& log, const std::string& path) const;
  bool holds(const McapChannel& channel) const;
  bool holds(std::uint64_t time) const;
  /// Where a reader can begin: before the first such message.
  std::uint64_t begin() const;
  /// Calls visit(channel, message) for each such message, in the order of the file, until it
  /// returns an error. A topic that the log does not have is an error. Appends what is damaged.
  using Visitor = std::function<Result<void>(const McapChannel&, const McapMessage&)>;
  Result<void> forEach(const std::string& path, const Visitor& visit,
                       std::vector<Error>& damage) const;
  /// The same with messages as JSON. Channels and messages that cannot be read are left out, and
  /// reported for each channel once, with the time that is lost.
  using JsonVisitor =
      std::function<Result<void>(const McapChannel&, std::uint64_t time, const Json& message)>;
  Result<void> forEachJson(const std::string& path, const JsonVisitor& visit,
                           std::vector<Error>& lost) const;
};

/// Collects messages that cannot be read, for one error a channel.
class LostMessages {
 public:
  void add(const McapChannel& channel, std::uint64_t time, const std::string& why);
  /// Of how many of a channel it is known so far.
  std::uint64_t of(const McapChannel& channel) const;
  std::vector<Error> errors(const std::string& file) const;

 private:
  struct Stretch {
    std::string topic, why;  ///< Why the first one cannot be read.
    std::uint64_t count = 0, first = 0, last = 0;
  };
  std::map<std::uint16_t, Stretch> channels_;
};

/// Whether a channel's messages are CDR with a schema of ROS 2, as all of ours.
bool isRos2(const McapChannel& channel);

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
inline double seconds(std::uint64_t time) {
  return static_cast<double>(time) / 1e9;
}

}  // namespace gt
