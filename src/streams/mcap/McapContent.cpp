#include "streams/mcap/McapContent.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>

namespace gt::mcap {
namespace {

/// Messages outside of chunks that are read together, in bytes.
constexpr std::uint64_t largestRun = 1u << 20;
/// Damage that is reported one by one.
constexpr std::size_t mostDamage = 1000;

/// What follows the known fields of a record.
Bytes restOf(Taker& content) {
  const auto rest = content.bytes(content.left());
  return {rest.begin(), rest.end()};
}

/// Finds a schema or channel among those in the order of their ids.
template <typename T>
const T* byId(const std::vector<T>& all, std::uint16_t id) {
  const auto at = std::ranges::lower_bound(all, id, {}, &T::id);
  return at != all.end() && at->id == id ? &*at : nullptr;
}

/// Inserts one there, if there is none of its id.
template <typename T>
void insertById(std::vector<T>& all, T one) {
  const auto place = std::ranges::lower_bound(all, one.id, {}, &T::id);
  if (place == all.end() || place->id != one.id) all.insert(place, std::move(one));
}

}  // namespace

void LogContent::note(std::string field, std::string what) {
  const auto isSame = [&](const Error& e) { return e.field == field && e.what == what; };
  if (damage.size() > mostDamage || std::ranges::any_of(damage, isSame)) return;
  if (damage.size() == mostDamage) what = "there is more damage than is listed";
  damage.push_back({.file = path, .field = std::move(field), .what = std::move(what)});
}

void LogContent::note(Segment& damaged, const std::string& what) {
  if (!std::exchange(damaged.damaged, true))
    note(stretchText(damaged.firstTime, damaged.lastTime), what + "; its messages are lost");
}

std::string LogContent::afterLast() const {
  return segments.empty() ? "" : "after " + timeText(segments.back().lastTime);
}

std::optional<RecordHeader> LogContent::headerAt(std::uint64_t offset) {
  Bytes bytes;
  if (!file.read(offset, recordHeaderSize, bytes)) return std::nullopt;
  Taker taker{bytes};
  RecordHeader h;
  h.opcode = taker.number<Opcode>();
  h.length = taker.number<std::uint64_t>();
  if (h.opcode == Opcode{0} || h.length > file.size() - offset - recordHeaderSize)
    return std::nullopt;
  return h;
}

bool LogContent::addHeader(Taker content) {
  McapHeader h;
  h.profile = content.text();
  h.library = content.text();
  h.rest = restOf(content);
  return content.ok() && (header = std::move(h), true);
}

bool LogContent::addSchema(Taker content) {
  McapSchema s;
  s.id = content.number<std::uint16_t>();
  s.name = content.text();
  s.encoding = content.text();
  s.text = content.text();
  s.rest = restOf(content);
  if (!content.ok()) return false;
  if (const McapSchema* known = byId(schemas, s.id);
      known &&
      std::tie(known->name, known->encoding, known->text) != std::tie(s.name, s.encoding, s.text))
    note("schema " + std::to_string(s.id), "is written in two ways; the first one counts");
  insertById(schemas, std::move(s));
  return true;
}

bool LogContent::addChannel(Taker content) {
  McapChannel c;
  c.id = content.number<std::uint16_t>();
  c.schema = content.number<std::uint16_t>();
  c.topic = content.text();
  c.messageEncoding = content.text();
  c.metadata = content.map();
  c.rest = restOf(content);
  if (!content.ok()) return false;
  const McapChannel* known = byId(channels, c.id);
  if (known && std::tie(known->schema, known->topic, known->messageEncoding, known->metadata) !=
                   std::tie(c.schema, c.topic, c.messageEncoding, c.metadata))
    note("channel " + std::to_string(c.id), "is written in two ways; the first one counts");
  insertById(channels, std::move(c));
  return true;
}

bool LogContent::addMetadata(Taker content) {
  McapMetadata m;
  m.name = content.text();
  m.entries = content.map();
  m.rest = restOf(content);
  return content.ok() && (metadata.push_back(std::move(m)), true);
}

bool LogContent::addAttachment(std::span<const std::byte> content) {
  Taker taker{content};
  McapAttachment a;
  a.time = taker.number<std::uint64_t>();
  a.createTime = taker.number<std::uint64_t>();
  a.name = taker.text();
  a.mediaType = taker.text();
  const auto data = taker.bytes(taker.number<std::uint64_t>());
  const std::size_t size = content.size() - taker.left();
  const auto crc = taker.number<std::uint32_t>();
  a.rest = restOf(taker);
  if (!taker.ok()) return false;
  if (crc != 0 && crc != crcOf(content.first(size))) {
    note("attachment " + a.name, "its checksum is wrong; it is lost");
    return true;
  }
  a.data.assign(data.begin(), data.end());
  attachments.push_back(std::move(a));
  return true;
}

bool LogContent::addStatistics(Taker content) {
  McapStatistics s;
  s.messages = content.number<std::uint64_t>();
  s.schemas = content.number<std::uint16_t>();
  s.channels = content.number<std::uint32_t>();
  s.attachments = content.number<std::uint32_t>();
  s.metadata = content.number<std::uint32_t>();
  s.chunks = content.number<std::uint32_t>();
  s.begin = content.number<std::uint64_t>();
  s.end = content.number<std::uint64_t>();
  Taker counts{content.bytes(content.number<std::uint32_t>())};
  while (counts.ok() && !counts.empty()) {
    const auto id = counts.number<std::uint16_t>();
    s.messagesOf[id] = counts.number<std::uint64_t>();
  }
  return content.ok() && counts.ok() && (statistics = std::move(s), true);
}

bool LogContent::add(Opcode opcode, std::span<const std::byte> content) {
  switch (opcode) {
    case Opcode::header:
      return addHeader(Taker{content});
    case Opcode::schema:
      return addSchema(Taker{content});
    case Opcode::channel:
      return addChannel(Taker{content});
    case Opcode::metadata:
      return addMetadata(Taker{content});
    case Opcode::attachment:
      return addAttachment(content);
    case Opcode::statistics:
      return addStatistics(Taker{content});
    default:
      return true;
  }
}

bool LogContent::addFromIndex(Opcode opcode, Taker content) {
  IndexedPlace place;
  std::uint64_t begin = 0;
  if (opcode == Opcode::chunkIndex) {
    place.isChunk = true;
    place.firstTime = content.number<std::uint64_t>();
    place.lastTime = content.number<std::uint64_t>();
    begin = content.number<std::uint64_t>();
    place.length = content.number<std::uint64_t>();
    Taker offsets{content.bytes(content.number<std::uint32_t>())};
    indexNamesChannels_ = indexNamesChannels_ && !offsets.empty();
    while (offsets.ok() && !offsets.empty()) {
      indexedChannels_.insert(offsets.number<std::uint16_t>());
      offsets.number<std::uint64_t>();
    }
    place.indexLength = content.number<std::uint64_t>();
    if (!offsets.ok()) return false;
  } else {
    begin = content.number<std::uint64_t>();
    place.length = content.number<std::uint64_t>();
  }
  if (!content.ok() || begin > file.size() || place.length > file.size() - begin ||
      place.indexLength > file.size() - begin - place.length)
    return false;
  places_[begin] = place;
  return true;
}

/// Reads the index at the file's end, if there is one.
void LogContent::readIndex() {
  constexpr std::uint64_t tail = recordHeaderSize + footerSize + magicSize;
  Bytes bytes;
  const std::uint64_t size = file.size();
  if (size < tail || !file.read(size - tail, tail, bytes) ||
      std::memcmp(bytes.data() + tail - magicSize, magic, magicSize) != 0)
    return;
  Taker footer{bytes};
  const bool isFooter =
      footer.number<Opcode>() == Opcode::footer && footer.number<std::uint64_t>() == footerSize;
  const auto begin = footer.number<std::uint64_t>();
  footer.number<std::uint64_t>();
  const auto crc = footer.number<std::uint32_t>();
  if (!isFooter) return;
  complete = true;
  if (begin == 0) return;
  indexNamesChannels_ = true;
  bool good = begin <= size - tail && file.read(begin, size - magicSize - begin, bytes);
  const std::span<const std::byte> summary{bytes};
  good = good && (crc == 0 || crc == crcOf(summary.first(summary.size() - 4)));
  Taker records{good ? summary.first(summary.size() - recordHeaderSize - footerSize)
                     : summary.first(0)};
  while (good && !records.empty()) {
    const auto opcode = records.number<Opcode>();
    const auto content = records.bytes(records.number<std::uint64_t>());
    const bool isPlace = opcode == Opcode::chunkIndex || opcode == Opcode::attachmentIndex ||
                         opcode == Opcode::metadataIndex;
    if (!isKnown(opcode)) ++unknownInIndex;
    good = records.ok() && (isPlace ? addFromIndex(opcode, Taker{content})
                                    : opcode == Opcode::metadata || opcode == Opcode::attachment ||
                                          add(opcode, content));
  }
  indexed = good;
  if (!good) forgetIndex("the index is damaged; the log was read without it");
}

void LogContent::forgetIndex(const std::string& why) {
  indexed = false;
  damage.clear();
  note({}, why);
  schemas.clear();
  channels.clear();
  places_.clear();
  statistics.reset();
  unknownInIndex = 0;
}

/// Goes through the records from the file's begin to the end of its data, but over what the index
/// lists.
void LogContent::walk() {
  for (std::uint64_t offset = magicSize;;) {
    const auto h = headerAt(offset);
    if (h && h->opcode == Opcode::header) dataBegin_ = offset + h->whole();
    if (h && (h->opcode == Opcode::dataEnd || h->opcode == Opcode::footer)) {
      dataEnd_ = offset;
      if (!indexed) walkIndex(h->opcode == Opcode::footer ? offset : offset + h->whole());
      return;
    }
    if (h && !contradictsIndex(offset, *h)) {
      offset = walkRecord(offset, *h);
      continue;
    }
    const auto behind = passDamage(offset);
    if (!behind) return;
    offset = *behind;
  }
}

/// Whether a record is not what the index says, or claims to be so long that it hides what that
/// names.
bool LogContent::contradictsIndex(std::uint64_t offset, RecordHeader h) const {
  const auto at = places_.find(offset);
  if (at != places_.end() && at->second.isChunk &&
      (h.opcode != Opcode::chunk || at->second.length != h.whole()))
    return true;
  const auto next = places_.upper_bound(offset);
  return next != places_.end() && next->first < offset + h.whole();
}

/// Reports a damaged record and returns where the index names the next one; nothing at the end.
std::optional<std::uint64_t> LogContent::passDamage(std::uint64_t offset) {
  leapt_ = true;
  const auto at = places_.find(offset);
  if (at != places_.end() && at->second.isChunk) {
    const IndexedPlace& place = at->second;
    Segment& lost = segments.emplace_back(
        Segment{offset, place.length, place.firstTime, place.lastTime, true, true});
    note(lost, "there is no chunk where the index says");
    lost.lost = true;
    return offset + place.length + place.indexLength;
  }
  const auto next = places_.upper_bound(offset);
  if (next == places_.end()) {
    if (indexed)
      note(afterLast(), "a record is damaged; what follows is lost");
    else
      note(afterLast(), "the log is cut off; what followed is lost");
    complete = complete && indexed;
    return std::nullopt;
  }
  note(afterLast(), "a record is damaged; it is lost, and so is what is not in the index");
  return next->first;
}

/// Takes what a record holds; returns where the next one begins.
std::uint64_t LogContent::walkRecord(std::uint64_t offset, RecordHeader h) {
  const std::uint64_t behind = offset + h.whole();
  if (h.opcode == Opcode::message) {
    addMessage(offset, h);
  } else if (h.opcode == Opcode::chunk) {
    addChunk(offset, h);
    const auto at = places_.find(offset);
    // Nothing stands between chunks that follow one another by the index.
    if (at != places_.end() && places_.contains(behind + at->second.indexLength))
      return behind + at->second.indexLength;
  } else {
    takeRecord(offset, h);
  }
  return behind;
}

void LogContent::addChunk(std::uint64_t offset, RecordHeader h) {
  Segment s{offset, h.whole()};
  Bytes times;
  if (h.length >= 16 && file.read(offset + recordHeaderSize, 16, times)) {
    Taker taker{times};
    s.firstTime = taker.number<std::uint64_t>();
    s.lastTime = taker.number<std::uint64_t>();
  }
  segments.push_back(s);
}

/// Messages outside of chunks that follow one another are read together.
void LogContent::addMessage(std::uint64_t offset, RecordHeader h) {
  constexpr std::uint64_t beforeTime = 2 + 4;
  Bytes bytes;
  if (h.length < beforeTime + 8 || !file.read(offset + recordHeaderSize, beforeTime + 8, bytes)) {
    note(afterLast(), "a message is damaged; it is lost");
    return;
  }
  const auto time = Taker{std::span{bytes}.subspan(beforeTime)}.number<std::uint64_t>();
  Segment* last = segments.empty() ? nullptr : &segments.back();
  if (last == nullptr || last->isChunk || last->begin + last->length != offset ||
      last->length >= largestRun) {
    segments.push_back({offset, h.whole(), time, time, false});
    return;
  }
  last->length += h.whole();
  last->firstTime = std::min(last->firstTime, time);
  last->lastTime = std::max(last->lastTime, time);
}

void LogContent::takeRecord(std::uint64_t offset, RecordHeader h) {
  Bytes bytes;
  if (h.opcode == Opcode::messageIndex) return;
  if (!file.read(offset + recordHeaderSize, h.length, bytes))
    note(afterLast(), "a record cannot be read; it is lost");
  else if (!isKnown(h.opcode))
    unknown.push_back({static_cast<std::uint8_t>(h.opcode), std::move(bytes)});
  else if (!add(h.opcode, bytes))
    note(afterLast(), "a record is damaged; it is lost");
}

/// Goes through what follows the data of a log whose index cannot be used.
void LogContent::walkIndex(std::uint64_t offset) {
  if (complete && !damage.empty()) return;  // The index is known to be damaged.
  for (auto h = headerAt(offset); h; h = headerAt(offset)) {
    if (!isKnown(h->opcode)) ++unknownInIndex;
    const bool wanted = h->opcode == Opcode::schema || h->opcode == Opcode::channel ||
                        h->opcode == Opcode::statistics;
    if (wanted) takeRecord(offset, *h);
    offset += h->whole();
    if (h->opcode != Opcode::footer) continue;
    Bytes end;
    complete = file.read(offset, magicSize, end) && std::memcmp(end.data(), magic, magicSize) == 0;
    if (!complete)
      note({}, "the last bytes of the log are missing; its messages are whole");
    else if (offset + magicSize != file.size())
      note({}, "something follows the end of the log");
    return;
  }
  complete = false;
  note(afterLast(), "the index is cut off; the messages are whole");
}

bool LogContent::hasDataChecksum() {
  Bytes end, block;
  const auto h = headerAt(dataEnd_);
  if (dataEnd_ == 0 || !h || h->opcode != Opcode::dataEnd || h->length < sizeof(std::uint32_t) ||
      !file.read(dataEnd_ + recordHeaderSize, sizeof(std::uint32_t), end))
    return true;
  const auto stated = Taker{end}.number<std::uint32_t>();
  // Writers do not agree on whether the data begin with the file, behind its first bytes, or behind
  // the header.
  const std::array<std::uint64_t, 3> begins{0, magicSize, dataBegin_};
  std::array<std::uint32_t, 3> sums{};
  for (std::uint64_t at = 0; stated != 0 && at < dataEnd_; at += block.size()) {
    if (!file.read(at, std::min(largestRun, dataEnd_ - at), block)) return false;
    for (std::size_t i = 0; i < begins.size(); ++i)
      if (at + block.size() > begins[i]) {
        const std::uint64_t skip = begins[i] > at ? begins[i] - at : 0;
        sums[i] = crcOf(std::span{block}.subspan(static_cast<std::size_t>(skip)), sums[i]);
      }
  }
  return stated == 0 || std::ranges::find(sums, stated) != sums.end();
}

const McapChannel* LogContent::channel(std::uint16_t id) const {
  return byId(channels, id);
}

/// Whether no chunk can hold a channel or a schema that was not found yet.
bool LogContent::knowsAllChannels() const {
  const bool chunks = std::ranges::any_of(segments, &Segment::isChunk);
  if (!chunks) return true;
  for (const McapChannel& c : channels)
    if (c.schema != 0 && !byId(schemas, c.schema)) return false;
  if (statistics && indexed)
    return statistics->channels == channels.size() && statistics->schemas == schemas.size();
  return indexed && indexNamesChannels_ &&
         std::ranges::all_of(
             segments, [&](const Segment& s) { return !s.isChunk || places_.contains(s.begin); }) &&
         std::ranges::all_of(indexedChannels_, [&](auto id) { return channel(id) != nullptr; });
}

void LogContent::lookIntoChunks() {
  Bytes record, unpacked;
  for (Segment& s : segments) {
    if (!s.isChunk || s.lost) continue;
    if (const auto records = load(s, record, unpacked)) {
      lookInto(s, Taker{*records});
    } else {
      note(s, records.error().what);
      s.lost = true;
    }
  }
}

/// Takes what a chunk holds beside messages.
void LogContent::lookInto(Segment& chunk, Taker records) {
  chunk.looked = true;
  while (records.ok() && !records.empty()) {
    const auto opcode = records.number<Opcode>();
    const auto content = records.bytes(records.number<std::uint64_t>());
    if (!records.ok() || opcode == Opcode::message) continue;
    if (!isKnown(opcode))
      unknown.push_back({static_cast<std::uint8_t>(opcode), Bytes{content.begin(), content.end()}});
    else if ((opcode == Opcode::schema || opcode == Opcode::channel) && !add(opcode, content))
      note(stretchText(chunk.firstTime, chunk.lastTime), "a channel is damaged; it is lost");
  }
}

/// Gives the channels their schemas, and the numbers of their messages.
void LogContent::nameSchemas() {
  for (McapChannel& c : channels) {
    if (statistics) {
      const auto count = statistics->messagesOf.find(c.id);
      if (count != statistics->messagesOf.end()) c.messageCount = count->second;
    }
    if (c.schema == 0) continue;
    if (const McapSchema* known = byId(schemas, c.schema)) {
      c.schemaName = known->name;
      c.schemaEncoding = known->encoding;
      c.schemaText = known->text;
    } else {
      note(c.topic, "its schema is missing");
    }
  }
}

Result<std::unique_ptr<LogContent>> LogContent::survey(const std::string& path, bool useIndex) {
  auto file = LogBytes::open(path);
  if (!file) return file.error();
  auto state = std::make_unique<LogContent>(path, std::move(*file));
  LogContent& s = *state;
  if (s.file.size() == 0) return Error{.file = path, .what = "is empty"};
  Bytes start;
  if (!s.file.read(0, magicSize, start) || std::memcmp(start.data(), magic, magicSize) != 0)
    return Error{.file = path, .what = "is not an MCAP file"};
  s.readIndex();
  if (!useIndex && s.indexed) s.forgetIndex("the index is wrong; the log was read without it");
  s.walk();
  if (!s.knowsAllChannels()) s.lookIntoChunks();
  s.nameSchemas();
  return state;
}

Result<std::unique_ptr<LogContent>> LogContent::survey(const std::string& path) {
  auto content = survey(path, true);
  if (!content || !(*content)->leapt_ || !(*content)->indexed) return content;
  // If all is whole without the index, it is that which is wrong.
  auto without = survey(path, false);
  return without && !(*without)->leapt_ ? std::move(without) : std::move(content);
}

}  // namespace gt::mcap
