#include <stdio_ext.h>
#include <sys/stat.h>
#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <new>
#include <set>
#include <utility>

#include "base/File.h"
#include "base/Guarded.h"
#include "base/OutputLock.h"
#include "base/UnfinishedFile.h"
#include "streams/mcap/Mcap.h"
#include "streams/mcap/McapRecords.h"

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
  std::uint16_t id = 0;
  std::uint64_t messageCount = 0;
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
  std::optional<UnfinishedFile> unfinished;  ///< If it is written at once.
  McapOptions options;
  std::optional<OutputLock> lock;
  std::unique_ptr<std::FILE, FileCloser> file;
  std::unique_ptr<ZSTD_CCtx, CompressorDeleter> compressor{ZSTD_createCCtx()};
  std::optional<Error> error;
  bool errorTaken = false;
  std::uint64_t size = 0;     ///< Of the file.
  std::uint64_t flushed = 0;  ///< Of the file, as far as the operating system has it.
  std::uint32_t crc = 0;      ///< Of the data section.

  /// Ids of what was added by topic and schema, and by name and text.
  std::map<std::pair<std::string, std::uint16_t>, ChannelId> channelIds;
  std::map<std::pair<std::string, std::string>, std::uint16_t> schemaIds;
  std::set<std::uint16_t> schemas;       ///< Their ids.
  std::vector<WrittenChannel> channels;  ///< In the order in which they were added.
  std::vector<std::uint32_t> channelAt;  ///< By id, where in `channels` it is, from 1; 0: nowhere.

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

  std::uint16_t freeSchema(std::uint16_t wanted);
  ChannelId freeChannel(ChannelId wanted);
  WrittenChannel& channel(ChannelId id) {
    assert(id < channelAt.size() && channelAt[id] != 0);
    return channels[channelAt[id] - 1];
  }
  std::byte* beginMessage(const McapMessage& message, std::size_t length);
  Result<void> close();
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
    if (ZSTD_isError(n) != 0) throw std::bad_alloc{};  // there is room for the result
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
  for (WrittenChannel& c : channels) {
    if (c.index.empty()) continue;
    append(chunkIndexes, c.id);
    append(chunkIndexes, begin + record.size());
    const std::size_t at = beginRecord(record, Opcode::messageIndex);
    append(record, c.id);
    append(record, static_cast<std::uint32_t>(16 * c.index.size()));
    append(record, std::as_bytes(std::span{c.index}));
    endRecord(record, at);
    c.index.clear();
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
  append(statistics, static_cast<std::uint16_t>(schemas.size()));
  append(statistics, static_cast<std::uint32_t>(channels.size()));
  append(statistics, attachmentCount);
  append(statistics, metadataCount);
  append(statistics, chunkCount);
  append(statistics, span.start);
  append(statistics, span.end);
  append(statistics, static_cast<std::uint32_t>(channels.size() * (2 + 8)));
  for (const WrittenChannel& c : channels) {
    append(statistics, c.id);
    append(statistics, c.messageCount);
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
  McapWriter closed{std::exchange(state_, std::move(other.state_))};
  return *this;
}
McapWriter::~McapWriter() {
  if (!state_) return;
  if (!state_->unfinished) (void)close();
}

Result<McapWriter> McapWriter::open(const std::string& path, const McapOptions& options) {
  const std::string written = options.atOnce ? unfinishedName(path) : path;
  auto lock = OutputLock::ofFile(written);
  if (!lock) return Error{.file = path, .what = lock.error().what};
  auto state = std::make_unique<State>();
  state->lock = std::move(*lock);
  state->path = path;
  if (options.atOnce) state->unfinished.emplace(path);
  state->options = options;
  state->file.reset(std::fopen(written.c_str(), "wb"));
  if (!state->file)
    return Error{.file = path, .what = std::string("cannot be written: ") + strerror(errno)};
  Bytes& record = state->record;
  append(record, std::as_bytes(std::span{magic, magicSize}));
  const std::size_t at = beginRecord(record, Opcode::header);
  append(record, std::string_view{options.header.profile});
  append(record, std::string_view{options.header.library});
  append(record, options.header.rest);
  endRecord(record, at);
  state->put(record);
  return McapWriter{std::move(state)};
}

/// An id that no schema has yet: the wanted one, or else the first.
std::uint16_t McapWriter::State::freeSchema(std::uint16_t wanted) {
  if (wanted != 0 && schemas.insert(wanted).second) return wanted;
  for (std::uint16_t id = 1; id != 0; ++id)
    if (schemas.insert(id).second) return id;
  fail("would have more than 65535 schemas");
  return 1;
}

McapWriter::ChannelId McapWriter::State::freeChannel(ChannelId wanted) {
  const auto isFree = [&](std::size_t id) { return id >= channelAt.size() || channelAt[id] == 0; };
  constexpr std::size_t last = 0xffff;
  // Ids are given in order, so the first free one seldom lies before the number of channels.
  std::size_t id = isFree(wanted) ? wanted : channels.size() + 1;
  for (std::size_t i = 0; i <= last && (id > last || !isFree(id)); ++i) id = i;
  if (!isFree(id)) {
    fail("would have more than 65535 channels");
    return channels.front().id;
  }
  channels.push_back({static_cast<ChannelId>(id), 0, {}});
  channelAt.resize(std::max(channelAt.size(), id + 1));
  channelAt[id] = static_cast<std::uint32_t>(channels.size());
  return static_cast<ChannelId>(id);
}

std::uint16_t McapWriter::addSchema(const McapSchema& schema) {
  State& s = *state_;
  const std::uint16_t id = s.freeSchema(schema.id);
  Bytes& record = s.record;
  record.clear();
  const std::size_t at = beginRecord(record, Opcode::schema);
  append(record, id);
  append(record, std::string_view{schema.name});
  append(record, std::string_view{schema.encoding});
  append(record, std::string_view{schema.text});
  append(record, schema.rest);
  endRecord(record, at);
  append(s.schemaRecords, record);
  s.put(record);
  return id;
}

McapWriter::ChannelId McapWriter::addChannel(const std::string& topic, const Schema& schema) {
  State& s = *state_;
  auto& schemaId = s.schemaIds[{schema.name, schema.text}];
  if (schemaId == 0) schemaId = addSchema(McapSchema{0, schema.name, "ros2msg", schema.text});
  const auto [place, isNew] = s.channelIds.try_emplace({topic, schemaId});
  if (isNew) {
    McapChannel channel;
    channel.id = static_cast<ChannelId>(s.channels.size() + 1);
    channel.topic = topic;
    channel.messageEncoding = "cdr";
    channel.schema = schemaId;
    place->second = addChannel(channel);
  }
  return place->second;
}

McapWriter::ChannelId McapWriter::addChannel(const McapChannel& channel) {
  State& s = *state_;
  assert(channel.schema == 0 || s.schemas.contains(channel.schema));
  const ChannelId id = s.freeChannel(channel.id);
  Bytes& record = s.record;
  record.clear();
  const std::size_t at = beginRecord(record, Opcode::channel);
  append(record, id);
  append(record, channel.schema);
  append(record, std::string_view{channel.topic});
  append(record, std::string_view{channel.messageEncoding});
  append(record, channel.metadata);
  append(record, channel.rest);
  endRecord(record, at);
  append(s.channelRecords, record);
  s.put(record);
  return id;
}

std::byte* McapWriter::State::beginMessage(const McapMessage& message, std::size_t length) {
  if (chunk.size() >= options.chunkSize) putChunk();
  WrittenChannel& c = channel(message.channel);
  ++c.messageCount;
  c.index.emplace_back(message.time, chunk.size());
  chunkSpan.add(message.time);
  span.add(message.time);
  append(chunk, Opcode::message);
  append(chunk, std::uint64_t{2 + 4 + 8 + 8 + length});
  append(chunk, message.channel);
  append(chunk, message.sequence);
  append(chunk, message.time);
  append(chunk, message.publishTime);
  chunk.resize(chunk.size() + length);
  return chunk.data() + chunk.size() - length;
}

std::byte* McapWriter::beginMessage(ChannelId channel, std::uint64_t time, std::size_t size) {
  State& s = *state_;
  const auto sequence = static_cast<std::uint32_t>(s.channel(channel).messageCount);
  return s.beginMessage({channel, sequence, time, time, {}}, size);
}

void McapWriter::write(ChannelId channel, std::uint64_t time, std::span<const std::byte> message) {
  std::byte* to = beginMessage(channel, time, message.size());
  std::copy(message.begin(), message.end(), to);
}

void McapWriter::write(ChannelId channel, const McapMessage& message) {
  McapMessage copy = message;
  copy.channel = channel;
  std::byte* to = state_->beginMessage(copy, message.data.size());
  std::copy(message.data.begin(), message.data.end(), to);
}

void McapWriter::metadata(const McapMetadata& metadata) {
  State& s = *state_;
  Bytes record;
  std::size_t at = beginRecord(record, Opcode::metadata);
  append(record, std::string_view{metadata.name});
  append(record, metadata.entries);
  append(record, metadata.rest);
  endRecord(record, at);
  at = beginRecord(s.metadataIndexes, Opcode::metadataIndex);
  append(s.metadataIndexes, s.size);
  append(s.metadataIndexes, std::uint64_t{record.size()});
  append(s.metadataIndexes, std::string_view{metadata.name});
  endRecord(s.metadataIndexes, at);
  ++s.metadataCount;
  s.put(record);
}

void McapWriter::attachment(const std::string& name, const std::string& mediaType, Time time,
                            std::span<const std::byte> data) {
  attachment({name, mediaType, nanoseconds(time), nanoseconds(time), {data.begin(), data.end()}});
}

void McapWriter::attachment(const McapAttachment& attachment) {
  State& s = *state_;
  Bytes record;
  std::size_t at = beginRecord(record, Opcode::attachment);
  append(record, attachment.time);
  append(record, attachment.createTime);
  append(record, std::string_view{attachment.name});
  append(record, std::string_view{attachment.mediaType});
  append(record, std::uint64_t{attachment.data.size()});
  append(record, attachment.data);
  append(record, crcOf(std::span{record}.subspan(recordHeaderSize)));
  append(record, attachment.rest);
  endRecord(record, at);
  at = beginRecord(s.attachmentIndexes, Opcode::attachmentIndex);
  append(s.attachmentIndexes, s.size);
  append(s.attachmentIndexes, std::uint64_t{record.size()});
  append(s.attachmentIndexes, attachment.time);
  append(s.attachmentIndexes, attachment.createTime);
  append(s.attachmentIndexes, std::uint64_t{attachment.data.size()});
  append(s.attachmentIndexes, std::string_view{attachment.name});
  append(s.attachmentIndexes, std::string_view{attachment.mediaType});
  endRecord(s.attachmentIndexes, at);
  ++s.attachmentCount;
  s.put(record);
}

void McapWriter::unknown(const McapUnknownRecord& unknown) {
  Bytes& record = state_->record;
  record.clear();
  const std::size_t at = beginRecord(record, static_cast<Opcode>(unknown.opcode));
  append(record, unknown.content);
  endRecord(record, at);
  state_->put(record);
}

Result<void> McapWriter::flush() {
  state_->putChunk();
  state_->handOver();
  if (state_->error) return *state_->error;
  return {};
}

Result<void> McapWriter::close() {
  return state_->close();
}

Result<void> McapWriter::State::close() {
  if (file) {
    const auto rest = guarded([this]() -> Result<void> {
      putChunk();
      putSummary();
      return {};
    });
    if (!rest) fail(rest.error().text());  // a destructor may not throw
    if (std::fclose(file.release()) != 0) failed();
    if (unfinished && !error)
      if (auto done = unfinished->finish(); !done) error = done.error();
    unfinished.reset();
    lock.reset();
  }
  if (error) return *error;
  return {};
}

std::optional<Error> McapWriter::takeError() {
  if (state_->errorTaken || !state_->error) return std::nullopt;
  state_->errorTaken = true;
  return state_->error;
}

}  // namespace gt
