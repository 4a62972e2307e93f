#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "streams/Mcap.h"
#include "streams/McapRecords.h"

namespace gt {

using namespace mcap;

namespace {

/// The largest chunk that is unpacked: a guard against bytes that claim to be enormous.
constexpr std::uint64_t largestChunk = 1u << 28;

/// A stretch of the file that holds messages: a chunk, or messages outside of chunks.
struct Segment {
  std::uint64_t begin = 0, length = 0;  ///< Of whole records.
  std::uint64_t lastTime = 0;
  bool isChunk = true;
};

/// Unpacks an lz4 frame; it must fill the bytes.
Result<void> unpackLz4(std::span<const std::byte> packed, Bytes& bytes) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0)
    return Error{.what = "lz4 has no memory"};
  std::size_t size = bytes.size(), packedSize = packed.size();
  const std::size_t left =
      LZ4F_decompress(context, bytes.data(), &size, packed.data(), &packedSize, nullptr);
  LZ4F_freeDecompressionContext(context);
  if (LZ4F_isError(left) != 0)
    return Error{.what = std::string("the chunk is damaged: ") + LZ4F_getErrorName(left)};
  if (left != 0) return Error{.what = "the chunk is damaged: its end is missing"};
  bytes.resize(size);
  return {};
}

struct RecordHeader {
  Opcode opcode{};
  std::uint64_t length = 0;  ///< Of the content.
};

struct ReadSchema {
  std::string name, encoding, text;
};

}  // namespace

/// What a reader holds: the file, what is known of its content, and the segment that is being read.
struct McapReader::State {
  std::string path;
  std::ifstream file;
  std::uint64_t size = 0;
  bool complete = false;
  std::optional<Error> damage;

  std::map<std::uint16_t, ReadSchema> schemas;
  std::vector<McapChannel> channels;
  std::vector<Metadata> metadata;
  std::vector<Attachment> attachments;
  std::vector<Segment> segments;

  std::size_t nextSegment = 0;
  std::uint64_t segmentBegin = 0;
  Bytes record, unpacked;
  Taker messages{{}};

  Error error(std::uint64_t offset, std::string what) const {
    return {.file = path, .field = std::to_string(offset), .what = std::move(what)};
  }
  bool read(std::uint64_t offset, std::uint64_t length, Bytes& bytes);
  std::optional<RecordHeader> header(std::uint64_t offset);

  std::optional<Error> readStart();
  bool readSummary();
  bool addFromSummary(Opcode opcode, std::span<const std::byte> content);
  bool addIndexed(Opcode expected, std::uint64_t offset, std::uint64_t length);
  void scan();
  void scanRecord(std::uint64_t offset, RecordHeader header);
  bool addSchema(Taker content);
  bool addChannel(Taker content);
  bool addMetadata(Taker content);
  bool addAttachment(std::span<const std::byte> content);
  bool addCounts(Taker content);

  std::optional<Error> load(const Segment& segment);
  Result<void> unpack(Taker chunk);
};

bool McapReader::State::read(std::uint64_t offset, std::uint64_t length, Bytes& bytes) {
  if (offset > size || length > size - offset) return false;
  bytes.resize(static_cast<std::size_t>(length));
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(length));
  return file.gcount() == static_cast<std::streamsize>(length);
}

std::optional<RecordHeader> McapReader::State::header(std::uint64_t offset) {
  Bytes bytes;
  if (!read(offset, recordHeaderSize, bytes)) return std::nullopt;
  Taker taker{bytes};
  RecordHeader h;
  h.opcode = taker.number<Opcode>();
  h.length = taker.number<std::uint64_t>();
  if (h.length > size - offset - recordHeaderSize) return std::nullopt;
  return h;
}

std::optional<Error> McapReader::State::readStart() {
  Bytes start;
  if (!read(0, magicSize, start) || std::memcmp(start.data(), magic, magicSize) != 0)
    return error(0, "is not an MCAP file");
  const auto h = header(magicSize);
  if (!h || h->opcode != Opcode::header) return error(magicSize, "the header is damaged");
  return std::nullopt;
}

bool McapReader::State::addSchema(Taker content) {
  const auto id = content.number<std::uint16_t>();
  ReadSchema s;
  s.name = content.text();
  s.encoding = content.text();
  s.text = content.text();
  return content.ok() && (schemas.try_emplace(id, std::move(s)), true);
}

bool McapReader::State::addChannel(Taker content) {
  McapChannel c;
  c.id = content.number<std::uint16_t>();
  const auto schema = schemas.find(content.number<std::uint16_t>());
  c.topic = content.text();
  c.messageEncoding = content.text();
  content.map();
  if (!content.ok()) return false;
  if (schema != schemas.end()) {
    c.schemaName = schema->second.name;
    c.schemaEncoding = schema->second.encoding;
    c.schemaText = schema->second.text;
  }
  const auto place = std::lower_bound(channels.begin(), channels.end(), c.id,
                                      [](const auto& a, std::uint16_t id) { return a.id < id; });
  if (place == channels.end() || place->id != c.id) channels.insert(place, std::move(c));
  return true;
}

bool McapReader::State::addMetadata(Taker content) {
  Metadata m;
  m.name = content.text();
  m.entries = content.map();
  return content.ok() && (metadata.push_back(std::move(m)), true);
}

bool McapReader::State::addAttachment(std::span<const std::byte> content) {
  Taker taker{content};
  Attachment a;
  a.time = static_cast<std::int64_t>(taker.number<std::uint64_t>());
  taker.number<std::uint64_t>();
  a.name = taker.text();
  a.mediaType = taker.text();
  const auto data = taker.bytes(taker.number<std::uint64_t>());
  const auto crc = taker.number<std::uint32_t>();
  if (!taker.ok() || (crc != 0 && crc != crcOf(content.first(content.size() - 4)))) return false;
  a.data.assign(data.begin(), data.end());
  attachments.push_back(std::move(a));
  return true;
}

bool McapReader::State::addCounts(Taker content) {
  content.bytes(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8);
  Taker counts{content.bytes(content.number<std::uint32_t>())};
  while (counts.ok() && !counts.empty()) {
    const auto id = counts.number<std::uint16_t>();
    const auto count = counts.number<std::uint64_t>();
    for (McapChannel& c : channels)
      if (c.id == id) c.messageCount = count;
  }
  return content.ok() && counts.ok();
}

bool McapReader::State::addIndexed(Opcode expected, std::uint64_t offset, std::uint64_t length) {
  Bytes bytes;
  const auto h = header(offset);
  if (!h || h->opcode != expected || h->length + recordHeaderSize != length) return false;
  if (!read(offset + recordHeaderSize, h->length, bytes)) return false;
  return expected == Opcode::metadata ? addMetadata(Taker{bytes}) : addAttachment(bytes);
}

bool McapReader::State::addFromSummary(Opcode opcode, std::span<const std::byte> content) {
  Taker taker{content};
  switch (opcode) {
    case Opcode::schema:
      return addSchema(taker);
    case Opcode::channel:
      return addChannel(taker);
    case Opcode::statistics:
      return addCounts(taker);
    case Opcode::chunkIndex: {
      Segment s;
      taker.number<std::uint64_t>();
      s.lastTime = taker.number<std::uint64_t>();
      s.begin = taker.number<std::uint64_t>();
      s.length = taker.number<std::uint64_t>();
      segments.push_back(s);
      return taker.ok() && s.begin <= size && s.length <= size - s.begin;
    }
    case Opcode::attachmentIndex:
    case Opcode::metadataIndex: {
      const auto offset = taker.number<std::uint64_t>();
      const auto length = taker.number<std::uint64_t>();
      return taker.ok() &&
             addIndexed(opcode == Opcode::metadataIndex ? Opcode::metadata : Opcode::attachment,
                        offset, length);
    }
    default:
      return true;
  }
}

/// Reads the index at the file's end; false if there is none or it is damaged.
bool McapReader::State::readSummary() {
  constexpr std::uint64_t tail = recordHeaderSize + footerSize + magicSize;
  Bytes bytes;
  if (size < tail || !read(size - tail, tail, bytes) ||
      std::memcmp(bytes.data() + tail - magicSize, magic, magicSize) != 0)
    return false;
  Taker footer{bytes};
  const bool isFooter =
      footer.number<Opcode>() == Opcode::footer && footer.number<std::uint64_t>() == footerSize;
  const auto begin = footer.number<std::uint64_t>();
  footer.number<std::uint64_t>();
  const auto crc = footer.number<std::uint32_t>();
  if (!isFooter || begin == 0 || begin > size - tail) return false;
  if (!read(begin, size - magicSize - begin, bytes)) return false;
  const std::span<const std::byte> summary{bytes};
  if (crc != 0 && crc != crcOf(summary.first(summary.size() - 4))) return false;
  Taker records{summary.first(summary.size() - recordHeaderSize - footerSize)};
  while (!records.empty()) {
    const auto opcode = records.number<Opcode>();
    const auto content = records.bytes(records.number<std::uint64_t>());
    if (!records.ok() || !addFromSummary(opcode, content)) return false;
  }
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return a.begin < b.begin; });
  return !channels.empty() && !segments.empty();
}

/// Goes through all records from the file's begin to its end or to the first damaged one.
void McapReader::State::scan() {
  schemas.clear();
  channels.clear();
  metadata.clear();
  attachments.clear();
  segments.clear();
  for (std::uint64_t offset = magicSize;;) {
    const auto h = header(offset);
    if (!h || h->opcode == Opcode{0}) {
      damage = error(offset, "the log ends within a record");
      return;
    }
    if (h->opcode == Opcode::dataEnd || h->opcode == Opcode::footer) {
      complete = !damage;
      return;
    }
    scanRecord(offset, *h);
    offset += recordHeaderSize + h->length;
  }
}

void McapReader::State::scanRecord(std::uint64_t offset, RecordHeader h) {
  const bool isMessage = h.opcode == Opcode::message;
  if (isMessage || h.opcode == Opcode::chunk) {
    Segment s{offset, recordHeaderSize + h.length, std::numeric_limits<std::uint64_t>::max(),
              !isMessage};
    Segment* last = segments.empty() ? nullptr : &segments.back();
    if (isMessage && last != nullptr && !last->isChunk && last->begin + last->length == offset &&
        last->length < largestChunk)
      last->length += s.length;
    else
      segments.push_back(s);
    if (isMessage) return;
    // Chunks may hold channels; going through one also shows whether it is sound.
    if (auto problem = load(s)) {
      damage = damage ? damage : problem;
      return;
    }
    Taker times{record};
    times.number<std::uint64_t>();
    segments.back().lastTime = times.number<std::uint64_t>();
    while (messages.ok() && !messages.empty()) {
      const auto opcode = messages.number<Opcode>();
      const auto content = messages.bytes(messages.number<std::uint64_t>());
      if (messages.ok() && opcode == Opcode::schema) addSchema(Taker{content});
      if (messages.ok() && opcode == Opcode::channel) addChannel(Taker{content});
    }
    return;
  }
  Bytes bytes;
  const bool wanted = h.opcode == Opcode::schema || h.opcode == Opcode::channel ||
                      h.opcode == Opcode::metadata || h.opcode == Opcode::attachment;
  if (!wanted || !read(offset + recordHeaderSize, h.length, bytes)) return;
  const bool good = h.opcode == Opcode::schema     ? addSchema(Taker{bytes})
                    : h.opcode == Opcode::channel  ? addChannel(Taker{bytes})
                    : h.opcode == Opcode::metadata ? addMetadata(Taker{bytes})
                                                   : addAttachment(bytes);
  if (!good && !damage) damage = error(offset, "a record is damaged");
}

/// Makes the messages of a segment the ones that are read next.
std::optional<Error> McapReader::State::load(const Segment& segment) {
  messages = Taker{{}};
  segmentBegin = segment.begin;
  const std::uint64_t skip = segment.isChunk ? recordHeaderSize : 0;
  const auto h = header(segment.begin);
  if (!h || (segment.isChunk &&
             (h->opcode != Opcode::chunk || h->length + recordHeaderSize != segment.length)))
    return error(segment.begin, "there is no chunk where the index says");
  if (!read(segment.begin + skip, segment.length - skip, record))
    return error(segment.begin, "the log ends within a chunk");
  if (!segment.isChunk) {
    messages = Taker{record};
    return std::nullopt;
  }
  if (const auto done = unpack(Taker{record}); !done)
    return error(segment.begin, done.error().what);
  messages = Taker{unpacked};
  return std::nullopt;
}

Result<void> McapReader::State::unpack(Taker chunk) {
  chunk.number<std::uint64_t>();
  chunk.number<std::uint64_t>();
  const auto unpackedSize = chunk.number<std::uint64_t>();
  const auto crc = chunk.number<std::uint32_t>();
  const std::string compression = chunk.text();
  const auto packed = chunk.bytes(chunk.number<std::uint64_t>());
  if (!chunk.ok()) return Error{.what = "the chunk is damaged"};
  if (unpackedSize > largestChunk)
    return Error{.what = "the chunk claims to be larger than 256 MiB"};
  if (compression.empty()) {
    unpacked.assign(packed.begin(), packed.end());
  } else if (compression == "zstd") {
    unpacked.resize(static_cast<std::size_t>(unpackedSize));
    const std::size_t n =
        ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
    if (ZSTD_isError(n) != 0)
      return Error{.what = std::string("the chunk is damaged: ") + ZSTD_getErrorName(n)};
    unpacked.resize(n);
  } else if (compression == "lz4") {
    unpacked.resize(static_cast<std::size_t>(unpackedSize));
    if (auto done = unpackLz4(packed, unpacked); !done) return done;
  } else {
    return Error{.what = "the compression " + compression + " is not supported, only zstd and lz4"};
  }
  if (unpacked.size() != unpackedSize || (crc != 0 && crc != crcOf(unpacked)))
    return Error{.what = "the chunk's checksum is wrong"};
  return {};
}

McapReader::McapReader(std::unique_ptr<State> state) : state_{std::move(state)} {}
McapReader::McapReader(McapReader&&) noexcept = default;
McapReader& McapReader::operator=(McapReader&&) noexcept = default;
McapReader::~McapReader() = default;

Result<McapReader> McapReader::open(const std::string& path) {
  auto state = std::make_unique<State>();
  state->path = path;
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure))
    return Error{.file = path, .what = "there is no such file"};
  state->size = std::filesystem::file_size(path, failure);
  state->file.open(path, std::ios::binary);
  if (!state->file || failure) return Error{.file = path, .what = "cannot be read"};
  if (auto problem = state->readStart()) return *problem;
  state->complete = state->readSummary();
  if (!state->complete) state->scan();
  state->messages = Taker{{}};
  return McapReader{std::move(state)};
}

const std::vector<McapChannel>& McapReader::channels() const {
  return state_->channels;
}

const McapChannel* McapReader::channel(std::uint16_t id) const {
  for (const McapChannel& c : state_->channels)
    if (c.id == id) return &c;
  return nullptr;
}

const std::vector<McapReader::Metadata>& McapReader::metadata() const {
  return state_->metadata;
}

const std::vector<McapReader::Attachment>& McapReader::attachments() const {
  return state_->attachments;
}

bool McapReader::complete() const {
  return state_->complete;
}

const std::optional<Error>& McapReader::damage() const {
  return state_->damage;
}

Result<std::optional<McapMessage>> McapReader::next() {
  State& s = *state_;
  for (;;) {
    while (s.messages.empty()) {
      if (s.nextSegment >= s.segments.size()) return std::optional<McapMessage>{};
      if (auto problem = s.load(s.segments[s.nextSegment++])) return *problem;
    }
    const auto opcode = s.messages.number<Opcode>();
    Taker content{s.messages.bytes(s.messages.number<std::uint64_t>())};
    McapMessage m;
    if (opcode == Opcode::message) {
      m.channel = content.number<std::uint16_t>();
      m.sequence = content.number<std::uint32_t>();
      m.time = static_cast<std::int64_t>(content.number<std::uint64_t>());
      content.number<std::uint64_t>();
      m.data = content.bytes(content.left());
    }
    if (!s.messages.ok() || !content.ok() ||
        (opcode == Opcode::message && channel(m.channel) == nullptr)) {
      s.messages = Taker{{}};
      return s.error(s.segmentBegin, "the chunk holds a damaged message");
    }
    if (opcode == Opcode::message) return std::optional<McapMessage>{m};
  }
}

void McapReader::seek(std::int64_t time) {
  State& s = *state_;
  s.messages = Taker{{}};
  s.nextSegment = 0;
  while (s.nextSegment < s.segments.size() && time > 0 &&
         s.segments[s.nextSegment].lastTime < static_cast<std::uint64_t>(time))
    ++s.nextSegment;
}

}  // namespace gt
