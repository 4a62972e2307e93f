#include "gtlog/Check.h"

#include <nlohmann/json.hpp>

#include "observer/LogSelection.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// Enough to see what is wrong; a damaged schema would name every message.
constexpr std::size_t mostProblems = 100;

}  // namespace

Result<LogCheck> checkLog(const std::string& path) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  LogCheck check;
  const auto problem = [&](Error error) {
    if (check.problems.size() < mostProblems) check.problems.push_back(std::move(error));
  };
  if (log->damage()) problem(*log->damage());
  if (!log->complete()) problem({.file = path, .what = "was not closed: it has no index"});
  Definitions definitions{path};
  for (const McapChannel& channel : log->channels())
    if (const auto definition = definitions.of(channel); !definition) problem(definition.error());
  std::map<std::uint16_t, std::uint64_t> counts;
  for (;;) {
    const auto message = log->next();
    if (!message) {
      problem(message.error());
      continue;
    }
    if (!*message) break;
    ++check.messages;
    ++counts[(*message)->channel];
    const McapChannel& channel = *log->channel((*message)->channel);
    const auto definition = definitions.of(channel);
    if (!definition) continue;
    if (const auto json = recordedJson(**definition, (*message)->data); !json)
      problem(
          {.file = path,
           .field = channel.topic,
           .what = "message " + std::to_string(counts[channel.id]) + ": " + json.error().text()});
  }
  if (log->complete())
    for (const McapChannel& channel : log->channels())
      if (channel.messageCount != counts[channel.id])
        problem({.file = path,
                 .field = channel.topic,
                 .what = "the index states " + std::to_string(channel.messageCount) +
                         " messages, there are " + std::to_string(counts[channel.id])});
  return check;
}

}  // namespace gt
