#include "gtlog/ReplayLog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string_view>

#include "base/Number.h"
#include "base/UnfinishedFile.h"
#include "logs/LogSelection.h"
#include "logs/MessageTypes.h"
#include "logs/RobotLog.h"
#include "representations/behavior/MotionRequest.h"
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

constexpr std::string_view traceTopic = "/BehaviorTrace";

ReplayedTopic compare(const std::string& topic, const Trace& recorded, const Trace& replayed) {
  ReplayedTopic result{topic, recorded.size(), replayed.size(), 0, std::nullopt, {}, true};
  auto other = replayed.begin();
  for (const auto& [time, hash] : recorded) {
    while (other != replayed.end() && other->first < time) ++other;
    if (other == replayed.end() || other->first != time) continue;
    if (other->second != hash) {
      ++result.different;
      if (!result.first) result.first = time;
    }
    ++other;
  }
  return result;
}

/// Whether a path is another one or below it.
bool isBelow(std::string_view path, std::string_view other) {
  return path.starts_with(other) && (path.size() == other.size() || path[other.size()] == '.');
}

/// How much a value may differ: by the tolerance of the longest path.
double mostFor(std::string_view path, const std::vector<Tolerance>& tolerances) {
  const Tolerance* best = nullptr;
  for (const Tolerance& tolerance : tolerances)
    if (isBelow(path, tolerance.path) && (!best || tolerance.path.size() > best->path.size()))
      best = &tolerance;
  return best ? best->most : 0;
}

/// Texts and names have no distance: they may differ only where anything may.
bool isWithin(const DifferentValue& value, double most) {
  return most == HUGE_VAL || (numberFrom<double>(value.firstA) &&
                              numberFrom<double>(value.firstB) && value.largest <= most);
}

/// Whether a topic differs in nothing but what may differ. Without values it is not known where.
bool isWithin(const ReplayedTopic& topic, const std::vector<Tolerance>& tolerances) {
  const std::string_view name = std::string_view{topic.topic}.substr(1);
  if (topic.same() || mostFor(name, tolerances) == HUGE_VAL) return true;
  return topic.recorded == topic.replayed && !topic.values.empty() &&
         std::ranges::all_of(topic.values, [&](const DifferentValue& value) {
           return isWithin(value, mostFor(value.path, tolerances));
         });
}

/// Finds the values in which topics differ.
Result<void> findValues(const std::string& log, const std::string& to,
                        std::vector<ReplayedTopic>& topics) {
  auto a = recordedSide(log);
  if (!a) return a.error();
  auto b = recordedSide(to);
  if (!b) return b.error();
  auto comparison = compareSides(**a, **b, [](double) { return true; });
  if (!comparison) return comparison.error();
  for (ComparedTopic& compared : comparison->topics)
    for (ReplayedTopic& topic : topics)
      if (!compared.input && topic.topic == "/" + compared.name)
        topic.values = std::move(compared.values);
  return {};
}

std::string differences(const ReplayedTopic& topic) {
  if (topic.replayed == 0) return "nothing replayed";
  if (topic.same()) return "the same";
  if (topic.different == 0) return "the same at the same times";
  std::string text =
      fmt::format("{} differ, the first at {:.3f} s", topic.different, seconds(*topic.first));
  const auto most = std::ranges::max_element(topic.values, {}, &DifferentValue::largest);
  if (most != topic.values.end() && most->largest > 0)
    text += fmt::format(", most {} by {:.6g}", most->path, most->largest);
  return text;
}

/// The metadata of a replay.
McapWriter::Metadata aboutReplay(const ReplayOptions& options, const McapReader& log) {
  McapWriter::Metadata about{{"replay of", std::filesystem::path{options.log}.filename()}};
  std::string solutions;
  for (const Configuration::SolutionChoice& choice : options.solutions)
    solutions += (solutions.empty() ? "" : " ") + choice.task + "=" + choice.solution;
  if (!solutions.empty()) about.emplace("solutions", solutions);
  for (const McapReader::Metadata& metadata : log.metadata())
    if (const auto begins = metadata.entries.find(beginsWithProgram);
        begins != metadata.entries.end())
      about.insert(*begins);
  return about;
}

/// Returns the topics that the robot computes.
Result<std::vector<std::string>> record(const ReplayOptions& options, const std::string& to,
                                        std::vector<std::string>& caveats) {
  auto platform = ReplayPlatform::make(options);
  if (!platform) return platform.error();
  auto log = RobotLog::open(unfinishedName(to), aboutReplay(options, platform->player().log()));
  if (!log) return Error{.file = to, .what = log.error().what};
  UnfinishedFile unfinished{to};
  platform->watchAll();
  static_cast<void>(platform->robot().request(DebugRequest{traceKey, DebugKeyMode::always, 0}));
  std::vector<std::string> topics;
  const Robot& robot = platform->robot();
  if (robot.provided<MotionRequest>() && !robot.isDisabled(representation<MotionRequest>()))
    topics.emplace_back(traceTopic);
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
  if (auto done = unfinished.finish(); !done) return done.error();
  caveats = platform->caveats();
  return topics;
}

}  // namespace

Result<Tolerance> parseTolerance(const std::string& text) {
  const auto at = text.find('=');
  const std::string path = text.substr(0, at);
  if (at == text.npos || !messageType(path.substr(0, path.find('.'))))
    return Error{.field = text,
                 .what = at == text.npos ? "expected PATH=NUMBER" : "there is no such value"};
  const std::string number = text.substr(at + 1);
  if (number == "inf") return Tolerance{path, HUGE_VAL};
  const auto most = numberFrom<double>(number);
  if (!most || !(*most >= 0))
    return Error{.field = text, .what = "expected a number that is not negative, or inf"};
  return Tolerance{path, *most};
}

bool ReplayReport::within() const {
  return std::ranges::all_of(topics, &ReplayedTopic::within);
}

std::string ReplayReport::text() const {
  std::string text;
  for (const std::string& caveat : caveats) text += "note: " + caveat + "\n";
  for (const ReplayedTopic& topic : topics)
    text += fmt::format("{:24} recorded {:7}, replayed {:7}, {}{}\n", topic.topic, topic.recorded,
                        topic.replayed, differences(topic),
                        topic.within && !topic.same() ? ": within what may differ" : "");
  return text;
}

Result<ReplayReport> replayLog(const ReplayOptions& options, const std::string& to,
                               const std::vector<Tolerance>& tolerances) {
  std::error_code failure;
  if (std::filesystem::equivalent(options.log, to, failure))
    return Error{.file = to, .what = "is the log that is read"};
  ReplayReport report;
  const auto topics = record(options, to, report.caveats);
  if (!topics) return topics.error();
  const auto recorded = tracesOf(options.log, *topics);
  if (!recorded) return recorded.error();
  const auto replayed = tracesOf(to, *topics);
  if (!replayed) return replayed.error();
  for (const std::string& topic : *topics)
    if (!recorded->at(topic).empty())
      report.topics.push_back(compare(topic, recorded->at(topic), replayed->at(topic)));
  if (!std::ranges::all_of(report.topics, &ReplayedTopic::same))
    if (auto done = findValues(options.log, to, report.topics); !done) return done.error();
  for (ReplayedTopic& topic : report.topics) topic.within = isWithin(topic, tolerances);
  return report;
}

}  // namespace gt
