#include "observer/LogTransfer.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace gt {
namespace {

Result<void> differs(const std::string& from, const std::string& to) {
  std::error_code failure;
  if (std::filesystem::equivalent(from, to, failure))
    return Error{.file = to, .what = "is the log that is read"};
  return {};
}

void copyExtras(const McapReader& from, McapWriter& to, const std::string& prefix) {
  for (const auto& m : from.metadata()) to.metadata(prefix + m.name, m.entries);
  for (const auto& a : from.attachments())
    to.attachment(prefix + a.name, a.mediaType, Time{a.time / 1'000'000}, a.data);
}

/// A log that is being copied, one message ahead, so that several can be merged by time.
struct Source {
  McapReader reader;
  std::string topics{};  ///< What the topics' names begin with in the new log.
  std::map<std::uint16_t, McapWriter::ChannelId> channels{};
  std::optional<McapMessage> message{};

  /// Moves on to the next message; damage is skipped and reported.
  void advance(std::vector<Error>& lost) {
    for (;;) {
      auto next = reader.next();
      if (next) {
        message = *next;
        return;
      }
      lost.push_back(next.error());
    }
  }
};

void copy(Source& source, McapWriter& writer) {
  const McapMessage& message = *source.message;
  auto known = source.channels.find(message.channel);
  if (known == source.channels.end()) {
    McapChannel channel = *source.reader.channel(message.channel);
    channel.topic = source.topics + channel.topic;
    known = source.channels.emplace(message.channel, writer.addChannel(channel)).first;
  }
  // Times beyond what a log of ours may hold are the work of others; they end up at its ends.
  writer.write(known->second, std::max<std::int64_t>(message.time, 0), message.data);
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

/// Merges logs by time, with what the selection holds.
Result<Transferred> transfer(const std::vector<std::string>& from, const Selection& selection,
                             const std::string& to) {
  std::vector<Source> sources;
  for (const std::string& path : from) {
    if (auto good = differs(path, to); !good) return good.error();
    auto reader = McapReader::open(path);
    if (!reader) return reader.error();
    sources.push_back({std::move(*reader)});
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (auto good = selection.check(sources[i].reader, from[i]); !good) return good.error();
  nameRobots(sources);
  auto writer = McapWriter::open(to);
  if (!writer) return writer.error();
  Transferred result;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string prefix =
        sources.size() > 1 ? std::filesystem::path{from[i]}.stem().string() + "/" : "";
    copyExtras(sources[i].reader, *writer, prefix);
    if (const auto& damage = sources[i].reader.damage()) result.lost.push_back(*damage);
    if (selection.from)
      sources[i].reader.seek(
          static_cast<std::int64_t>(std::clamp(*selection.from, 0.0, 9e9) * 1e9));
    sources[i].advance(result.lost);
  }
  for (;;) {
    Source* first = nullptr;
    for (Source& source : sources)
      if (source.message && (!first || source.message->time < first->message->time))
        first = &source;
    if (!first) break;
    if (selection.holds(*first->reader.channel(first->message->channel)) &&
        selection.holds(first->message->time)) {
      copy(*first, *writer);
      ++result.messages;
    }
    first->advance(result.lost);
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
