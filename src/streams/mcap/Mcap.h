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

/// A point in time as stored in logs, in nanoseconds since the robot's start. Times before the
/// start become 0. Times in logs of other programs use all 64 bits.
constexpr std::uint64_t nanoseconds(Time time) {
  return time.ms > 0 ? static_cast<std::uint64_t>(time.ms) * 1'000'000 : 0;
}

/// Formats a time (ns) of a log for people: 12.800 s.
std::string timeText(std::uint64_t nanoseconds);

using McapMap = std::map<std::string, std::string>;
using McapBytes = std::vector<std::byte>;

/// Information of a log about itself.
struct McapHeader {
  std::string profile = "ros2", library = "gt2003";
  McapBytes rest{};  ///< What follows the known fields.
};

/// How a log is written.
struct McapOptions {
  bool compress = true;
  int level = 1;                     ///< Compression level of zstd: 1 is fast, 19 compresses most.
  std::size_t chunkSize = 1u << 20;  ///< Bytes after which a chunk is complete.
  /// If set, the log is written under the name PATH.part until it is closed. A log that is not
  /// closed is removed, and an earlier log of that name is kept.
  bool atOnce = false;
  McapHeader header{};
};

/// A schema of a log.
struct McapSchema {
  std::uint16_t id = 0;
  std::string name, encoding, text;
  McapBytes rest{};  ///< What follows the known fields.
};

/// A channel of a log.
struct McapChannel {
  std::uint16_t id = 0;
  std::string topic;
  std::string messageEncoding;
  std::string schemaName, schemaEncoding, schemaText;  ///< Empty if the log lacks the schema.
  std::uint64_t messageCount = 0;                      ///< 0 if the log has no statistics.
  std::uint16_t schema = 0;                            ///< Id of its schema; 0 if the channel has
                                                       ///< none.
  McapMap metadata{};
  McapBytes rest{};  ///< What follows the known fields.
};

/// A message of a log. The data is valid until the next message is read.
struct McapMessage {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;         ///< When it was recorded, in nanoseconds.
  std::uint64_t publishTime = 0;  ///< When it was sent, in nanoseconds.
  std::span<const std::byte> data;
};

struct McapMetadata {
  std::string name;
  McapMap entries;
  McapBytes rest{};  ///< What follows the known fields.
};

struct McapAttachment {
  std::string name, mediaType;
  std::uint64_t time = 0, createTime = 0;  ///< In nanoseconds.
  McapBytes data{};
  McapBytes rest{};  ///< What follows the known fields.
};

/// A record of a kind that the format does not define (yet), stored unchanged.
struct McapUnknownRecord {
  std::uint8_t opcode = 0;
  McapBytes content{};
};

/// Statistics of a log about its content.
struct McapStatistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
  std::uint64_t begin = 0, end = 0;
  std::map<std::uint16_t, std::uint64_t> messagesOf{};  ///< Number of messages by channel; empty if
                                                        ///< not stated.
};

/// Writes a log, which is locked meanwhile (OutputLock). All complete chunks are readable, however
/// the program ends. After an error (a full disk, a file that another program has truncated or
/// removed) nothing more is written, and flush() and close() return the error. The same calls yield
/// the same bytes.
class McapWriter {
 public:
  using ChannelId = std::uint16_t;
  using Metadata = McapMap;

  static Result<McapWriter> open(const std::string& path, const McapOptions& options = {});
  McapWriter(McapWriter&&) noexcept;
  McapWriter& operator=(McapWriter&&) noexcept;
  ~McapWriter();  ///< Closes the log, or removes it if it is written at once.

  /// Adds a channel for a topic and returns it. If the topic was added before with the same schema,
  /// returns the existing channel.
  ChannelId addChannel(const std::string& topic, const Schema& schema);
  template <Streamable T>
  ChannelId addChannel(const std::string& topic) {
    return addChannel(topic, schemaOf<T>());
  }
  /// Adds a schema, or a channel with a schema of this log (or none), as read from another log.
  /// Keeps the id if that is free. Returns the id.
  std::uint16_t addSchema(const McapSchema& schema);
  ChannelId addChannel(const McapChannel& channel);

  /// Appends a message in CDR with its header; `time` is in nanoseconds.
  void write(ChannelId channel, std::uint64_t time, std::span<const std::byte> message);
  template <Streamable T>
  void write(ChannelId channel, Time time, const T& value) {
    encodeTo(value, beginMessage(channel, nanoseconds(time), encodedSize(value)));
  }
  /// Writes a value by the topic's name and adds the channel if necessary. Prefer the channel's id
  /// for messages that are written in every frame.
  template <Streamable T>
  void write(const std::string& topic, Time time, const T& value) {
    write(addChannel<T>(topic), time, value);
  }
  /// Appends a message of another log, into a channel of this one.
  void write(ChannelId channel, const McapMessage& message);

  void metadata(const McapMetadata& metadata);
  void metadata(const std::string& name, const Metadata& entries) { metadata({name, entries}); }
  void attachment(const McapAttachment& attachment);
  void attachment(const std::string& name, const std::string& mediaType, Time time,
                  std::span<const std::byte> data);
  void unknown(const McapUnknownRecord& record);

  /// Finishes the chunk, so that everything written so far is readable after a crash. Returns the
  /// first error since open().
  Result<void> flush();
  /// Writes the index. Returns the first error since open().
  Result<void> close();
  /// Returns the first error since open(), only once: for callers that report errors immediately.
  std::optional<Error> takeError();

 private:
  struct State;
  explicit McapWriter(std::unique_ptr<State> state);
  /// Appends the header of a message and returns the place for its bytes.
  std::byte* beginMessage(ChannelId channel, std::uint64_t time, std::size_t size);

  std::unique_ptr<State> state_;
};

/// Reads all undamaged parts of a log. Parts that the index does not list are scanned record by
/// record; without an index, the whole file is scanned. Damage only affects the damaged records.
/// Safe on any input.
class McapReader {
 public:
  using Metadata = McapMetadata;
  using Attachment = McapAttachment;

  static Result<McapReader> open(const std::string& path);
  McapReader(McapReader&&) noexcept;
  McapReader& operator=(McapReader&&) noexcept;
  ~McapReader();

  const McapHeader& header() const;
  /// In the order of their ids.
  const std::vector<McapSchema>& schemas() const;
  const std::vector<McapChannel>& channels() const;
  const McapChannel* channel(std::uint16_t id) const;
  const std::vector<Metadata>& metadata() const;
  const std::vector<Attachment>& attachments() const;
  /// Unknown records; those in chunks are included once the chunks have been read.
  const std::vector<McapUnknownRecord>& unknown() const;
  /// How many records of unknown kinds the index holds; they are not read.
  std::size_t unknownInIndex() const;

  /// Whether the log was closed; if not, what follows the last whole record is lost.
  bool complete() const;
  /// Whether the log has an index that is whole.
  bool indexed() const;
  /// Reads the file again and verifies the checksum of all data. Returns false if it is wrong.
  bool hasDataChecksum();
  /// The log's statistics; empty if it has none.
  const std::optional<McapStatistics>& statistics() const;
  std::size_t chunks() const;
  /// All damage found when the log was opened and by next() since then, each once, with the time
  /// range that is lost.
  const std::vector<Error>& damage() const;

  /// Returns the next message in the file's order; empty at the end. Damaged parts are skipped. If
  /// another program changes the log, it ends there.
  std::optional<McapMessage> next();
  /// Continues with the first chunk that contains messages of this time (in nanoseconds) or later.
  void seek(std::uint64_t time);

 private:
  struct State;
  explicit McapReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gt
