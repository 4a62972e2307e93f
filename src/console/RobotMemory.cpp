#include "console/RobotMemory.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "framework/Requests.h"
#include "representations/All.h"
#include "robot/RobotLog.h"
#include "robot/Solutions.h"
#include "robot/logs/LogPlatform.h"

namespace gt {
namespace {

constexpr std::size_t mostSamples = 100'000;
constexpr std::size_t mostTexts = 1000;
constexpr std::size_t mostRecorded = 512u << 20;  // bytes

/// The channels of a log, made as messages of their types turn up.
class RecordWriter {
 public:
  explicit RecordWriter(McapWriter& file) : file_{file} {
    for (const auto& [name, task] : solutions().tasks())
      for (const RepresentationType* type : task.outputs) types_[type->id] = {type, "/"};
    for (const RepresentationType* type :
         {&representation<Text>(), &representation<Drawing>(), &representation<Plot>(),
          &representation<StopwatchTime>(), &representation<DroppedMessages>(),
          &representation<BehaviorState>()})
      types_[type->id] = {type, "/"};
    for (const auto* list : {&platformRepresentations(), &LogPlatform::representations()})
      for (const RepresentationType* type : *list) types_[type->id] = {type, inputTopic};
  }

  void write(const Message& message) {
    const auto type = types_.find(message.id);
    if (type == types_.end()) return;
    auto channel = channels_.find(message.id);
    if (channel == channels_.end()) {
      const std::string topic = type->second.topic + std::string{type->second.type->name};
      channel =
          channels_.emplace(message.id, file_.addChannel(topic, type->second.type->schema())).first;
    }
    file_.write(channel->second, nanoseconds(message.time), message.bytes);
  }

 private:
  struct Known {
    const RepresentationType* type;
    std::string topic;
  };
  McapWriter& file_;
  std::map<std::uint32_t, Known> types_;
  std::map<std::uint32_t, McapWriter::ChannelId> channels_;
};

}  // namespace

void RobotMemory::take(const MessageQueue& messages, const Image* picture) {
  if (picture) picture_ = *picture;
  messages.handleAllMessages([this](const Message& message) {
    Drawing drawing;
    Plot plot;
    Text text;
    StopwatchTime time;
    DroppedMessages dropped;
    RequestAnswer answer;
    Image image;
    if (message.is<Drawing>() && message.read(drawing)) {
      keep(message.time, std::move(drawing));
    } else if (message.is<Plot>() && message.read(plot)) {
      keep(plot.key, {message.time, plot.value});
    } else if (message.is<StopwatchTime>() && message.read(time)) {
      keep(time.event, {message.time, time.microseconds});
    } else if (message.is<Text>() && message.read(text)) {
      keep(std::move(text.text));
    } else if (message.is<RequestAnswer>() && message.read(answer)) {
      if (answer.outcome == RequestOutcome::refused) keep(answer.process + ": " + answer.what);
    } else if (message.is<DroppedMessages>() && message.read(dropped)) {
      for (const DroppedMessage& type : dropped.types)
        keep("dropped " + std::to_string(type.count) + " messages " + type.type);
    } else if (message.is<BehaviorState>()) {
      static_cast<void>(message.read(behavior_));
    } else if (message.is<Image>() && message.read(image)) {
      picture_ = std::move(image);
    }
  });
  if (recording_ && !messages.empty()) keepAll(messages);
}

void RobotMemory::showDrawing(const std::string& key, bool on) {
  if (on) {
    hidden_.erase(key);
  } else {
    hidden_.insert(key);
    drawings_.erase(key);
  }
}

void RobotMemory::keep(Time time, Drawing drawing) {
  if (hidden_.contains(drawing.key)) return;  // on its way when the key was switched off
  const auto [known, isNew] = drawings_.try_emplace(drawing.key, drawing);
  if (isNew) {
    drawnAt_[drawing.key] = time;
    return;
  }
  // Several modules may have drawn it at the same time (report E.5).
  if (std::exchange(drawnAt_[drawing.key], time) != time || known->second.space != drawing.space)
    known->second = std::move(drawing);
  else
    std::ranges::move(drawing.elements, std::back_inserter(known->second.elements));
}

void RobotMemory::keep(const std::string& plot, Sample sample) {
  std::deque<Sample>& samples = plots_[plot];
  samples.push_back(sample);
  if (samples.size() > mostSamples) samples.pop_front();
}

void RobotMemory::keep(std::string text) {
  if (texts_.size() < mostTexts) texts_.push_back(std::move(text));
}

void RobotMemory::keepAll(const MessageQueue& messages) {
  if (recordedBytes_ + messages.size() > mostRecorded) {
    recording_ = false;
    texts_.emplace_back("the recording is full and ends");
    return;
  }
  const auto bytes = messages.bytes();
  record_.emplace_back(bytes.begin(), bytes.end());
  recordedBytes_ += bytes.size();
  messages.handleAllMessages([this](const Message&) { ++recordedMessages_; });
}

std::vector<std::string> RobotMemory::takeTexts() {
  return std::exchange(texts_, {});
}

void RobotMemory::clearRecord() {
  record_.clear();
  recordedBytes_ = recordedMessages_ = 0;
}

Result<void> RobotMemory::saveRecord(const std::string& file, const std::string& robot) const {
  std::error_code ignored;  // then opening the file tells what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  auto log = RobotLog::open(file, {{"robot", robot}});
  if (!log) return log.error();
  RecordWriter writer{log->file()};
  for (const std::vector<std::byte>& bytes : record_) {
    MessageQueue queue{bytes.size()};
    if (!queue.assign(bytes)) continue;
    queue.handleAllMessages([&](const Message& message) {
      writer.write(message);
      Image image;
      if (message.is<Image>() && message.read(image)) log->write(image);
    });
  }
  return log->close();
}

}  // namespace gt
