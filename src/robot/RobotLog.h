#pragma once
#include <map>
#include <string>

#include "framework/Representation.h"
#include "representations/infrastructure/Image.h"
#include "streams/Mcap.h"
#include "streams/Schema.h"

namespace gt {

/// A picture as JPEG, in the form that viewers know.
CompressedImage compressed(const Image& image);

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
  /// Makes all that was written readable, however the program ends.
  void flush() { writer_.flush(); }
  Result<void> close() { return writer_.close(); }

 private:
  explicit RobotLog(McapWriter writer);

  McapWriter writer_;
  std::map<std::uint32_t, McapWriter::ChannelId> channels_;
  McapWriter::ChannelId camera_;
};

}  // namespace gt
