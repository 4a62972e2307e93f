#include "robot/RobotLog.h"

#include <filesystem>

#include "debug/Drawing.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/BehaviorTrace.h"
#include "streams/Jpeg.h"

namespace gt {

CompressedImage compressed(const Image& image) {
  CompressedImage result;
  result.header = {RosTime::of(image.time), "camera"};
  result.data = encodeJpeg(&image.pixels.front().y, image.info.width, image.info.height);
  return result;
}

std::string freeLogFile(const std::string& base) {
  std::string file = base + ".mcap";
  for (int i = 2; std::filesystem::exists(file); ++i)
    file = base + "." + std::to_string(i) + ".mcap";
  return file;
}

RobotLog::RobotLog(McapWriter writer) : writer_{std::move(writer)} {
  for (const RepresentationType* type :
       {&representation<Text>(), &representation<Drawing>(), &representation<Plot>(),
        &representation<StopwatchTime>(), &representation<DroppedMessages>(),
        &representation<BehaviorTrace>(), &representation<BehaviorState>()})
    know(*type);
  camera_ = writer_.addChannel<CompressedImage>("/camera");
}

Result<RobotLog> RobotLog::open(const std::string& path, const McapWriter::Metadata& about) {
  auto writer = McapWriter::open(path);
  if (!writer) return writer.error();
  writer->metadata("gt2003", about);
  return RobotLog{std::move(*writer)};
}

void RobotLog::know(const RepresentationType& type) {
  channels_.try_emplace(type.id, writer_.addChannel("/" + std::string{type.name}, type.schema()));
}

void RobotLog::knowInput(const RepresentationType& type) {
  inputs_.try_emplace(type.id,
                      writer_.addChannel(inputTopic + std::string{type.name}, type.schema()));
}

void RobotLog::write(const MessageQueue& queue) {
  queue.handleAllMessages([this](const Message& message) {
    const auto channel = channels_.find(message.id);
    if (channel != channels_.end())
      writer_.write(channel->second, nanoseconds(message.time), message.bytes);
  });
}

void RobotLog::write(const Image& image) {
  writer_.write(camera_, image.time, compressed(image));
}

Result<std::string> saveQueue(const MessageQueue& queue, const std::string& base,
                              const SolutionTable& table) {
  const std::string file = freeLogFile(base + ".saved");
  auto log = RobotLog::open(file, {{"robot", std::filesystem::path{base}.filename().string()}});
  if (!log) return log.error();
  for (const auto& [name, task] : table.tasks())
    for (const RepresentationType* type : task.outputs) log->know(*type);
  log->write(queue);
  if (const auto done = log->close(); !done) return done.error();
  return file;
}

}  // namespace gt
