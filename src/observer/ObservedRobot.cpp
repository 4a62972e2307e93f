#include "observer/ObservedRobot.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <thread>

#include "framework/Warnings.h"
#include "logs/MessageTypes.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr std::size_t mostPoints = 100'000;
constexpr std::size_t mostTexts = 1000;
constexpr std::size_t mostWarnings = 1000;

/// A message of that type; empty if it is another one or damaged.
template <typename T>
std::optional<T> read(const Message& message) {
  if (!message.is<T>()) return std::nullopt;
  T value;
  if (!message.read(value)) return std::nullopt;
  return value;
}

std::pair<std::string, std::string> splitPath(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == path.npos ? std::pair{path, std::string{}}
                          : std::pair{path.substr(0, dot), path.substr(dot + 1)};
}

void sortOnce(std::vector<std::string>& names) {
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

}  // namespace

ObservedRobot::ObservedRobot(std::string name, std::unique_ptr<RobotLink> link)
    : name_{std::move(name)},
      link_{std::move(link)},
      // Other tools of the robot count from elsewhere.
      asked_{std::chrono::system_clock::now().time_since_epoch().count()} {}

// What comes in.

void ObservedRobot::take(const MessageQueue& messages) {
  messages.handleAllMessages([this](const Message& message) { take(message); });
  if (warnings_.list().size() < mostWarnings) warnings_.add(warningsIn(messages, name_));
  dropViewers();
  if (messages.empty()) return;
  std::erase_if(takers_, [](const auto& taker) { return taker.expired(); });
  for (std::size_t i = 0; i < takers_.size(); ++i)
    if (const auto taker = takers_[i].lock()) (*taker)(messages);
}

std::shared_ptr<const void> ObservedRobot::passTo(RobotLink::Taker taker) {
  auto shared = std::make_shared<const RobotLink::Taker>(std::move(taker));
  takers_.push_back(shared);
  return shared;
}

void ObservedRobot::take(const Message& message) {
  time_ = std::max(time_, message.time);
  if (auto drawing = read<Drawing>(message)) {
    keep(message.time, std::move(*drawing));
  } else if (const auto plot = read<Plot>(message)) {
    keep(plot->key, {message.time, plot->value});
  } else if (const auto lap = read<StopwatchTime>(message)) {
    keep(lap->event, {message.time, lap->microseconds});
  } else if (auto text = read<Text>(message)) {
    addText(std::move(text->text));
  } else if (auto answer = read<RequestAnswer>(message)) {
    take(std::move(*answer));
  } else if (auto description = read<ProcessDescription>(message)) {
    take(std::move(*description));
  } else if (auto times = read<ModuleTimes>(message)) {
    times_[times->process] = std::move(*times);
  } else if (const auto dropped = read<DroppedMessages>(message)) {
    for (const DroppedMessage& type : dropped->types)
      addText("dropped " + std::to_string(type.count) + " messages " + type.type);
  } else {
    Newest& newest = newest_[message.id];
    newest.bytes.assign(message.bytes.begin(), message.bytes.end());
    newest.decoded = false;
    ++newest.count;
  }
}

/// Refusals that nobody waits for any more are reported as texts.
void ObservedRobot::take(RequestAnswer answer) {
  if (answer.asked == asked_)
    answers_.push_back(std::move(answer));
  else if (answer.outcome == RequestOutcome::refused)
    addText(answer.process + ": " + answer.what);
}

void ObservedRobot::take(ProcessDescription description) {
  if (!about_.empty()) {
    if (!description.tasks.empty()) task_ = std::move(description.tasks.front());
    return;
  }
  const auto place =
      std::ranges::lower_bound(processes_, description.process, {}, &ProcessDescription::process);
  if (place != processes_.end() && place->process == description.process)
    *place = std::move(description);
  else
    processes_.insert(place, std::move(description));
}

void ObservedRobot::keep(Time time, Drawing drawing) {
  const auto key = keys_.find(drawing.key);
  if (key != keys_.end() && !key->second.isShown()) return;
  const auto [known, isNew] = drawings_.try_emplace(drawing.key);
  // Several modules may have drawn it at the same time (report E.5).
  const bool sameTime = std::exchange(drawnAt_[drawing.key], time) == time;
  if (isNew || !sameTime || known->second.space != drawing.space)
    known->second = std::move(drawing);
  else
    std::ranges::move(drawing.elements, std::back_inserter(known->second.elements));
}

void ObservedRobot::keep(const std::string& plot, Point point) {
  std::deque<Point>& points = plots_[plot];
  points.push_back(point);
  if (points.size() > mostPoints) points.pop_front();
}

void ObservedRobot::forget() {
  time_ = {};
  drawings_.clear();
  drawnAt_.clear();
  plots_.clear();
  texts_.clear();
  times_.clear();
  for (auto& [type, newest] : newest_) newest.count = 0;
  forgetNames();
}

/// What processes there are, and what they have, may have changed.
void ObservedRobot::forgetNames() {
  for (auto* names : {&representations_, &inputs_, &debugKeys_}) names->clear();
}

void ObservedRobot::addText(std::string text) {
  if (texts_.size() < mostTexts) texts_.push_back(std::move(text));
}

// Requests and answers.

void ObservedRobot::update() {
  link_->exchange([this](const MessageQueue& messages) { take(messages); });
}

/// Lets the robot answer until a condition holds; false if it never did.
template <typename Condition>
bool ObservedRobot::await(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + link_->patience();
  for (;;) {
    update();
    if (condition()) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
}

Result<void> ObservedRobot::awaitAnswers(bool one) {
  const bool answered = await([&] {
    if (answers_.empty()) return false;
    return answers_.size() >= answers_.front().of ||
           (one && std::ranges::any_of(answers_, [](const RequestAnswer& answer) {
              return answer.outcome != RequestOutcome::notConcerned;
            }));
  });
  if (answered) return {};
  if (answers_.empty()) return Error{.field = name_, .what = "the robot does not answer"};
  return Error{.field = name_,
               .what = "only " + std::to_string(answers_.size()) + " of the robot's " +
                       std::to_string(answers_.front().of) + " processes answer"};
}

/// Whether the last message was carried out by a process; false if it concerns none.
Result<bool> ObservedRobot::carriedOut(bool one) {
  const auto all = awaitAnswers(one);
  if (auto refused = refusalOf(asked_); !refused) return refused.error();
  if (!all) return all.error();
  return std::ranges::any_of(
      answers_, [](const RequestAnswer& answer) { return answer.outcome == RequestOutcome::done; });
}

Result<Time> ObservedRobot::write(const RepresentationType& type, const void* message) {
  asked_ = Time{asked_.ms + 1};
  answers_.clear();
  if (type.write(message, asked_, link_->toRobot())) return asked_;
  return Error{.field = name_, .what = "the robot has not taken its last messages yet"};
}

Result<void> ObservedRobot::send(const RepresentationType& type, const void* message) {
  const auto asked = write(type, message);
  if (!asked) return asked.error();
  update();
  return refusalOf(*asked);
}

Result<void> ObservedRobot::refusalOf(Time asked) const {
  for (const RequestAnswer& answer : answers_)
    if (answer.asked == asked && answer.outcome == RequestOutcome::refused)
      return Error{.what = answer.what};
  return {};
}

Result<void> ObservedRobot::request(const DebugRequest& request) {
  const bool off = request.mode == DebugKeyMode::disabled;
  DebugRequest sent = request;
  const auto known = keys_.find(request.key);
  if (off && known != keys_.end() && known->second.subscriptions > 0)
    sent.mode = DebugKeyMode::always;
  if (auto done = this->request<DebugRequest>(sent); !done) return done;
  Key& key = keys_[request.key];
  key.byHand = request.mode == DebugKeyMode::times ? DebugKeyRequest{}
                                                   : DebugKeyRequest{request.mode, request.n};
  key.asked = !off;
  key.off = off;
  if (off) drawings_.erase(request.key);
  return {};
}

Result<void> ObservedRobot::request(const LayoutRequest& request) {
  forgetNames();
  return this->request<LayoutRequest>(request);
}

ObservedRobot::Subscription ObservedRobot::subscribeKey(const std::string& key) {
  Key& asked = keys_[key];
  const bool wasWanted = asked.isWanted();
  ++asked.subscriptions;
  if (!wasWanted) static_cast<void>(send(DebugRequest{key, DebugKeyMode::always, 0}));
  return {*this, key, &ObservedRobot::dropKey};
}

void ObservedRobot::dropKey(const std::string& key) {
  Key& asked = keys_[key];
  --asked.subscriptions;
  if (!asked.isWanted()) static_cast<void>(send(DebugRequest{key, DebugKeyMode::disabled, 0}));
}

std::shared_ptr<const void> ObservedRobot::showKey(const std::string& key) {
  Key& asked = keys_[key];
  const bool wasWanted = asked.isWanted();
  auto viewer = std::make_shared<const char>();
  asked.viewers.push_back(viewer);
  if (!wasWanted && asked.isWanted())
    static_cast<void>(send(DebugRequest{key, DebugKeyMode::always, 0}));
  return viewer;
}

/// Switches off what nobody views any more. Nobody waits for the answer: somebody may just be
/// waiting for another one.
void ObservedRobot::dropViewers() {
  for (auto& [name, key] : keys_) {
    const auto gone =
        std::erase_if(key.viewers, [](const auto& viewer) { return viewer.expired(); });
    if (gone == 0) continue;
    if (!key.asked && !key.isViewed()) drawings_.erase(name);
    const DebugRequest off{name, DebugKeyMode::disabled, 0};
    if (!key.isWanted())
      static_cast<void>(representation<DebugRequest>().write(&off, {}, link_->toRobot()));
  }
}

// Values of representations.

Result<ConstValue> ObservedRobot::decoded(const RepresentationType& type) {
  Newest& newest = newest_[type.id];
  if (!newest.decoded) {
    // What is damaged does not replace the last good value.
    auto value = type.make();
    if (auto done = type.decode(newest.bytes, value.get()); !done) return done.error();
    newest.value = std::move(value);
    newest.decoded = true;
  }
  return ConstValue{*type.type(), newest.value.get()};
}

const void* ObservedRobot::newest(const RepresentationType& type) {
  const auto known = newest_.find(type.id);
  if (known == newest_.end() || known->second.count == 0) return nullptr;
  const auto value = decoded(type);
  return value ? value->data() : nullptr;
}

Result<void> ObservedRobot::isKnown(std::string_view representation) {
  if (representations_.empty())
    if (const auto described = processes(); !described) return described.error();
  if (std::ranges::binary_search(representations_, representation)) return {};
  return Error{.field = std::string{representation}, .what = "no process of the robot has it"};
}

Result<ConstValue> ObservedRobot::value(const std::string& representation) {
  if (const auto here = link_->peek(representation)) return *here;
  if (auto known = isKnown(representation); !known) return known.error();
  const RepresentationType* type = messageType(representation);
  if (!type) return Error{.field = representation, .what = "this program does not know its type"};
  Newest& newest = newest_[type->id];
  if (newest.subscriptions > 0 && newest.count > 0) return decoded(*type);
  const std::uint64_t before = newest.count;
  const auto asked = write(WatchRequest{representation, "", DebugKeyMode::times, 1});
  if (!asked) return asked.error();
  const bool came = await([&] { return newest.count > before || !refusalOf(*asked); });
  if (auto refused = refusalOf(*asked); !refused) return refused.error();
  if (!came) return Error{.field = representation, .what = "the robot does not answer"};
  return decoded(*type);
}

ObservedRobot::Subscription ObservedRobot::subscribe(const std::string& representation) {
  const RepresentationType* type = messageType(representation);
  if (!type) return {};
  if (newest_[type->id].subscriptions++ == 0)
    static_cast<void>(send(WatchRequest{representation, "", DebugKeyMode::always, 0}));
  return {*this, representation, &ObservedRobot::drop};
}

void ObservedRobot::drop(const std::string& representation) {
  Newest& newest = newest_[messageType(representation)->id];
  if (--newest.subscriptions > 0) return;
  static_cast<void>(send(WatchRequest{representation, "", newest.watched.mode, newest.watched.n}));
}

Result<void> ObservedRobot::watch(const std::string& representation, DebugKeyRequest often) {
  if (auto known = isKnown(representation); !known) return known;
  if (auto done = request(WatchRequest{representation, "", often.mode, often.n}); !done)
    return done;
  if (const RepresentationType* type = messageType(representation))
    newest_[type->id].watched = often.mode == DebugKeyMode::times ? DebugKeyRequest{} : often;
  return {};
}

const std::vector<std::string>& ObservedRobot::representations() {
  static_cast<void>(isKnown(""));
  return representations_;
}

const std::vector<std::string>& ObservedRobot::inputs() {
  static_cast<void>(isKnown(""));
  return inputs_;
}

// Values by path.

bool ObservedRobot::has(const std::string& name) {
  return isKnown(name) || task(name);
}

Result<std::string> ObservedRobot::get(const std::string& path) {
  const auto [first, rest] = splitPath(path);
  if (isKnown(first)) {
    const auto found = value(first);
    if (!found) return found.error();
    auto text = detail::getByPath(*found, rest);
    return text ? text : Error{.field = path, .what = text.error().what};
  }
  auto found = parameter(path);
  if (!found) return found.error();
  return std::move(found->second);
}

Result<void> ObservedRobot::set(const std::string& path, const std::string& text, ValueMode mode) {
  const auto [first, rest] = splitPath(path);
  if (isKnown(first)) return request(ValueRequest{first, rest, text, mode});
  auto found = parameter(path);
  if (!found) return found.error();
  if (mode != ValueMode::set)
    return Error{.field = path, .what = "is a parameter, which keeps its value anyway"};
  found->first.value = text;
  return request(found->first);
}

/// A parameter by its name, and its value.
Result<std::pair<ParameterRequest, std::string>> ObservedRobot::parameter(const std::string& path) {
  const auto [name, rest] = splitPath(path);
  const auto described = task(name);
  if (!described) return Error{.field = path, .what = "there is no such value; try get ?"};
  ParameterRequest wanted{name, (*described)->active, rest, ""};
  for (const SolutionDescription& solution : (*described)->solutions)
    if (rest.starts_with(solution.name + "."))
      wanted = {name, solution.name, rest.substr(solution.name.size() + 1), ""};
  for (const SolutionDescription& solution : (*described)->solutions)
    if (solution.name == wanted.solution)
      for (const ParameterDescription& parameter : solution.parameters)
        if (parameter.path == wanted.path) return std::pair{wanted, parameter.value};
  return Error{.field = path, .what = "solution '" + wanted.solution + "' has no such parameter"};
}

Result<std::vector<std::string>> ObservedRobot::paths(const std::string& name) {
  std::vector<std::string> list;
  if (isKnown(name)) {
    const auto found = value(name);
    if (!found) return found.error();
    for (const PathInfo& part : detail::paths(*found)) list.push_back(name + "." + part.path);
    return list;
  }
  const auto described = task(name);
  if (!described) return described.error();
  for (const SolutionDescription& solution : (*described)->solutions)
    for (const ParameterDescription& parameter : solution.parameters)
      list.push_back(name + "." + solution.name + "." + parameter.path);
  return list;
}

// What its processes report about themselves.

Result<const std::vector<ProcessDescription>*> ObservedRobot::processes() {
  about_.clear();
  processes_.clear();
  if (auto done = request(DescriptionRequest{}); !done) return done.error();
  forgetNames();
  for (const ProcessDescription& process : processes_) {
    for (const RepresentationDescription& known : process.representations) {
      if (!known.streamed) continue;
      representations_.push_back(known.name);
      if (known.origin == RepresentationOrigin::platform) inputs_.push_back(known.name);
    }
    debugKeys_.insert(debugKeys_.end(), process.debugKeys.begin(), process.debugKeys.end());
  }
  for (auto* names : {&representations_, &inputs_, &debugKeys_}) sortOnce(*names);
  return &processes_;
}

Result<const TaskDescription*> ObservedRobot::task(const std::string& name) {
  about_ = name;
  task_ = {};
  if (auto done = request(DescriptionRequest{name}); !done) return done.error();
  if (task_.name == name) return &task_;
  return Error{.field = name, .what = "no process solves this task"};
}

const std::vector<std::string>& ObservedRobot::debugKeys() {
  static_cast<void>(isKnown(""));
  return debugKeys_;
}

Result<const std::map<std::string, ModuleTimes>*> ObservedRobot::times() {
  times_.clear();
  if (auto done = request(WatchRequest{"ModuleTimes", "", DebugKeyMode::times, 1}); !done)
    return done.error();
  // They come with the ends of cycles, after the answers.
  if (!await([&] { return times_.size() >= answers_.size(); }) && times_.empty())
    return Error{.field = name_, .what = "the robot does not answer"};
  return &times_;
}

Result<RecordedSetup> ObservedRobot::setup() {
  const std::uint64_t before = newest_[messageId<RecordedSetup>()].count;
  if (auto done = request(SetupRequest{name_}); !done) return done.error();
  if (!await([&] { return newest_[messageId<RecordedSetup>()].count > before; }))
    return Error{.field = name_, .what = "the robot does not tell how it was made"};
  const auto* setup = newest<RecordedSetup>();
  return setup ? Result<RecordedSetup>{*setup}
               : Error{.field = name_, .what = "its setup is damaged"};
}

}  // namespace gt
