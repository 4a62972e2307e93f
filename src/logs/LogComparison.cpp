#include "logs/LogComparison.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/Number.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/Requests.h"
#include "logs/LogPlayer.h"
#include "logs/LogSelection.h"
#include "logs/MessageTypes.h"
#include "logs/RecordedSetup.h"
#include "logs/RobotLog.h"
#include "representations/behavior/BehaviorTrace.h"
#include "streams/MessageDefinition.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// What was sent late comes at most so long after its time, in ms.
constexpr std::int64_t lateness = 200;
/// Values and points that are kept, of all representations.
constexpr std::size_t mostValues = 20'000, mostKeptPoints = 4'000'000;
/// Of longer lists only how many elements differ is counted.
constexpr std::size_t longList = 256;

class RecordedSide : public ComparedSide {
 public:
  explicit RecordedSide(LogPlayer player) : player_{std::move(player)} {}

  Result<void> findChannels() {
    for (const McapChannel& recorded : player_.log().channels()) {
      const std::string_view topic = recorded.topic;
      const bool input = topic.starts_with(inputTopic);
      const std::size_t slash = input ? std::string_view{inputTopic}.size() : 1;
      const RepresentationType* type = messageType(topic.substr(std::min(slash, topic.size())));
      if (!type || !isCompared(*type)) continue;
      Channel& channel = channels_[recorded.id];
      channel = {type, input, std::nullopt, type->make(), {}};
      if (recorded.schemaText == type->schema().text) continue;
      auto definition = MessageDefinition::parse(recorded.schemaName, recorded.schemaText);
      if (definition)
        channel.definition = std::move(*definition);
      else
        channel.unreadable = definition.error().text();
    }
    if (channels_.empty()) return Error{.file = player_.path(), .what = "holds no representations"};
    return {};
  }

  Result<bool> next(const Handler& handle) override {
    return player_.next(
        [&](const McapChannel& recorded, const McapMessage& message) -> Result<void> {
          const auto channel = channels_.find(recorded.id);
          if (channel == channels_.end()) return {};
          const Channel& known = channel->second;
          const Time time{static_cast<std::int64_t>(message.time / 1'000'000)};
          if (!known.unreadable.empty()) {
            lost_.add(recorded, message.time, known.unreadable);
            return {};
          }
          if (!known.definition) {
            handle(*known.type, known.input, time, message.data);
            return {};
          }
          const auto done = readRecorded(*known.definition, message.data,
                                         Value{known.type->type(), known.value.get()});
          if (!done) {
            lost_.add(recorded, message.time, done.error().text());
            return {};
          }
          bytes_.resize(known.type->encodedSize(known.value.get()));
          known.type->encodeTo(known.value.get(), bytes_.data());
          handle(*known.type, known.input, time, bytes_);
          return {};
        });
  }
  Time now() const override { return player_.now(); }
  Time begin() const override { return player_.begin(); }
  Time end() const override { return player_.end(); }
  std::vector<Error> lost() const override {
    std::vector<Error> all = player_.log().damage();
    for (Error& error : lost_.errors(player_.path())) all.push_back(std::move(error));
    return all;
  }

 private:
  struct Channel {
    const RepresentationType* type = nullptr;
    bool input = false;
    std::optional<MessageDefinition> definition{};  ///< If the recorded type is another one.
    std::shared_ptr<void> value{};
    std::string unreadable{};  ///< Why its messages cannot be read; empty if they can.
  };

  LostMessages lost_;
  LogPlayer player_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<std::byte> bytes_;
};

double asNumber(ConstValue scalar) {
  if (scalar.type().kind == Kind::number)
    return numberFrom<double>(scalarText(scalar)).value_or(std::nan(""));
  return scalar.type().kind == Kind::text ? std::nan("") : static_cast<double>(ordinal(scalar));
}

bool isSame(ConstValue a, ConstValue b) {
  switch (a.type().kind) {
    case Kind::number:
    case Kind::enumeration:
      return std::memcmp(a.data(), b.data(), numberSize(a.type().number)) == 0;
    case Kind::record:
      return std::ranges::all_of(
          a.type().parts, [&](const Part& part) { return isSame(a.part(part), b.part(part)); });
    case Kind::array:
    case Kind::list:
      if (a.size() != b.size()) return false;
      for (std::size_t i = 0; i < a.size(); ++i)
        if (!isSame(a.element(i), b.element(i))) return false;
      return true;
    case Kind::boolean:
    case Kind::text:
      break;
  }
  return scalarText(a) == scalarText(b);
}

/// Calls `visit(path, a, b)` with each scalar that differs, and `count(path, a, b)` where lists are
/// too long for that, or have different lengths.
template <typename Visit, typename Count>
void forEachDifference(ConstValue a, ConstValue b, const std::string& path, const Visit& visit,
                       const Count& count) {
  const Type& type = a.type();
  if (type.kind == Kind::record) {
    for (const Part& part : type.parts)
      forEachDifference(a.part(part), b.part(part), path + "." + std::string{part.name}, visit,
                        count);
  } else if (type.kind == Kind::array || type.kind == Kind::list) {
    if (a.size() != b.size())
      count(path + ".size", static_cast<double>(a.size()), static_cast<double>(b.size()));
    const std::size_t common = std::min(a.size(), b.size());
    if (common > longList) {
      std::size_t different = 0;
      for (std::size_t i = 0; i < common; ++i) different += !isSame(a.element(i), b.element(i));
      if (different > 0) count(path + " (elements that differ)", 0, static_cast<double>(different));
      return;
    }
    for (std::size_t i = 0; i < common; ++i)
      forEachDifference(
          a.element(i), b.element(i),
          path + "." +
              (i < type.indexNames.size() ? std::string{type.indexNames[i]} : std::to_string(i)),
          visit, count);
  } else if (!isSame(a, b)) {
    visit(path, a, b);
  }
}

/// Joins what both sides hand over by topic and time.
class Comparer {
 public:
  void take(bool second, const RepresentationType& type, bool input, Time time,
            std::span<const std::byte> bytes) {
    Topic& topic = topics_[{input, type.name}];
    if (!topic.type) {
      topic.type = &type;
      topic.valueA = type.make();
      topic.valueB = type.make();
      topic.result.name = type.name;
      topic.result.input = input;
    }
    (second ? topic.b : topic.a).push_back({time, {bytes.begin(), bytes.end()}});
  }

  /// Compares what came before a time on both sides.
  Result<void> settle(Time until) {
    for (auto& [key, topic] : topics_)
      if (auto done = settle(topic, until); !done) return done;
    return {};
  }

  std::vector<ComparedTopic> results() {
    std::vector<ComparedTopic> results;
    for (auto& [key, topic] : topics_) {
      ComparedTopic& result = topic.result;
      if (result.input && result.compared == 0) continue;
      std::ranges::stable_sort(result.values, {}, &DifferentValue::path);
      results.push_back(std::move(result));
    }
    std::ranges::sort(results, [](const ComparedTopic& x, const ComparedTopic& y) {
      return std::tie(x.input, x.name) < std::tie(y.input, y.name);
    });
    return results;
  }

 private:
  struct Pending {
    Time time;
    std::vector<std::byte> bytes;
  };
  struct Topic {
    const RepresentationType* type = nullptr;
    std::deque<Pending> a{}, b{};
    std::shared_ptr<void> valueA{}, valueB{};
    std::map<std::string, std::size_t> places{};  ///< Of values in the result, by path.
    ComparedTopic result{};
  };

  Result<void> settle(Topic& topic, Time until) {
    const auto due = [&](const std::deque<Pending>& side) {
      return !side.empty() && side.front().time < until;
    };
    while (due(topic.a) || due(topic.b)) {
      const bool onlyA =
          topic.b.empty() || (!topic.a.empty() && topic.a.front().time < topic.b.front().time);
      if (onlyA || topic.a.empty() || topic.b.front().time < topic.a.front().time) {
        ++(onlyA ? topic.result.onlyA : topic.result.onlyB);
        (onlyA ? topic.a : topic.b).pop_front();
        continue;
      }
      if (auto done = compare(topic, topic.a.front(), topic.b.front()); !done) return done;
      topic.a.pop_front();
      topic.b.pop_front();
    }
    return {};
  }

  Result<void> compare(Topic& topic, const Pending& a, const Pending& b) {
    ++topic.result.compared;
    if (a.bytes == b.bytes) return {};
    for (const auto& [bytes, value] :
         {std::pair{&a.bytes, topic.valueA.get()}, std::pair{&b.bytes, topic.valueB.get()}})
      if (auto done = topic.type->decode(*bytes, value); !done)
        return Error{.field = topic.result.name, .what = done.error().text()};
    ++topic.result.different;
    topic.result.times.push_back(a.time);
    const Type& type = *topic.type->type();
    forEachDifference(
        ConstValue{type, topic.valueA.get()}, ConstValue{type, topic.valueB.get()},
        topic.result.name,
        [&](const std::string& path, ConstValue x, ConstValue y) {
          if (DifferentValue* value = at(topic, path, a.time, [&] {
                return std::pair{scalarText(x), scalarText(y)};
              }))
            add(*value, a.time, asNumber(x), asNumber(y));
        },
        [&](const std::string& path, double x, double y) {
          if (DifferentValue* value = at(topic, path, a.time, [&] {
                return std::pair{numberText(x), numberText(y)};
              }))
            add(*value, a.time, x, y);
        });
    return {};
  }

  template <typename Texts>
  DifferentValue* at(Topic& topic, const std::string& path, Time time, const Texts& texts) {
    const auto known = topic.places.find(path);
    if (known != topic.places.end()) return &topic.result.values[known->second];
    if (values_ >= mostValues) return nullptr;
    ++values_;
    topic.places[path] = topic.result.values.size();
    DifferentValue& made = topic.result.values.emplace_back();
    made.path = path;
    made.first = made.largestAt = time;
    std::tie(made.firstA, made.firstB) = texts();
    return &made;
  }
  void add(DifferentValue& value, Time time, double a, double b) {
    ++value.different;
    const double difference = std::abs(a - b);
    if (difference > value.largest) {
      value.largest = difference;
      value.largestAt = time;
    }
    if (points_ >= mostKeptPoints) return;
    ++points_;
    value.points.push_back({time, a, b});
  }

  std::map<std::pair<bool, std::string_view>, Topic> topics_;
  std::size_t values_ = 0, points_ = 0;
};

}  // namespace

bool isCompared(const RepresentationType& type) {
  const RepresentationType* const others[] = {
      &representation<Text>(),          &representation<Drawing>(),
      &representation<Plot>(),          &representation<StopwatchTime>(),
      &representation<ModuleTimes>(),   &representation<DroppedMessages>(),
      &representation<RequestAnswer>(), &representation<ProcessDescription>(),
      &representation<RecordedSetup>(), &representation<BehaviorTrace>()};
  return type.type() && std::ranges::find(others, &type) == std::end(others);
}

Result<std::unique_ptr<ComparedSide>> recordedSide(const std::string& log) {
  auto player = LogPlayer::open(log);
  if (!player) return player.error();
  auto side = std::make_unique<RecordedSide>(std::move(*player));
  if (auto done = side->findChannels(); !done) return done.error();
  return std::unique_ptr<ComparedSide>{std::move(side)};
}

Result<LogComparison> compareSides(ComparedSide& a, ComparedSide& b,
                                   const std::function<bool(double share)>& progress) {
  LogComparison comparison{std::min(a.begin(), b.begin()), std::max(a.end(), b.end()), {}};
  const auto length =
      static_cast<double>(std::max<std::int64_t>(comparison.end - comparison.begin, 1));
  Comparer comparer;
  bool moreA = true, moreB = true;
  while (moreA || moreB) {
    // The side that is behind.
    const bool second = !moreA || (moreB && b.now() < a.now());
    ComparedSide& side = second ? b : a;
    const auto more = side.next(
        [&](const RepresentationType& type, bool input, Time time,
            std::span<const std::byte> bytes) { comparer.take(second, type, input, time, bytes); });
    if (!more) return more.error();
    if (!*more) (second ? moreB : moreA) = false;
    const Time passed = !moreA ? b.now() : !moreB ? a.now() : std::min(a.now(), b.now());
    if (auto done = comparer.settle(Time{passed.ms - lateness}); !done) return done.error();
    if (!progress(static_cast<double>(passed - comparison.begin) / length)) {
      comparison.stopped = true;
      comparison.end = passed;
      break;
    }
  }
  if (!comparison.stopped)
    if (auto done = comparer.settle(Time{std::numeric_limits<std::int64_t>::max()}); !done)
      return done.error();
  comparison.topics = comparer.results();
  comparison.lost = a.lost();
  for (Error& error : b.lost()) comparison.lost.push_back(std::move(error));
  return comparison;
}

}  // namespace gt
