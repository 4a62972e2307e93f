#include "console/Recording.h"

#include <filesystem>
#include <map>

#include "representations/All.h"
#include "robot/RobotLog.h"
#include "robot/Solutions.h"
#include "robot/logs/LogPlatform.h"

namespace gt {
namespace {

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

bool Recording::take(const MessageQueue& messages) {
  if (!on_) return true;
  on_ = bytes_ + messages.size() <= mostRecorded;
  if (!on_) return false;
  const auto bytes = messages.bytes();
  queues_.emplace_back(bytes.begin(), bytes.end());
  bytes_ += bytes.size();
  messages.handleAllMessages([this](const Message&) { ++messages_; });
  return true;
}

void Recording::clear() {
  queues_.clear();
  bytes_ = messages_ = 0;
}

Result<void> Recording::save(const std::string& file, const std::string& robot) const {
  std::error_code ignored;  // then opening the file tells what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  auto log = RobotLog::open(file, {{"robot", robot}});
  if (!log) return log.error();
  RecordWriter writer{log->file()};
  for (const std::vector<std::byte>& bytes : queues_) {
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
