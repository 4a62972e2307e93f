#include "gtlog/ReplayLog.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string_view>

#include "observer/LogSelection.h"
#include "observer/RobotLog.h"
#include "robot/SetupFiles.h"

namespace gt {
namespace {

/// The messages of one topic, by their times and what is left of their bytes to distinguish them.
using Trace = std::vector<std::pair<std::uint64_t, std::size_t>>;

Result<std::map<std::string, Trace>> tracesOf(const std::string& log,
                                              const std::vector<std::string>& topics) {
  std::map<std::string, Trace> traces;
  for (const std::string& topic : topics) traces[topic];
  std::vector<Error> damage;
  const auto done = Selection{}.forEach(
      log,
      [&](const McapChannel& channel, const McapMessage& message) {
        const auto trace = traces.find(channel.topic);
        if (trace != traces.end())
          trace->second.emplace_back(
              message.time,
              std::hash<std::string_view>{}(
                  {reinterpret_cast<const char*>(message.data.data()), message.data.size()}));
        return Result<void>{};
      },
      damage);
  if (!done) return done.error();
  return traces;
}

/// Its first message names the files of the behavior, which lie elsewhere in a replay.
constexpr std::string_view traceTopic = "/BehaviorTrace";

ReplayedTopic compare(const std::string& topic, const Trace& recorded, const Trace& replayed) {
  ReplayedTopic result{topic, recorded.size(), replayed.size(), 0, std::nullopt};
  auto other = replayed.begin();
  for (const auto& [time, hash] : recorded) {
    while (other != replayed.end() && other->first < time) ++other;
    if (other == replayed.end() || other->first != time) continue;
    if (other->second != hash && !(topic == traceTopic && time == recorded.front().first)) {
      ++result.different;
      if (!result.first) result.first = time;
    }
    ++other;
  }
  return result;
}

Result<std::vector<std::string>> record(const ReplayOptions& options, const std::string& to) {
  auto platform = ReplayPlatform::make(options);
  if (!platform) return platform.error();
  auto log = RobotLog::open(to, {{"replay of", std::filesystem::path{options.log}.filename()}});
  if (!log) return log.error();
  platform->watchAll();
  static_cast<void>(platform->robot().request(DebugRequest{traceKey, DebugKeyMode::always, 0}));
  std::vector<std::string> topics{std::string{traceTopic}};
  for (const RepresentationType* type : platform->watched())
    topics.push_back("/" + std::string{type->name});
  // So that this log can be replayed, too.
  if (!platform->recorded().files.empty() && !options.configuration)
    attach(platform->recorded(), log->file());
  platform->onInput([&](Time now, const RepresentationType& type, const void* package) {
    log->writeInput(now, type, package);
  });
  log->keepPixels(platform->missingFor(imageTask).empty());
  for (;;) {
    const auto more = platform->step();
    if (!more) return more.error();
    if (!*more) break;
    log->write(platform->robot().toTools());
    platform->robot().toTools().clear();
  }
  while (const auto warning = platform->takeWarning())
    if (options.warn) options.warn(*warning);
  if (auto done = log->close(); !done) return done.error();
  return topics;
}

}  // namespace

Result<std::vector<ReplayedTopic>> replayLog(const ReplayOptions& options, const std::string& to) {
  std::error_code failure;
  if (std::filesystem::equivalent(options.log, to, failure))
    return Error{.file = to, .what = "is the log that is read"};
  const auto topics = record(options, to);
  if (!topics) return topics.error();
  const auto recorded = tracesOf(options.log, *topics);
  if (!recorded) return recorded.error();
  const auto replayed = tracesOf(to, *topics);
  if (!replayed) return replayed.error();
  std::vector<ReplayedTopic> result;
  for (const std::string& topic : *topics)
    if (!recorded->at(topic).empty())
      result.push_back(compare(topic, recorded->at(topic), replayed->at(topic)));
  return result;
}

}  // namespace gt
