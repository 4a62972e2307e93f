#include "gtlog/Selection.h"

#include <algorithm>
#include <cmath>

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

Result<void> Selection::forEach(const std::string& path, const Visitor& visit) const {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  for (const auto* names : {&topics, &without})
    for (const std::string& name : *names)
      if (std::none_of(log->channels().begin(), log->channels().end(),
                       [&](const McapChannel& c) { return c.topic == name; }))
        return Error{path, 0, name, "the log has no such topic"};
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
    return Error{file_, 0, channel.topic,
                 "its messages are " + channel.messageEncoding + " by " + channel.schemaEncoding +
                     ", not cdr by ros2msg"};
  auto parsed = MessageDefinition::parse(channel.schemaName, channel.schemaText);
  if (!parsed) return Error{file_, 0, channel.topic, parsed.error().text()};
  return &definitions_.emplace(channel.id, std::move(*parsed)).first->second;
}

}  // namespace gt
