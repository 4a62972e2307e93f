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

/// Begins the topics of what the platform sent to the robot.
constexpr const char* inputTopic = "/input/";
/// The debug key under which a behavior sends what it decides and why (BehaviorTrace); on wherever
/// a log is recorded.
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

/// A camera image as JPEG, in the form that viewers know.
CompressedImage compressed(const Image& image);

/// The name of a log that is not there yet: BASE.mcap, or with the next number BASE.2.mcap.
std::string freeLogFile(const std::string& base);

/// The one writer of robots' logs (MCAP): matches, robots' programs, tools and replays record with
/// it. Each type of message has a channel: /RobotPose, /Drawing; what the platform sent to the
/// robot has /input/NAME, so that a replay sends the same again.
class RobotLog {
 public:
  /// `about` becomes the log's metadata.
  static Result<RobotLog> open(const std::string& path, const McapWriter::Metadata& about);

  /// Messages of these types come from the platform; of all others, from the robot.
  void setInputs(const std::set<std::string, std::less<>>& names);
  /// Whether images from the platform are written whole (by default), or as an ImageHeader: then
  /// what the robot saw in them has to be recorded beside it.
  void keepPixels(bool on) { pixels_ = on; }

  /// Writes messages of all known types (messageTypes); others are passed over.
  void write(const MessageQueue& queue);
  void write(const Message& message);
  /// A value that nobody has sent, such as what only the simulator knows.
  template <typename T>
  void write(Time now, const T& value) {
    file_.write(channel(representation<T>()), now, value);
  }
  /// A camera image as JPEG: /camera.
  void write(const Image& image);
  /// What the platform sends to the robot before it steps at that time.
  void writeInput(Time now, const RepresentationType& type, const void* package);
  template <typename T>
  void writeInput(Time now, const T& package) {
    writeInput(now, representation<T>(), &package);
  }
  /// Makes all that was written readable, however the program ends. After an error nothing more is
  /// written.
  Result<void> flush() { return file_.flush(); }
  Result<void> close() { return file_.close(); }
  /// The first error since open(), once.
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

/// Saves the messages of a queue as a log, BASE.saved.mcap or with the next number. Returns the
/// file's name.
Result<std::string> saveQueue(const MessageQueue& queue, const std::string& base);

}  // namespace gt
