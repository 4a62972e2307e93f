#include "logs/LogTransfer.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace gt {
namespace {

Result<void> differs(const std::string& from, const std::string& to) {
  std::error_code failure;
  if (std::filesystem::equivalent(from, to, failure))
    return Error{.file = to, .what = "is the log that is read"};
  return {};
}

/// A log that is being copied, one message ahead, so that several can be merged by time.
struct Source {
  std::string path;
  McapReader reader;
  std::string topics{};  ///< What the topics' names begin with in the new log.
  std::map<std::uint16_t, McapWriter::ChannelId> channels{};
  std::optional<McapMessage> message{};
};

/// Gives the schemas and channels of several logs ids in a new one. Logs share what they describe
/// in the same words; what one log describes twice stays twice.
class Channels {
 public:
  explicit Channels(McapWriter& writer) : writer_{writer} {}

  void add(Source& source, const Selection& selection) {
    std::map<std::uint16_t, std::uint16_t> schemas;
    std::map<SchemaKey, int> schemasAlike;
    std::map<ChannelKey, int> channelsAlike;
    for (const McapSchema& schema : source.reader.schemas()) {
      if (!isWanted(schema, source, selection)) continue;
      const SchemaKey key{schema.name, schema.encoding, schema.text, schema.rest};
      auto& id = schemas_[{key, schemasAlike[key]++}];
      if (id == 0) id = writer_.addSchema(schema);
      schemas[schema.id] = id;
    }
    for (McapChannel channel : source.reader.channels()) {
      if (!selection.holds(channel)) continue;
      const auto schema = schemas.find(channel.schema);
      channel.schema = schema == schemas.end() ? 0 : schema->second;
      channel.topic = source.topics + channel.topic;
      const ChannelKey key{channel.topic, channel.messageEncoding, channel.schema, channel.metadata,
                           channel.rest};
      const auto [place, isNew] = channels_.try_emplace({key, channelsAlike[key]++});
      if (isNew) place->second = writer_.addChannel(channel);
      source.channels[channel.id] = place->second;
    }
  }

 private:
  using SchemaKey = std::tuple<std::string, std::string, std::string, McapBytes>;
  using ChannelKey = std::tuple<std::string, std::string, std::uint16_t, McapMap, McapBytes>;

  /// Not if only channels have it that are left out.
  static bool isWanted(const McapSchema& schema, const Source& source, const Selection& selection) {
    bool used = false;
    for (const McapChannel& channel : source.reader.channels()) {
      if (channel.schema != schema.id) continue;
      if (selection.holds(channel)) return true;
      used = true;
    }
    return !used;
  }

  McapWriter& writer_;
  std::map<std::pair<SchemaKey, int>, std::uint16_t> schemas_;
  std::map<std::pair<ChannelKey, int>, McapWriter::ChannelId> channels_;
};

void copyExtras(const McapReader& from, McapWriter& to, const std::string& prefix) {
  for (McapMetadata m : from.metadata()) {
    m.name = prefix + m.name;
    to.metadata(m);
  }
  for (McapAttachment a : from.attachments()) {
    a.name = prefix + a.name;
    to.attachment(a);
  }
}

/// Whose log it is; empty if it does not state that.
std::string robotOf(const McapReader& log) {
  for (const auto& m : log.metadata())
    if (const auto robot = m.entries.find("robot"); m.name == "gt2003" && robot != m.entries.end())
      return robot->second;
  return {};
}

/// Distinguishes the topics of several robots.
void nameRobots(std::vector<Source>& sources) {
  const std::string first = robotOf(sources.front().reader);
  const bool same = std::all_of(sources.begin(), sources.end(), [&](const Source& source) {
    return robotOf(source.reader) == first;
  });
  if (same) return;
  for (Source& source : sources)
    if (const std::string robot = robotOf(source.reader); !robot.empty())
      source.topics = "/" + robot;
}

/// What a log of several states about itself: what they have in common, and all libraries.
McapHeader commonHeader(const std::vector<Source>& sources, std::vector<Error>& lost) {
  McapHeader common = sources.front().reader.header();
  for (const Source& source : sources) {
    const McapHeader& header = source.reader.header();
    if (common.library.find(header.library) == std::string::npos)
      common.library += "; " + header.library;
    if (header.profile != common.profile || header.rest != common.rest)
      lost.push_back({.file = source.path,
                      .field = "header",
                      .what = "differs from that of " + sources.front().path + ", which is kept"});
  }
  return common;
}

Result<std::vector<Source>> openSources(const std::vector<std::string>& from,
                                        const Selection& selection, const std::string& to) {
  std::vector<Source> sources;
  for (const std::string& path : from) {
    if (auto good = differs(path, to); !good) return good.error();
    auto reader = McapReader::open(path);
    if (!reader) return reader.error();
    if (auto good = selection.check(*reader, path); !good) return good.error();
    sources.push_back({path, std::move(*reader)});
  }
  nameRobots(sources);
  return sources;
}

/// What was damaged, and records whose meaning is not known where they cannot stay.
void reportLost(const Source& source, std::vector<Error>& lost) {
  const auto& damage = source.reader.damage();
  lost.insert(lost.end(), damage.begin(), damage.end());
  if (const std::size_t count = source.reader.unknownInIndex(); count > 0)
    lost.push_back({.file = source.path,
                    .field = "index",
                    .what = std::to_string(count) + " records of unknown kinds are left out"});
}

/// Merges logs by time, with what the selection holds.
Result<Transferred> transfer(const std::vector<std::string>& from, const Selection& selection,
                             const std::string& to) {
  auto opened = openSources(from, selection, to);
  if (!opened) return opened.error();
  std::vector<Source>& sources = *opened;
  Transferred result;
  McapOptions options;
  options.atOnce = true;
  options.header = commonHeader(sources, result.lost);
  auto writer = McapWriter::open(to, options);
  if (!writer) return writer.error();
  Channels channels{*writer};
  for (Source& source : sources) {
    channels.add(source, selection);
    const auto stem = std::filesystem::path{source.path}.stem().string();
    copyExtras(source.reader, *writer, sources.size() > 1 ? stem + "/" : "");
    source.reader.seek(selection.begin());
    source.message = source.reader.next();
  }
  for (;;) {
    Source* first = nullptr;
    for (Source& source : sources)
      if (source.message && (!first || source.message->time < first->message->time))
        first = &source;
    if (!first) break;
    const McapMessage& message = *first->message;
    const auto channel = first->channels.find(message.channel);
    if (channel != first->channels.end() && selection.holds(message.time)) {
      writer->write(channel->second, message);
      ++result.messages;
      if (auto failed = writer->takeError()) return *failed;
    }
    first->message = first->reader.next();
  }
  for (const Source& source : sources) {
    for (const McapUnknownRecord& record : source.reader.unknown()) writer->unknown(record);
    reportLost(source, result.lost);
  }
  if (auto closed = writer->close(); !closed) return closed.error();
  return result;
}

}  // namespace

Result<Transferred> cutLog(const std::string& from, const Selection& selection,
                           const std::string& to) {
  return transfer({from}, selection, to);
}

Result<Transferred> joinLogs(const std::vector<std::string>& from, const std::string& to) {
  return transfer(from, {}, to);
}

Result<Transferred> repairLog(const std::string& from, const std::string& to) {
  return transfer({from}, {}, to);
}

}  // namespace gt
