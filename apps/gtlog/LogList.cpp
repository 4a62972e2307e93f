#include "gtlog/LogList.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace gt {
namespace {

/// What is to be counted of a channel.
struct Count {
  std::uint64_t messages = 0, bytes = 0;
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max(), last = 0;

  void add(const McapMessage& message) {
    ++messages;
    bytes += message.data.size();
    first = std::min(first, message.time);
    last = std::max(last, message.time);
  }
  /// Per second; 0 if there is no time between.
  double rate() const {
    return messages > 1 && last > first ? static_cast<double>(messages - 1) / seconds(last - first)
                                        : 0;
  }
};

std::string channelTable(const std::vector<McapChannel>& channels,
                         std::map<std::uint16_t, Count>& counts) {
  std::size_t width = 5, typeWidth = 4;
  for (const McapChannel& c : channels) {
    width = std::max(width, c.topic.size());
    typeWidth = std::max(typeWidth, c.schemaName.size());
  }
  std::string text =
      fmt::format("  {:<{}}  {:<{}}  {:>9}  {:>8}  {:>10}  {:>9}  {:>9}\n", "topic", width, "type",
                  typeWidth, "messages", "Hz", "bytes", "from s", "to s");
  for (const McapChannel& c : channels) {
    const Count& n = counts[c.id];
    text += fmt::format("  {:<{}}  {:<{}}  {:>9}  {:>8.2f}  {:>10}", c.topic, width, c.schemaName,
                        typeWidth, n.messages, n.rate(), n.bytes);
    const auto inSeconds = [](std::uint64_t time) {
      const std::string text = timeText(time);
      return text.substr(0, text.find(' '));
    };
    text += n.messages > 0 ? fmt::format("  {:>9}  {:>9}\n", inSeconds(n.first), inSeconds(n.last))
                           : "\n";
  }
  return text;
}

/// The first line of a value that may be long.
std::string shortened(const std::string& text) {
  const auto end = std::min({text.find('\n'), text.size(), std::size_t{100}});
  return text.substr(0, end) + (end < text.size() ? " ..." : "");
}

}  // namespace

Result<std::string> describeLog(const std::string& path, std::vector<Error>& damage) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  std::map<std::uint16_t, Count> counts;
  Count all;
  while (const auto message = log->next()) {
    counts[message->channel].add(*message);
    all.add(*message);
  }
  std::error_code failure;
  std::string text = fmt::format("{}: {} bytes, {} messages", path,
                                 std::filesystem::file_size(path, failure), all.messages);
  if (all.messages > 0) text += ", " + timeText(all.first) + " to " + timeText(all.last);
  text += log->indexed() ? "\n" : ", without an index\n";
  damage.insert(damage.end(), log->damage().begin(), log->damage().end());
  text += channelTable(log->channels(), counts);
  for (const auto& m : log->metadata()) {
    text += fmt::format("  metadata {}\n", m.name);
    for (const auto& [key, value] : m.entries)
      text += fmt::format("    {}: {}\n", key, shortened(value));
  }
  for (const auto& a : log->attachments())
    text += fmt::format("  attachment {} ({}): {} bytes\n", a.name, a.mediaType, a.data.size());
  return text;
}

}  // namespace gt
