#include "logs/ImportNaoLog.h"

#include "logs/NaoLog.h"
#include "logs/RobotLog.h"
#include "representations/motion/OdometryData.h"

namespace gt {

Result<std::vector<Error>> importNaoLog(const std::string& from, const std::string& to) {
  const auto log = readNaoLog(from);
  if (!log) return log.error();
  std::vector<Error> left = log->damage;
  McapOptions options;
  options.atOnce = true;
  auto writer = McapWriter::open(to, options);
  if (!writer) return writer.error();
  writer->metadata("gt2003", {{"robot", "NAO"}, {"source", "a real robot's log of 2009"}});
  auto frame = log->motionFrames.begin();
  Image image;
  for (const NaoImage& picture : log->pictures) {
    const Time time = picture.cameraMatrix.time;
    for (; frame != log->motionFrames.end() && frame->time <= time; ++frame)
      writer->write("/NaoMotionFrame", frame->time, *frame);
    writer->write(inputTopic + std::string{"CameraMatrix"}, time, picture.cameraMatrix);
    writer->write(inputTopic + std::string{"OdometryData"}, time, OdometryData{picture.odometry});
    if (auto done = log->decode(picture, image); !done) {
      left.push_back(done.error());
      continue;
    }
    writer->write(inputTopic + std::string{"Image"}, image.time, image);
    writer->write("/camera", image.time, compressed(image));
  }
  for (; frame != log->motionFrames.end(); ++frame)
    writer->write("/NaoMotionFrame", frame->time, *frame);
  if (auto done = writer->close(); !done) return done.error();
  return left;
}

}  // namespace gt
