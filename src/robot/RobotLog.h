#pragma once
#include <map>
#include <string>

#include "framework/Representation.h"
#include "framework/SolutionTable.h"
#include "representations/infrastructure/Image.h"
#include "streams/Mcap.h"
#include "streams/Schema.h"

namespace gt {

/// Before the names of what the platform sent to the robot.
constexpr const char* inputTopic = "/input/";

/// A picture as JPEG, in the form that viewers know.
CompressedImage compressed(const Image& image);

/// The name of a log that is not there yet: BASE.mcap, or with the next number BASE.2.mcap.
std::string freeLogFile(const std::string& base);

/// Writes what a robot sends to its tools into a log file (MCAP), a channel for each type of
/// message: /RobotPose, /Drawing.
class RobotLog {
 public:
  /// `about` becomes the log's metadata.
  static Result<RobotLog> open(const std::string& path, const McapWriter::Metadata& about);

  /// Makes messages of a type known; those of unknown types are passed over.
  void know(const RepresentationType& type);
  void write(const MessageQueue& queue);
  /// A camera picture as JPEG: /camera.
  void write(const Image& image);
  /// Makes a type known that the platform sends. It is written to /input/NAME.
  void knowInput(const RepresentationType& type);
  /// What the platform sends to the robot before it steps at that time, so that a replay can do the
  /// same. Without knowInput() it is passed over.
  template <typename T>
  void writeInput(Time now, const T& package) {
    const auto channel = inputs_.find(representation<T>().id);
    if (channel != inputs_.end()) writer_.write(channel->second, now, package);
  }
  /// Makes all that was written readable, however the program ends.
  void flush() { writer_.flush(); }
  Result<void> close() { return writer_.close(); }

  McapWriter& file() { return writer_; }

 private:
  explicit RobotLog(McapWriter writer);

  McapWriter writer_;
  std::map<std::uint32_t, McapWriter::ChannelId> channels_, inputs_;  ///< By the types' ids.
  McapWriter::ChannelId camera_;
};

/// Saves the messages of a queue as a log, BASE.saved.mcap or with the next number: those of the
/// types that the tasks of a table provide, of texts, drawings and plots. Returns the file's name.
Result<std::string> saveQueue(const MessageQueue& queue, const std::string& base,
                              const SolutionTable& table);

}  // namespace gt
