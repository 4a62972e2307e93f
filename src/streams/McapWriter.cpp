#include <stdio_ext.h>
#include <sys/stat.h>
#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>

#include "base/OutputLock.h"
#include "streams/Mcap.h"
#include "streams/McapRecords.h"

namespace gt {

using namespace mcap;

namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
struct CompressorDeleter {
  void operator()(ZSTD_CCtx* compressor) const { ZSTD_freeCCtx(compressor); }
};

struct WrittenChannel {
  std::string topic;
  std::uint32_t messageCount = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  ///< Times and offsets in the chunk.
};

/// Times of the first and the last of several messages.
struct Span {
  std::uint64_t start = 0, end = 0;
  bool empty = true;

  void add(std::uint64_t time) {
    start = empty ? time : std::min(start, time);
    end = empty ? time : std::max(end, time);
    empty = false;
  }
};

}  // namespace

/// What a writer holds: the file, the chunk that is being filled, and what the index will contain.
struct McapWriter::State {
  std::string path;
  McapOptions options;
  std::optional<OutputLock> lock;
  std::unique_ptr<std::FILE, FileCloser> file;
  std::unique_ptr<ZSTD_CCtx, CompressorDeleter> compressor{ZSTD_createCCtx()};
  std::optional<Error> error;
  bool errorTaken = false;
  std::uint64_t size = 0;     ///< Of the file.
  std::uint64_t flushed = 0;  ///< Of the file, as far as the operating system has it.
  std::uint32_t crc = 0;      ///< Of the data section.

  /// Ids by topic and encoding, and by name, encoding and text.
  std::map<std::tuple<std::string, std::string, std::uint16_t>, ChannelId> channelIds;
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schemaIds;
  std::vector<WrittenChannel> channels;  ///< Id is index + 1.

  Bytes chunk, record, compressed;
  Span chunkSpan, span;
  Bytes schemaRecords, channelRecords, chunkIndexes, attachmentIndexes, metadataIndexes;
  std::uint32_t chunkCount = 0, attachmentCount = 0, metadataCount = 0;

  void put(std::span<const std::byte> bytes) {
    if (error || !file || wasSpoiled()) return;
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) return failed();
    size += bytes.size();
    crc = crcOf(bytes, crc);
  }
  void failed() { fail(std::string("cannot be written: ") + strerror(errno)); }
  /// What waits to be written would lie behind what is missing.
  void fail(const std::string& what) {
    if (error) return;
    error = Error{.file = path, .what = what};
    if (file) __fpurge(file.get());
  }
  /// Gives the operating system all that was put so far.
  void handOver() {
    if (file && std::fflush(file.get()) != 0) failed();
    flushed = size;
  }
  /// What followed would lie behind a hole, where no reader gets to, or in a file without a name.
  bool wasSpoiled() {
    struct stat status {};
    if (fstat(fileno(file.get()), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    if (status.st_nlink == 0)
      fail("was removed while it was written");
    else if (static_cast<std::uint64_t>(status.st_size) < flushed)
      fail("was truncated while it was written");
    return error.has_value();
  }

  std::uint16_t addSchema(const McapChannel& channel);
  void putChunk();
  void putMessageIndexes();
  void putSummary();
};

void McapWriter::State::putChunk() {
  if (chunk.empty()) return;
  std::span<const std::byte> records{chunk};
  if (options.compress) {
    compressed.resize(ZSTD_compressBound(chunk.size()));
    const std::size_t n = ZSTD_compressCCtx(compressor.get(), compressed.data(), compressed.size(),
                                            chunk.data(), chunk.size(), options.level);
    assert(ZSTD_isError(n) == 0);
    records = std::span{compressed}.first(n);
  }
  const std::string_view method = options.compress ? "zstd" : "";
  const std::uint64_t begin = size;
  record.clear();
  append(record, Opcode::chunk);
  append(record, std::uint64_t{8 + 8 + 8 + 4 + 4 + method.size() + 8 + records.size()});
  append(record, chunkSpan.start);
  append(record, chunkSpan.end);
  append(record, std::uint64_t{chunk.size()});
  append(record, crcOf(chunk));
  append(record, method);
  append(record, std::uint64_t{records.size()});
  const std::uint64_t length = record.size() + records.size();
  put(record);
  put(records);

  const std::size_t at = beginRecord(chunkIndexes, Opcode::chunkIndex);
  append(chunkIndexes, chunkSpan.start);
  append(chunkIndexes, chunkSpan.end);
  append(chunkIndexes, begin);
  append(chunkIndexes, length);
  putMessageIndexes();
  append(chunkIndexes, method);
  append(chunkIndexes, std::uint64_t{records.size()});
  append(chunkIndexes, std::uint64_t{chunk.size()});
  endRecord(chunkIndexes, at);
  ++chunkCount;
  chunk.clear();
  chunkSpan = {};
  handOver();
}

void McapWriter::State::putMessageIndexes() {
  record.clear();
  const std::uint64_t begin = size;
  std::uint32_t used = 0;
  for (const WrittenChannel& c : channels) used += c.index.empty() ? 0 : 1;
  append(chunkIndexes, used * std::uint32_t{2 + 8});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto& index = channels[i].index;
    if (index.empty()) continue;
    append(chunkIndexes, static_cast<ChannelId>(i + 1));
    append(chunkIndexes, begin + record.size());
    const std::size_t at = beginRecord(record, Opcode::messageIndex);
    append(record, static_cast<ChannelId>(i + 1));
    append(record, static_cast<std::uint32_t>(16 * index.size()));
    append(record, std::as_bytes(std::span{index}));
    endRecord(record, at);
    index.clear();
  }
  put(record);
  append(chunkIndexes, std::uint64_t{record.size()});
}

void McapWriter::State::putSummary() {
  record.clear();
  std::size_t at = beginRecord(record, Opcode::dataEnd);
  append(record, crc);
  endRecord(record, at);
  put(record);

  Bytes statistics;
  at = beginRecord(statistics, Opcode::statistics);
  std::uint64_t messageCount = 0;
  for (const WrittenChannel& c : channels) messageCount += c.messageCount;
  append(statistics, messageCount);
  append(statistics, static_cast<std::uint16_t>(schemaIds.size()));
  append(statistics, static_cast<std::uint32_t>(channels.size()));
  append(statistics, attachmentCount);
  append(statistics, metadataCount);
  append(statistics, chunkCount);
  append(statistics, span.start);
  append(statistics, span.end);
  append(statistics, static_cast<std::uint32_t>(channels.size() * (2 + 8)));
  for (std::size_t i = 0; i < channels.size(); ++i) {
    append(statistics, static_cast<ChannelId>(i + 1));
    append(statistics, std::uint64_t{channels[i].messageCount});
  }
  endRecord(statistics, at);

  const std::uint64_t begin = size;
  record.clear();
  Bytes offsets;
  for (const Bytes* group : {&schemaRecords, &channelRecords, &statistics, &chunkIndexes,
                             &attachmentIndexes, &metadataIndexes}) {
    if (group->empty()) continue;
    at = beginRecord(offsets, Opcode::summaryOffset);
    append(offsets, group->front());
    append(offsets, begin + record.size());
    append(offsets, std::uint64_t{group->size()});
    endRecord(offsets, at);
    append(record, *group);
  }
  const std::uint64_t offsetsBegin = begin + record.size();
  append(record, offsets);
  append(record, Opcode::footer);
  append(record, std::uint64_t{footerSize});
  append(record, begin);
  append(record, offsetsBegin);
  append(record, crcOf(record));
  append(record, std::as_bytes(std::span{magic, magicSize}));
  put(record);
}

McapWriter::McapWriter(std::unique_ptr<State> state) : state_{std::move(state)} {}
McapWriter::McapWriter(McapWriter&&) noexcept = default;
McapWriter& McapWriter::operator=(McapWriter&& other) noexcept {
  if (state_) (void)close();
  state_ = std::move(other.state_);
  return *this;
}
McapWriter::~McapWriter() {
  if (state_) (void)close();
}

Result<McapWriter> McapWriter::open(const std::string& path, const McapOptions& options) {
  auto lock = OutputLock::ofFile(path);
  if (!lock) return lock.error();
  auto state = std::make_unique<State>();
  state->lock = std::move(*lock);
  state->path = path;
  state->options = options;
  state->file.reset(std::fopen(path.c_str(), "wb"));
  if (!state->file)
    return Error{.file = path, .what = std::string("cannot be written: ") + strerror(errno)};
  Bytes& record = state->record;
  append(record, std::as_bytes(std::span{magic, magicSize}));
  const std::size_t at = beginRecord(record, Opcode::header);
  append(record, std::string_view{"ros2"});
  append(record, std::string_view{"gt2003"});
  endRecord(record, at);
  state->put(record);
  return McapWriter{std::move(state)};
}

std::uint16_t McapWriter::State::addSchema(const McapChannel& channel) {
  if (channel.schemaName.empty() && channel.schemaEncoding.empty()) return 0;
  const auto [place, isNew] =
      schemaIds.try_emplace({channel.schemaName, channel.schemaEncoding, channel.schemaText},
                            static_cast<std::uint16_t>(schemaIds.size() + 1));
  if (!isNew) return place->second;
  record.clear();
  const std::size_t at = beginRecord(record, Opcode::schema);
  append(record, place->second);
  append(record, std::string_view{channel.schemaName});
  append(record, std::string_view{channel.schemaEncoding});
  append(record, std::string_view{channel.schemaText});
  endRecord(record, at);
  append(schemaRecords, record);
  put(record);
  return place->second;
}

McapWriter::ChannelId McapWriter::addChannel(const std::string& topic, const Schema& schema) {
  return addChannel(McapChannel{0, topic, "cdr", schema.name, "ros2msg", schema.text, 0});
}

McapWriter::ChannelId McapWriter::addChannel(const McapChannel& channel) {
  State& s = *state_;
  const std::uint16_t schema = s.addSchema(channel);
  const auto [place, isNew] =
      s.channelIds.try_emplace({channel.topic, channel.messageEncoding, schema},
                               static_cast<ChannelId>(s.channels.size() + 1));
  if (!isNew) return place->second;
  assert(s.channels.size() < 0xffff);
  Bytes& record = s.record;
  record.clear();
  const std::size_t at = beginRecord(record, Opcode::channel);
  append(record, place->second);
  append(record, schema);
  append(record, std::string_view{channel.topic});
  append(record, std::string_view{channel.messageEncoding});
  append(record, TextMap{});
  endRecord(record, at);
  append(s.channelRecords, record);
  s.put(record);
  s.channels.push_back({channel.topic, 0, {}});
  return place->second;
}

std::byte* McapWriter::beginMessage(ChannelId channel, std::int64_t time, std::size_t size) {
  State& s = *state_;
  assert(channel >= 1 && channel <= s.channels.size() && time >= 0);
  if (s.chunk.size() >= s.options.chunkSize) s.putChunk();
  WrittenChannel& c = s.channels[channel - 1u];
  const auto t = static_cast<std::uint64_t>(time);
  c.index.emplace_back(t, s.chunk.size());
  s.chunkSpan.add(t);
  s.span.add(t);
  append(s.chunk, Opcode::message);
  append(s.chunk, std::uint64_t{2 + 4 + 8 + 8 + size});
  append(s.chunk, channel);
  append(s.chunk, c.messageCount++);
  append(s.chunk, t);
  append(s.chunk, t);
  s.chunk.resize(s.chunk.size() + size);
  return s.chunk.data() + s.chunk.size() - size;
}

void McapWriter::write(ChannelId channel, std::int64_t time, std::span<const std::byte> message) {
  std::byte* to = beginMessage(channel, time, message.size());
  std::copy(message.begin(), message.end(), to);
}

void McapWriter::metadata(const std::string& name, const Metadata& entries) {
  State& s = *state_;
  Bytes record;
  std::size_t at = beginRecord(record, Opcode::metadata);
  append(record, std::string_view{name});
  append(record, entries);
  endRecord(record, at);
  at = beginRecord(s.metadataIndexes, Opcode::metadataIndex);
  append(s.metadataIndexes, s.size);
  append(s.metadataIndexes, std::uint64_t{record.size()});
  append(s.metadataIndexes, std::string_view{name});
  endRecord(s.metadataIndexes, at);
  ++s.metadataCount;
  s.put(record);
}

void McapWriter::attachment(const std::string& name, const std::string& mediaType, Time time,
                            std::span<const std::byte> data) {
  State& s = *state_;
  const auto t = static_cast<std::uint64_t>(nanoseconds(time));
  Bytes record;
  std::size_t at = beginRecord(record, Opcode::attachment);
  append(record, t);
  append(record, t);
  append(record, std::string_view{name});
  append(record, std::string_view{mediaType});
  append(record, std::uint64_t{data.size()});
  append(record, data);
  append(record, crcOf(std::span{record}.subspan(recordHeaderSize)));
  endRecord(record, at);
  at = beginRecord(s.attachmentIndexes, Opcode::attachmentIndex);
  append(s.attachmentIndexes, s.size);
  append(s.attachmentIndexes, std::uint64_t{record.size()});
  append(s.attachmentIndexes, t);
  append(s.attachmentIndexes, t);
  append(s.attachmentIndexes, std::uint64_t{data.size()});
  append(s.attachmentIndexes, std::string_view{name});
  append(s.attachmentIndexes, std::string_view{mediaType});
  endRecord(s.attachmentIndexes, at);
  ++s.attachmentCount;
  s.put(record);
}

Result<void> McapWriter::flush() {
  state_->putChunk();
  state_->handOver();
  if (state_->error) return *state_->error;
  return {};
}

Result<void> McapWriter::close() {
  State& s = *state_;
  if (s.file) {
    s.putChunk();
    s.putSummary();
    if (std::fclose(s.file.release()) != 0) s.failed();
    s.lock.reset();
  }
  if (s.error) return *s.error;
  return {};
}

std::optional<Error> McapWriter::takeError() {
  if (state_->errorTaken || !state_->error) return std::nullopt;
  state_->errorTaken = true;
  return state_->error;
}

}  // namespace gt
