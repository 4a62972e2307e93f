#pragma once
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/FileDescriptor.h"
#include "base/Result.h"
#include "streams/mcap/Mcap.h"
#include "streams/mcap/McapRecords.h"

/// The content of an MCAP file, as found by McapReader.
namespace gt::mcap {

/// A file with random access. Small reads of adjacent ranges read the file only once.
class LogBytes {
 public:
  static Result<LogBytes> open(const std::string& path);

  std::uint64_t size() const { return size_; }
  /// Returns false if the file does not have these bytes.
  bool read(std::uint64_t offset, std::uint64_t length, Bytes& bytes);
  /// Whether another program has written to the file since it was opened. If `mayGrow`, appending
  /// does not count.
  bool hasChanged(bool mayGrow) const;

 private:
  std::size_t readInto(std::uint64_t offset, Bytes& bytes) const;

  FileDescriptor file_;
  std::uint64_t size_ = 0;
  timespec written_{};
  Bytes window_;
  std::uint64_t windowBegin_ = 0;
};

/// A stretch of the file that holds messages: a chunk, or messages outside of chunks.
struct Segment {
  std::uint64_t begin = 0, length = 0;  ///< Bytes of complete records.
  std::uint64_t firstTime = 0, lastTime = 0;
  bool isChunk = true;
  bool looked = false;   ///< Whether its records other than messages have been read.
  bool damaged = false;  ///< Damage in it has been reported.
  bool lost = false;     ///< Nothing of it can be read.
};

/// A place in the file that the index lists: a chunk, an attachment, metadata.
struct IndexedPlace {
  std::uint64_t length = 0;       ///< Length of the record with its header, in bytes.
  std::uint64_t indexLength = 0;  ///< Length of the message indexes that follow a chunk, in bytes.
  std::uint64_t firstTime = 0, lastTime = 0;
  bool isChunk = false;
};

struct RecordHeader {
  Opcode opcode{};
  std::uint64_t length = 0;  ///< Length of the content, in bytes.

  std::uint64_t whole() const { return recordHeaderSize + length; }
};

/// Whether the format defines records of this kind.
constexpr bool isKnown(Opcode opcode) {
  return opcode >= Opcode::header && opcode <= Opcode::dataEnd;
}

/// Formats a time range for errors.
std::string stretchText(std::uint64_t first, std::uint64_t last);

/// The content of a log other than its messages, and the positions of the messages.
class LogContent {
 public:
  /// Surveys a log by its index, or by scanning it where the index is missing or wrong.
  static Result<std::unique_ptr<LogContent>> survey(const std::string& path);

  LogContent(std::string path_, LogBytes file_) : path{std::move(path_)}, file{std::move(file_)} {}

  /// Reports damage, each once; `field` states the place.
  void note(std::string field, std::string what);
  void note(Segment& damaged, const std::string& what);
  const McapChannel* channel(std::uint16_t id) const;
  /// The records of a segment, which lie in one of the buffers.
  Result<std::span<const std::byte>> load(const Segment& from, Bytes& record, Bytes& unpacked);
  /// Verifies the checksum of the data; true if the log states none.
  bool hasDataChecksum();

  std::string path;
  LogBytes file;
  bool complete = false;
  bool indexed = false;
  std::vector<Error> damage;

  McapHeader header;
  std::vector<McapSchema> schemas;    ///< By id.
  std::vector<McapChannel> channels;  ///< By id.
  std::vector<McapMetadata> metadata;
  std::vector<McapAttachment> attachments;
  std::vector<McapUnknownRecord> unknown;
  std::size_t unknownInIndex = 0;
  std::optional<McapStatistics> statistics;
  std::vector<Segment> segments;

 private:
  static Result<std::unique_ptr<LogContent>> survey(const std::string& path, bool useIndex);
  /// The time of the last message found so far, as text for errors; empty if there are none.
  std::string afterLast() const;

  std::optional<RecordHeader> headerAt(std::uint64_t offset);
  void readIndex();
  void forgetIndex(const std::string& why);
  bool addFromIndex(Opcode opcode, Taker content);
  void walk();
  std::uint64_t walkRecord(std::uint64_t offset, RecordHeader h);
  void walkIndex(std::uint64_t offset);
  std::optional<std::uint64_t> passDamage(std::uint64_t offset);
  bool contradictsIndex(std::uint64_t offset, RecordHeader h) const;
  void addChunk(std::uint64_t offset, RecordHeader h);
  void addMessage(std::uint64_t offset, RecordHeader h);
  void takeRecord(std::uint64_t offset, RecordHeader h);
  bool add(Opcode opcode, std::span<const std::byte> content);
  bool addHeader(Taker content);
  bool addSchema(Taker content);
  bool addChannel(Taker content);
  bool addMetadata(Taker content);
  bool addAttachment(std::span<const std::byte> content);
  bool addStatistics(Taker content);
  bool knowsAllChannels() const;
  void lookIntoChunks();
  void lookInto(Segment& chunk, Taker records);
  void nameSchemas();

  std::uint64_t dataBegin_ = 0, dataEnd_ = 0;     ///< Behind the header, before the end's record.
  std::map<std::uint64_t, IndexedPlace> places_;  ///< By their begin in the file.
  std::set<std::uint16_t> indexedChannels_;       ///< Of which the index names messages.
  bool indexNamesChannels_ = false;               ///< Of all chunks.
  bool leapt_ = false;                            ///< Over damage in the data.
};

}  // namespace gt::mcap
