#include "logs/RobotLog.h"

#include <filesystem>

#include "base/UnfinishedFile.h"
#include "images/Jpeg.h"
#include "logs/MessageTypes.h"

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

Result<RobotLog> RobotLog::open(const std::string& path, const McapWriter::Metadata& about) {
  auto file = McapWriter::open(path);
  if (!file) return file.error();
  file->metadata("gt2003", about);
  return RobotLog{std::move(*file)};
}

void RobotLog::setInputs(const std::set<std::string, std::less<>>& names) {
  inputs_.clear();
  for (const std::string& name : names)
    if (const RepresentationType* type = messageType(name)) inputs_.insert(type->id);
}

McapWriter::ChannelId RobotLog::channel(const RepresentationType& type) {
  const auto known = channels_.find(type.id);
  if (known != channels_.end()) return known->second;
  const auto added = file_.addChannel("/" + std::string{type.name}, type.schema());
  return channels_.emplace(type.id, added).first->second;
}

McapWriter::ChannelId RobotLog::inputChannel(const RepresentationType& type) {
  const auto known = inputChannels_.find(type.id);
  if (known != inputChannels_.end()) return known->second;
  const auto added = file_.addChannel(inputTopic + std::string{type.name}, type.schema());
  return inputChannels_.emplace(type.id, added).first->second;
}

void RobotLog::write(const MessageQueue& queue) {
  queue.handleAllMessages([this](const Message& message) { write(message); });
}

void RobotLog::write(const Message& message) {
  const RepresentationType* type = messageType(message.id);
  if (!type) return;
  const bool input = inputs_.contains(type->id);
  file_.write(input ? inputChannel(*type) : channel(*type), nanoseconds(message.time),
              message.bytes);
  ++messages_;
}

void RobotLog::write(const Image& image) {
  file_.write("/camera", image.time, compressed(image));
  ++messages_;
}

/// Of a buffer that has moved on by one frame, the new frame alone.
void RobotLog::writeFrames(Time now, const SensorDataBuffer& buffer) {
  const bool movedByOne = buffer.frames[SensorDataBuffer::capacity - 2].time == newestFrame_;
  newestFrame_ = buffer.newest().time;
  if (movedByOne)
    file_.write(inputChannel(representation<SensorData>()), now, buffer.newest());
  else
    file_.write(inputChannel(representation<SensorDataBuffer>()), now, buffer);
}

void RobotLog::writeInput(Time now, const RepresentationType& type, const void* package) {
  if (&type == &representation<SensorDataBuffer>())
    return writeFrames(now, *static_cast<const SensorDataBuffer*>(package));
  if (&type == &representation<Image>() && !pixels_) {
    const Image& image = *static_cast<const Image*>(package);
    file_.write(inputChannel(representation<ImageHeader>()), now,
                ImageHeader{image.time, image.info});
    return;
  }
  bytes_.resize(type.encodedSize(package));
  type.encodeTo(package, bytes_.data());
  file_.write(inputChannel(type), nanoseconds(now), bytes_);
}

Result<std::string> saveQueue(const MessageQueue& queue, const std::string& base) {
  UnfinishedFile file{freeLogFile(base + ".saved")};
  auto log =
      RobotLog::open(file.written(), {{"robot", std::filesystem::path{base}.filename().string()}});
  if (!log) return log.error();
  log->write(queue);
  if (const auto done = log->close(); !done) return done.error();
  if (const auto done = file.finish(); !done) return done.error();
  return file.path();
}

}  // namespace gt
