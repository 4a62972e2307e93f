#include "observer/LogSelection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gt {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

bool Selection::holds(const McapChannel& channel) const {
  return (topics.empty() || contains(topics, channel.topic)) && !contains(without, channel.topic);
}

bool Selection::holds(std::int64_t time) const {
  return (!from || seconds(time) >= *from) && (!to || seconds(time) < *to);
}

Result<void> Selection::check(const McapReader& log, const std::string& path) const {
  for (const auto* names : {&topics, &without})
    for (const std::string& name : *names)
      if (std::none_of(log.channels().begin(), log.channels().end(),
                       [&](const McapChannel& c) { return c.topic == name; }))
        return Error{.file = path, .field = name, .what = "the log has no such topic"};
  for (const auto& [time, name] : {std::pair{from, "from"}, std::pair{to, "to"}})
    if (time && !std::isfinite(*time)) return Error{.field = name, .what = "is no time"};
  if (from && to && *to <= *from)
    return Error{.field = "to", .what = "lies not behind the time from which on"};
  return {};
}

Result<void> Selection::forEach(const std::string& path, const Visitor& visit) const {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  if (auto good = check(*log, path); !good) return good;
  if (from) log->seek(static_cast<std::int64_t>(std::clamp(*from, 0.0, 9e9) * 1e9));
  for (;;) {
    const auto message = log->next();
    if (!message) return message.error();
    if (!*message) break;
    const McapChannel& channel = *log->channel((*message)->channel);
    if (!holds(channel) || !holds((*message)->time)) continue;
    if (auto done = visit(channel, **message); !done) return done;
  }
  return {};
}

Result<const MessageDefinition*> Definitions::of(const McapChannel& channel) {
  const auto known = definitions_.find(channel.id);
  if (known != definitions_.end()) return &known->second;
  if (channel.messageEncoding != "cdr" || channel.schemaEncoding != "ros2msg")
    return Error{.file = file_,
                 .field = channel.topic,
                 .what = "its messages are " + channel.messageEncoding + " by " +
                         channel.schemaEncoding + ", not cdr by ros2msg"};
  auto parsed = MessageDefinition::parse(channel.schemaName, channel.schemaText);
  if (!parsed) return Error{.file = file_, .field = channel.topic, .what = parsed.error().text()};
  return &definitions_.emplace(channel.id, std::move(*parsed)).first->second;
}

}  // namespace gt
