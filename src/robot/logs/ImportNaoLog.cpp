#include "robot/logs/ImportNaoLog.h"

#include "observer/RobotLog.h"
#include "representations/motion/OdometryData.h"
#include "robot/logs/NaoLog.h"

namespace gt {

Result<void> importNaoLog(const std::string& from, const std::string& to) {
  const auto log = readNaoLog(from);
  if (!log) return log.error();
  auto writer = McapWriter::open(to);
  if (!writer) return writer.error();
  writer->metadata("gt2003", {{"robot", "NAO"}, {"source", "a real robot's log of 2009"}});
  auto frame = log->motionFrames.begin();
  Image image;
  for (const NaoImage& picture : log->pictures) {
    if (auto done = log->decode(picture, image); !done) return done;
    for (; frame != log->motionFrames.end() && frame->time <= image.time; ++frame)
      writer->write("/NaoMotionFrame", frame->time, *frame);
    writer->write(inputTopic + std::string{"CameraMatrix"}, image.time, picture.cameraMatrix);
    writer->write(inputTopic + std::string{"OdometryData"}, image.time,
                  OdometryData{picture.odometry});
    writer->write(inputTopic + std::string{"Image"}, image.time, image);
    writer->write("/camera", image.time, compressed(image));
  }
  for (; frame != log->motionFrames.end(); ++frame)
    writer->write("/NaoMotionFrame", frame->time, *frame);
  return writer->close();
}

}  // namespace gt
