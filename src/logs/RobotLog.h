#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "framework/Representation.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"
#include "streams/Schema.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// Prefix of the topics of packages that the platform sent to the robot.
constexpr const char* inputTopic = "/input/";
/// The debug key under which a behavior sends its decisions and their causes (BehaviorTrace). It is
/// switched on wherever a log is recorded.
constexpr const char* traceKey = "BehaviorControl/trace";

/// A camera image without its pixels, in logs that do not hold them.
struct ImageHeader {
  Time time;
  CameraInfo info;

  static constexpr auto fields() {
    return Fields{field<&ImageHeader::time>(Unit::ms), field<&ImageHeader::info>()};
  }
};
static_assert(complete<ImageHeader>);

/// Compresses a camera image as JPEG, in the form that viewers can read.
CompressedImage compressed(const Image& image);

/// The name of a log that does not exist yet: BASE.mcap, or with the next number BASE.2.mcap.
std::string freeLogFile(const std::string& base);

/// Writes robots' logs (MCAP). Matches, robots' programs, tools and replays all use it. Each type
/// of message has a channel, such as /RobotPose or /Drawing. Packages that the platform sent to the
/// robot have /input/NAME, so that a replay can send them again.
class RobotLog {
 public:
  /// `about` is written as the log's metadata.
  static Result<RobotLog> open(const std::string& path, const McapWriter::Metadata& about);

  /// Sets the types of messages that come from the platform; all others come from the robot.
  void setInputs(const std::set<std::string, std::less<>>& names);
  /// Sets whether images from the platform are written completely (default), or as an ImageHeader.
  /// In the latter case the percepts of the images must be recorded, too.
  void keepPixels(bool on) { pixels_ = on; }

  /// Writes messages of all known types (messageTypes); others are ignored.
  void write(const MessageQueue& queue);
  void write(const Message& message);
  /// Writes a value that no process sends, such as ground truth of the simulator.
  template <typename T>
  void write(Time now, const T& value) {
    file_.write(channel(representation<T>()), now, value);
  }
  /// Writes a camera image as JPEG: /camera.
  void write(const Image& image);
  /// Writes a package that the platform sends to the robot before its step at this time.
  void writeInput(Time now, const RepresentationType& type, const void* package);
  template <typename T>
  void writeInput(Time now, const T& package) {
    writeInput(now, representation<T>(), &package);
  }
  /// Makes everything written so far readable, however the program ends. After an error nothing
  /// more is written.
  Result<void> flush() { return file_.flush(); }
  Result<void> close() { return file_.close(); }
  /// Returns the first error since open(), only once.
  std::optional<Error> takeError() { return file_.takeError(); }
  std::uint64_t messages() const { return messages_; }

  McapWriter& file() { return file_; }

 private:
  explicit RobotLog(McapWriter file) : file_{std::move(file)} {}
  McapWriter::ChannelId channel(const RepresentationType& type);
  McapWriter::ChannelId inputChannel(const RepresentationType& type);
  void writeFrames(Time now, const SensorDataBuffer& buffer);

  McapWriter file_;
  std::map<std::uint32_t, McapWriter::ChannelId> channels_, inputChannels_;  ///< By types' ids.
  std::set<std::uint32_t> inputs_;
  bool pixels_ = true;
  std::uint64_t messages_ = 0;
  Time newestFrame_ = never();
  std::vector<std::byte> bytes_;
};

/// Writes the messages of a queue to a log, BASE.saved.mcap or with the next number. Returns the
/// file's name.
Result<std::string> saveQueue(const MessageQueue& queue, const std::string& base);

}  // namespace gt
