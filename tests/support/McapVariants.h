#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "streams/mcap/Mcap.h"
#include "streams/mcap/McapRecords.h"

/// Logs of one content in all forms that the MCAP format allows, as other programs write them.
namespace gt::variants {

/// What may differ from log to log.
enum Feature : unsigned {
  chunks = 1,            ///< Messages are in chunks.
  outside = 2,           ///< Some of them are not.
  chunkIndex = 4,        ///< The index lists the chunks.
  messageIndex = 8,      ///< Messages are listed behind their chunk.
  attachmentIndex = 16,  ///< The index lists the attachments.
  statistics = 32,       ///< The index holds statistics.
  repeatSchemas = 64,    ///< The index repeats the schemas.
  repeatChannels = 128,  ///< The index repeats the channels.
  offsets = 256,         ///< The index has offsets of its parts.
  checksums = 512,
  pads = 1024,           ///< Bytes follow the known fields of records.
  endMagic = 2048,       ///< The last bytes are there.
  metadataIndex = 4096,  ///< The index lists the metadata.
  allFeatures = 8191
};

struct Message {
  std::uint16_t channel;
  std::uint32_t sequence;
  std::uint64_t time, publishTime;
  std::string data;
};

/// What is in each of the logs.
struct Content {
  McapHeader header;
  std::vector<McapSchema> schemas;
  std::vector<McapChannel> channels;
  std::vector<Message> messages;
  std::vector<McapMetadata> metadata;
  std::vector<McapAttachment> attachments;
  std::vector<McapUnknownRecord> unknown;
};

inline McapBytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span{text});
  return {bytes.begin(), bytes.end()};
}

/// Has bytes follow the known fields of all that keeps them.
inline void addRests(Content& content) {
  const McapBytes rest = bytesOf("pad");
  content.header.rest = rest;
  for (McapSchema& s : content.schemas) s.rest = rest;
  for (McapChannel& c : content.channels) c.rest = rest;
  for (McapMetadata& m : content.metadata) m.rest = rest;
  for (McapAttachment& a : content.attachments) a.rest = rest;
}

/// Bytes as CDR of the definition "int32 data".
inline std::string number(std::int32_t value) {
  std::string data{"\0\1\0\0", 4};
  return data.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline Content contentOf(unsigned features) {
  const std::string qos = "- history: 3\n  depth: 0\n";
  Content content;
  content.header = {"a profile", "a library 1.0", {}};
  content.schemas = {{3, "own_msgs/msg/Number", "ros2msg", "int32 data\n", {}},
                     {7, "Thing", "jsonschema", "{}", {}}};
  const auto channel = [&](std::uint16_t id, const char* topic, const char* encoding,
                           std::uint16_t schema, McapMap metadata) {
    McapChannel made;
    made.id = id;
    made.topic = topic;
    made.messageEncoding = encoding;
    made.schema = schema;
    made.metadata = std::move(metadata);
    content.channels.push_back(made);
  };
  channel(0, "/a", "cdr", 3, {{"offered_qos_profiles", qos}});
  channel(2, "/a", "cdr", 3, {{"offered_qos_profiles", qos + qos}});
  channel(5, "/json", "json", 7, {});
  channel(9, "/plain", "text", 0, {});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint64_t time =
        i == 3 ? ~std::uint64_t{0} - 1 : 1'000'000'001 * std::uint64_t{i + 1};
    content.messages.push_back({0, 7 + i, time, time - 5, number(static_cast<std::int32_t>(i))});
    content.messages.push_back({2, 70 + i, time, 3, number(-static_cast<std::int32_t>(i))});
    content.messages.push_back({5, i, time, time, "{\"a\": 1}"});
    content.messages.push_back({9, 0, time, time, "text"});
  }
  content.metadata = {{"first", {{"a", "1"}, {"b", ""}}, {}}, {"second", {}, {}}};
  content.attachments = {
      {"note.txt", "text/plain", 1'234'567'891, 2'234'567'892, bytesOf("a note"), {}},
      {"empty", "", 0, 0, {}, {}}};
  content.unknown = {{0x80, bytesOf("private")}};
  if ((features & pads) != 0) addRests(content);
  return content;
}

/// A content as text, for comparison; channels and schemas by what they are, not by their ids.
inline std::string textOf(const Content& content) {
  std::string text;
  const auto put = [&](const auto& part) {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_arithmetic_v<Part>)
      text += std::to_string(part) + " ";
    else
      text += "'" + std::string{reinterpret_cast<const char*>(part.data()), part.size()} + "' ";
  };
  const auto line = [&](const char* kind, const auto&... parts) {
    text += std::string{kind} + " ";
    (put(parts), ...);
    text += "\n";
  };
  const auto putMap = [&](const McapMap& map) {
    for (const auto& [key, value] : map) line(" entry", key, value);
  };
  line("header", content.header.profile, content.header.library, content.header.rest);
  for (const McapSchema& s : content.schemas)
    line("schema", s.id, s.name, s.encoding, s.text, s.rest);
  for (const McapChannel& c : content.channels) {
    line("channel", c.id, c.schema, c.topic, c.messageEncoding, c.rest);
    putMap(c.metadata);
  }
  for (const Message& m : content.messages)
    line("message", m.channel, m.sequence, m.time, m.publishTime, m.data);
  for (const McapMetadata& m : content.metadata) {
    line("metadata", m.name, m.rest);
    putMap(m.entries);
  }
  for (const McapAttachment& a : content.attachments)
    line("attachment", a.name, a.mediaType, a.time, a.createTime, a.data, a.rest);
  for (const McapUnknownRecord& u : content.unknown) line("unknown", u.opcode, u.content);
  return text;
}

/// What a reader finds.
inline Content readContent(McapReader& reader) {
  Content content;
  content.header = reader.header();
  content.schemas = reader.schemas();
  content.channels = reader.channels();
  while (const auto m = reader.next())
    content.messages.push_back({m->channel,
                                m->sequence,
                                m->time,
                                m->publishTime,
                                {reinterpret_cast<const char*>(m->data.data()), m->data.size()}});
  content.metadata = reader.metadata();
  content.attachments = reader.attachments();
  content.unknown = reader.unknown();
  return content;
}

/// Writes the logs.
class VariantWriter {
 public:
  /// Chunks have so many messages; the second of them are outside of chunks, if some are.
  VariantWriter(unsigned features, Content content, std::size_t chunkSize)
      : features_{features}, content_{std::move(content)}, chunkSize_{chunkSize} {}

  std::string write() {
    using namespace mcap;
    append(out_, std::as_bytes(std::span{magic, magicSize}));
    record(out_, Opcode::header, [&](Bytes& to) {
      append(to, std::string_view{content_.header.profile});
      append(to, std::string_view{content_.header.library});
    });
    if (!has(chunks)) putDescriptions(out_, true, true);
    const std::size_t before = (content_.metadata.size() + 1) / 2;
    for (std::size_t i = 0; i < before; ++i) putMetadata(i);
    putMessages();
    putUnknown();
    putAttachments();
    for (std::size_t i = before; i < content_.metadata.size(); ++i) putMetadata(i);
    const std::uint32_t data = checksum(out_);
    record(out_, Opcode::dataEnd, [&](Bytes& to) { append(to, data); });
    putIndex();
    if (has(endMagic)) append(out_, std::as_bytes(std::span{magic, magicSize}));
    return {reinterpret_cast<const char*>(out_.data()), out_.size()};
  }

 private:
  using Bytes = mcap::Bytes;
  using Opcode = mcap::Opcode;
  struct Chunk {
    std::uint64_t first, last, begin, length, size;
    std::vector<std::pair<std::uint16_t, std::uint64_t>> indexes;
    std::uint64_t indexLength;
  };

  bool has(unsigned feature) const { return (features_ & feature) != 0; }
  std::uint32_t checksum(std::span<const std::byte> bytes) const {
    return has(checksums) ? mcap::crcOf(bytes) : 0;
  }
  /// A record, with a pad if there are any.
  template <typename Fill>
  void record(Bytes& to, Opcode opcode, const Fill& fill) const {
    const std::size_t at = mcap::beginRecord(to, opcode);
    fill(to);
    if (has(pads) && opcode != Opcode::message && opcode != Opcode::footer)
      mcap::append(to, bytesOf("pad"));
    mcap::endRecord(to, at);
  }

  void putDescriptions(Bytes& to, bool schemas, bool channels) const {
    using namespace mcap;
    for (const McapSchema& s : content_.schemas) {
      if (!schemas) break;
      record(to, Opcode::schema, [&](Bytes& b) {
        append(b, s.id);
        append(b, std::string_view{s.name});
        append(b, std::string_view{s.encoding});
        append(b, std::string_view{s.text});
      });
    }
    for (const McapChannel& c : content_.channels) {
      if (!channels) break;
      record(to, Opcode::channel, [&](Bytes& b) {
        append(b, c.id);
        append(b, c.schema);
        append(b, std::string_view{c.topic});
        append(b, std::string_view{c.messageEncoding});
        append(b, c.metadata);
      });
    }
  }

  void putMetadata(std::size_t i) {
    using namespace mcap;
    const McapMetadata& m = content_.metadata[i];
    const std::uint64_t begin = out_.size();
    record(out_, Opcode::metadata, [&](Bytes& to) {
      append(to, std::string_view{m.name});
      append(to, m.entries);
    });
    record(metadataIndexes_, Opcode::metadataIndex, [&](Bytes& to) {
      append(to, begin);
      append(to, std::uint64_t{out_.size() - begin});
      append(to, std::string_view{m.name});
    });
  }

  void putAttachments() {
    using namespace mcap;
    for (const McapAttachment& a : content_.attachments) {
      const std::uint64_t begin = out_.size();
      record(out_, Opcode::attachment, [&](Bytes& to) {
        const std::size_t fields = to.size();
        append(to, a.time);
        append(to, a.createTime);
        append(to, std::string_view{a.name});
        append(to, std::string_view{a.mediaType});
        append(to, std::uint64_t{a.data.size()});
        append(to, a.data);
        append(to, checksum(std::span{to}.subspan(fields)));
      });
      record(attachmentIndexes_, Opcode::attachmentIndex, [&](Bytes& to) {
        append(to, begin);
        append(to, std::uint64_t{out_.size() - begin});
        append(to, a.time);
        append(to, a.createTime);
        append(to, std::uint64_t{a.data.size()});
        append(to, std::string_view{a.name});
        append(to, std::string_view{a.mediaType});
      });
    }
  }

  void putUnknown() {
    for (const McapUnknownRecord& u : content_.unknown) {
      const std::size_t at = mcap::beginRecord(out_, static_cast<Opcode>(u.opcode));
      mcap::append(out_, u.content);
      mcap::endRecord(out_, at);
    }
  }

  void putMessage(Bytes& to, const Message& m) const {
    using namespace mcap;
    record(to, Opcode::message, [&](Bytes& b) {
      append(b, m.channel);
      append(b, m.sequence);
      append(b, m.time);
      append(b, m.publishTime);
      append(b, std::as_bytes(std::span{m.data}));
    });
  }

  void putMessages() {
    const std::span messages{content_.messages};
    for (std::size_t i = 0; i < messages.size(); i += chunkSize_) {
      const auto some = messages.subspan(i, std::min(chunkSize_, messages.size() - i));
      if (has(chunks) && !(has(outside) && i == chunkSize_))
        putChunk(some, i == 0);
      else
        for (const Message& m : some) putMessage(out_, m);
    }
  }

  void putChunk(std::span<const Message> messages, bool first) {
    using namespace mcap;
    Bytes records, indexes;
    if (first) putDescriptions(records, true, true);
    Chunk chunk{messages.front().time, messages.back().time, out_.size(), 0, 0, {}, 0};
    std::map<std::uint16_t, Bytes> entries;  // times and places of a channel's messages
    for (const Message& m : messages) {
      append(entries[m.channel], m.time);
      append(entries[m.channel], std::uint64_t{records.size()});
      putMessage(records, m);
    }
    chunk.size = records.size();
    record(out_, Opcode::chunk, [&](Bytes& to) {
      append(to, chunk.first);
      append(to, chunk.last);
      append(to, std::uint64_t{records.size()});
      append(to, checksum(records));
      append(to, std::string_view{});
      append(to, std::uint64_t{records.size()});
      append(to, records);
    });
    chunk.length = out_.size() - chunk.begin;
    for (const auto& [channel, listed] : entries) {
      if (!has(messageIndex)) break;
      chunk.indexes.emplace_back(channel, out_.size() + indexes.size());
      record(indexes, Opcode::messageIndex, [&, channel = channel, &listed = listed](Bytes& to) {
        append(to, channel);
        append(to, static_cast<std::uint32_t>(listed.size()));
        append(to, listed);
      });
    }
    chunk.indexLength = indexes.size();
    append(out_, indexes);
    chunks_.push_back(chunk);
  }

  void putStatistics(Bytes& to) const {
    using namespace mcap;
    record(to, Opcode::statistics, [&](Bytes& b) {
      append(b, std::uint64_t{content_.messages.size()});
      append(b, static_cast<std::uint16_t>(content_.schemas.size()));
      append(b, static_cast<std::uint32_t>(content_.channels.size()));
      append(b, static_cast<std::uint32_t>(content_.attachments.size()));
      append(b, static_cast<std::uint32_t>(content_.metadata.size()));
      append(b, static_cast<std::uint32_t>(chunks_.size()));
      const bool any = !content_.messages.empty();
      append(b, any ? content_.messages.front().time : 0);
      append(b, any ? content_.messages.back().time : 0);
      append(b, static_cast<std::uint32_t>(10 * content_.channels.size()));
      for (const McapChannel& c : content_.channels) {
        append(b, c.id);
        append(b, static_cast<std::uint64_t>(
                      std::ranges::count(content_.messages, c.id, &Message::channel)));
      }
    });
  }

  void putChunkIndexes(Bytes& to) const {
    using namespace mcap;
    for (const Chunk& c : chunks_)
      record(to, Opcode::chunkIndex, [&](Bytes& b) {
        append(b, c.first);
        append(b, c.last);
        append(b, c.begin);
        append(b, c.length);
        append(b, static_cast<std::uint32_t>(10 * c.indexes.size()));
        for (const auto& [channel, offset] : c.indexes) {
          append(b, channel);
          append(b, offset);
        }
        append(b, c.indexLength);
        append(b, std::string_view{});
        append(b, c.size);
        append(b, c.size);
      });
  }

  void putIndex() {
    using namespace mcap;
    std::array<Bytes, 6> groups;
    putDescriptions(groups[0], has(repeatSchemas), false);
    putDescriptions(groups[1], false, has(repeatChannels));
    if (has(statistics)) putStatistics(groups[2]);
    if (has(chunkIndex)) putChunkIndexes(groups[3]);
    if (has(attachmentIndex)) groups[4] = attachmentIndexes_;
    if (has(metadataIndex)) groups[5] = metadataIndexes_;
    const std::uint64_t begin = out_.size();
    Bytes summary, places;
    for (const Bytes& group : groups) {
      if (group.empty()) continue;
      record(places, Opcode::summaryOffset, [&](Bytes& to) {
        append(to, group.front());
        append(to, begin + summary.size());
        append(to, std::uint64_t{group.size()});
      });
      append(summary, group);
    }
    const std::uint64_t offsetsBegin = begin + summary.size();
    if (has(offsets)) append(summary, places);
    const bool any = !summary.empty();
    append(summary, Opcode::footer);
    append(summary, std::uint64_t{footerSize});
    append(summary, any ? begin : 0);
    append(summary, any && has(offsets) ? offsetsBegin : 0);
    append(summary, checksum(summary));
    append(out_, summary);
  }

  unsigned features_;
  Content content_;
  std::size_t chunkSize_;
  Bytes out_, attachmentIndexes_, metadataIndexes_;
  std::vector<Chunk> chunks_;
};

inline std::string logWith(unsigned features) {
  return VariantWriter{features, contentOf(features), 4}.write();
}

/// Each set of features that makes a difference. The index lists attachments and metadata, or
/// neither.
inline std::vector<unsigned> allVariants() {
  std::vector<unsigned> all;
  for (unsigned features = 0; features < metadataIndex; ++features)
    if ((features & chunks) != 0 || (features & (outside | chunkIndex | messageIndex)) == 0)
      all.push_back((features & attachmentIndex) != 0 ? features | metadataIndex : features);
  return all;
}

}  // namespace gt::variants
