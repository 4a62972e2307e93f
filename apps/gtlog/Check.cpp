#include "gtlog/Check.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// What is counted of a log, as its statistics state it.
McapStatistics countsOf(const McapReader& log) {
  McapStatistics counts;
  counts.schemas = static_cast<std::uint16_t>(log.schemas().size());
  counts.channels = static_cast<std::uint32_t>(log.channels().size());
  counts.attachments = static_cast<std::uint32_t>(log.attachments().size());
  counts.metadata = static_cast<std::uint32_t>(log.metadata().size());
  counts.chunks = static_cast<std::uint32_t>(log.chunks());
  return counts;
}

/// Compares what an undamaged log states about itself with what it holds.
void compareCounts(const McapReader& log, const McapStatistics& found, const std::string& path,
                   std::vector<Error>& problems) {
  const McapStatistics& stated = *log.statistics();
  const auto compare = [&](const std::string& field, const char* what, auto says, auto has) {
    if (says == has) return;
    problems.push_back({.file = path,
                        .field = field,
                        .what = "the statistics state " + std::to_string(says) + " " + what +
                                ", there are " + std::to_string(has)});
  };
  compare("", "messages", stated.messages, found.messages);
  compare("", "schemas", stated.schemas, found.schemas);
  compare("", "channels", stated.channels, found.channels);
  compare("", "attachments", stated.attachments, found.attachments);
  compare("", "metadata", stated.metadata, found.metadata);
  compare("", "chunks", stated.chunks, found.chunks);
  if (stated.messagesOf.empty()) return;
  for (const McapChannel& channel : log.channels()) {
    const auto of = [&](const McapStatistics& counts) {
      const auto count = counts.messagesOf.find(channel.id);
      return count == counts.messagesOf.end() ? 0 : count->second;
    };
    compare(channel.topic, "messages", of(stated), of(found));
  }
}

}  // namespace

Result<LogCheck> checkLog(const std::string& path) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  LogCheck check;
  Definitions definitions{path};
  std::map<std::uint16_t, const MessageDefinition*> readable;
  for (const McapChannel& channel : log->channels()) {
    const auto definition = definitions.of(channel);
    if (definition)
      readable[channel.id] = *definition;
    else
      (isRos2(channel) ? check.problems : check.unchecked).push_back(definition.error());
  }
  LostMessages unreadable;
  McapStatistics counts = countsOf(*log);
  while (const auto message = log->next()) {
    ++check.messages;
    ++counts.messages;
    ++counts.messagesOf[message->channel];
    const auto definition = readable.find(message->channel);
    if (definition == readable.end()) continue;
    if (const auto json = recordedJson(*definition->second, message->data); !json)
      unreadable.add(*log->channel(message->channel), message->time, json.error().text());
  }
  const auto& damage = log->damage();
  if (damage.empty() && !log->hasDataChecksum())
    check.problems.push_back(
        {.file = path, .what = "the checksum of all data is wrong, though each part can be read"});
  if (damage.empty() && log->statistics()) compareCounts(*log, counts, path, check.problems);
  check.problems.insert(check.problems.begin(), damage.begin(), damage.end());
  for (Error& error : unreadable.errors(path)) check.problems.push_back(std::move(error));
  return check;
}

}  // namespace gt
