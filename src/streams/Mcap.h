#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "streams/Binary.h"
#include "streams/Schema.h"

/// Logs as MCAP files (https://mcap.dev/spec), which Foxglove and the tools of ROS 2 open as they
/// are: messages in CDR, schemas as `ros2msg`, compressed chunks, an index at the end.
namespace gt {

/// A point in time as it stands in logs, in nanoseconds since the robot's start; what was before
/// the start is at the start.
constexpr std::int64_t nanoseconds(Time time) {
  return time.ms > 0 ? time.ms * 1'000'000 : 0;
}

/// How a log is written.
struct McapOptions {
  bool compress = true;
  int level = 1;                     ///< Of zstd: 1 fast to 19 small.
  std::size_t chunkSize = 1u << 20;  ///< Bytes after which a chunk is complete.
};

/// A channel of a log.
struct McapChannel {
  std::uint16_t id = 0;
  std::string topic;
  std::string messageEncoding;
  std::string schemaName, schemaEncoding, schemaText;
  std::uint64_t messageCount = 0;  ///< 0 if the log has no index.
};

/// Writes a log, which is locked meanwhile (OutputLock). What was written in whole chunks is
/// readable however the program ends. After an error (a full disk, a file that another program has
/// truncated or removed) nothing more is written; flush() and close() return it. The same calls
/// give the same bytes.
class McapWriter {
 public:
  using ChannelId = std::uint16_t;
  using Metadata = std::map<std::string, std::string>;

  static Result<McapWriter> open(const std::string& path, const McapOptions& options = {});
  McapWriter(McapWriter&&) noexcept;
  McapWriter& operator=(McapWriter&&) noexcept;
  ~McapWriter();  ///< Closes the log.

  /// The channel of a topic; one that was added before with the same schema keeps its channel.
  ChannelId addChannel(const std::string& topic, const Schema& schema);
  /// A channel as it stands in another log, in whatever encoding.
  ChannelId addChannel(const McapChannel& channel);
  template <Streamable T>
  ChannelId addChannel(const std::string& topic) {
    return addChannel(topic, schemaOf<T>());
  }

  /// Appends a message in CDR with its header; the time in nanoseconds, not negative.
  void write(ChannelId channel, std::int64_t time, std::span<const std::byte> message);
  template <Streamable T>
  void write(ChannelId channel, Time time, const T& value) {
    encodeTo(value, beginMessage(channel, nanoseconds(time), encodedSize(value)));
  }
  /// The same by the topic's name, which adds the channel if need be. Per frame, use its id.
  template <Streamable T>
  void write(const std::string& topic, Time time, const T& value) {
    write(addChannel<T>(topic), time, value);
  }

  void metadata(const std::string& name, const Metadata& entries);
  void attachment(const std::string& name, const std::string& mediaType, Time time,
                  std::span<const std::byte> data);

  /// Ends the chunk, so that everything up to here is readable after a crash. Returns the first
  /// error since open().
  Result<void> flush();
  /// Writes the index. Returns the first error since open().
  Result<void> close();
  /// The first error since open(), once: for who reports it as soon as it happens.
  std::optional<Error> takeError();

 private:
  struct State;
  explicit McapWriter(std::unique_ptr<State> state);
  /// Appends a message's begin and returns where its bytes go.
  std::byte* beginMessage(ChannelId channel, std::int64_t time, std::size_t size);

  std::unique_ptr<State> state_;
};

/// A message of a log; the data is valid until the next one is read.
struct McapMessage {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::int64_t time = 0;  ///< In nanoseconds.
  std::span<const std::byte> data;
};

/// Reads a log, by its index if it has one, else (after a crash, on a log cut off) by scanning it
/// up to the last whole chunk. No input crashes it.
class McapReader {
 public:
  struct Metadata {
    std::string name;
    std::map<std::string, std::string> entries;
  };
  struct Attachment {
    std::string name, mediaType;
    std::int64_t time = 0;
    std::vector<std::byte> data;
  };

  static Result<McapReader> open(const std::string& path);
  McapReader(McapReader&&) noexcept;
  McapReader& operator=(McapReader&&) noexcept;
  ~McapReader();

  /// In the order of their ids.
  const std::vector<McapChannel>& channels() const;
  const McapChannel* channel(std::uint16_t id) const;
  const std::vector<Metadata>& metadata() const;
  const std::vector<Attachment>& attachments() const;

  /// Whether the log was closed properly; if not, what follows the last whole record is lost.
  bool complete() const;
  /// What is damaged, if anything is; an error's field is the offset in the file.
  const std::optional<Error>& damage() const;

  /// The next message in the file's order; nothing at the end. After an error (a damaged chunk) the
  /// next call goes on behind it.
  Result<std::optional<McapMessage>> next();
  /// Goes on with the first chunk that holds messages of this time (in nanoseconds) or later ones.
  void seek(std::int64_t time);

 private:
  struct State;
  explicit McapReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gt
