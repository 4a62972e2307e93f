#include "logs/LogSelection.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "streams/RecordedMessage.h"

namespace gt {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

bool Selection::holds(const McapChannel& channel) const {
  return (topics.empty() || contains(topics, channel.topic)) && !contains(without, channel.topic);
}

bool Selection::holds(std::uint64_t time) const {
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

std::uint64_t Selection::begin() const {
  // A double of this size does not state nanoseconds.
  return from ? static_cast<std::uint64_t>(std::clamp(*from - 1e-5, 0.0, 1.8e10) * 1e9) : 0;
}

Result<void> Selection::forEach(const std::string& path, const Visitor& visit,
                                std::vector<Error>& damage) const {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  if (auto good = check(*log, path); !good) return good;
  log->seek(begin());
  Result<void> done;
  while (const auto message = done ? log->next() : std::nullopt) {
    const McapChannel& channel = *log->channel(message->channel);
    if (holds(channel) && holds(message->time)) done = visit(channel, *message);
  }
  damage.insert(damage.end(), log->damage().begin(), log->damage().end());
  return done;
}

Result<void> Selection::forEachJson(const std::string& path, const JsonVisitor& visit,
                                    std::vector<Error>& lost) const {
  Definitions definitions{path};
  LostMessages unreadable;
  auto done = forEach(
      path,
      [&](const McapChannel& channel, const McapMessage& message) -> Result<void> {
        const auto definition = definitions.of(channel);
        auto json = definition ? recordedJson(**definition, message.data) : definition.error();
        if (json) return visit(channel, message.time, *json);
        unreadable.add(channel, message.time, definition ? json.error().text() : json.error().what);
        return {};
      },
      lost);
  for (Error& error : unreadable.errors(path)) lost.push_back(std::move(error));
  return done;
}

void LostMessages::add(const McapChannel& channel, std::uint64_t time, const std::string& why) {
  Stretch& stretch = channels_[channel.id];
  if (stretch.count++ == 0) stretch = {channel.topic, why, 1, time, time};
  stretch.first = std::min(stretch.first, time);
  stretch.last = std::max(stretch.last, time);
}

std::uint64_t LostMessages::of(const McapChannel& channel) const {
  const auto found = channels_.find(channel.id);
  return found == channels_.end() ? 0 : found->second.count;
}

std::vector<Error> LostMessages::errors(const std::string& file) const {
  std::vector<Error> all;
  for (const auto& [id, lost] : channels_) {
    const std::string time = lost.first == lost.last
                                 ? " at " + timeText(lost.first)
                                 : " from " + timeText(lost.first) + " to " + timeText(lost.last);
    all.push_back({.file = file,
                   .field = lost.topic,
                   .what = std::to_string(lost.count) +
                           (lost.count == 1 ? " message" : " messages") + time +
                           " cannot be read: " + lost.why});
  }
  return all;
}

bool isRos2(const McapChannel& channel) {
  return channel.messageEncoding == "cdr" && channel.schemaEncoding == "ros2msg";
}

Result<const MessageDefinition*> Definitions::of(const McapChannel& channel) {
  const auto known = definitions_.find(channel.id);
  if (known != definitions_.end()) return &known->second;
  if (!isRos2(channel)) {
    const bool none = channel.schemaName.empty() && channel.schemaEncoding.empty();
    return Error{.file = file_,
                 .field = channel.topic,
                 .what = "the encoding is " + channel.messageEncoding + " with " +
                         (none ? "no schema" : "a schema in " + channel.schemaEncoding) +
                         ", not cdr with one in ros2msg"};
  }
  auto parsed = MessageDefinition::parse(channel.schemaName, channel.schemaText);
  if (!parsed) return Error{.file = file_, .field = channel.topic, .what = parsed.error().text()};
  return &definitions_.emplace(channel.id, std::move(*parsed)).first->second;
}

}  // namespace gt
