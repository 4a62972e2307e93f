#include "logs/NaoLog.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>

#include "base/File.h"
#include "images/Jpeg.h"
#include "streams/mcap/Mcap.h"
#include "streams/mcap/McapRecords.h"

namespace gt {
namespace {

enum class MessageId : std::uint8_t {
  jpegImage = 4,
  joints = 5,
  sensors = 6,
  odometry = 8,
  cameraMatrix = 17,
  imageCoordinateSystem = 18
};

constexpr std::size_t headerSize = 8;
/// Messages that cannot be read are reported one by one up to so many.
constexpr std::size_t mostDamage = 100;

// The optics of that robot's camera (facts, 3); its rows' exposure is not recorded.
CameraInfo naoCamera(int width, int height) {
  const double scale = width / 320.0;
  return {width, height, 385.54 * scale, 385.54 * scale, 160 * scale, 120 * scale, 0};
}

/// Reads numbers from a message's body, whose size has been checked.
class Body {
 public:
  explicit Body(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T take() {
    T value;
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  Vector2d takeVector2() {
    const double x = take<double>();
    return {x, take<double>()};
  }
  void skip(std::size_t size) { bytes_.remove_prefix(size); }

 private:
  std::string_view bytes_;
};

/// Takes the messages of a log one after another and puts them together to frames.
class Parser {
 public:
  Parser(std::string_view bytes, const std::string& file, NaoLog& log)
      : bytes_(bytes), file_(file), log_(log) {}

  Result<void> parse() {
    if (bytes_.size() < headerSize) return wrong("the file ends within its header");
    Body header{bytes_};
    const auto size = header.take<std::uint32_t>();
    const auto count = header.take<std::uint32_t>();
    offset_ = headerSize;
    std::uint32_t whole = 0;
    bool cut = false;
    for (; number_ < count && !cut; ++number_) {
      const auto body = nextBody();
      cut = !body;
      const auto done = body ? dispatch(id_, *body) : body.error();
      if (done)
        ++whole;
      else if (log_.damage.size() < mostDamage)
        log_.damage.push_back(done.error());
    }
    if (whole == 0 && !log_.damage.empty()) return log_.damage.front();
    if (!cut && offset_ != bytes_.size())
      log_.damage.push_back(wrong("something follows the last message"));
    else if (!cut && size != bytes_.size() - headerSize)
      log_.damage.push_back(wrong("the header states another size than the log has"));
    return {};
  }

 private:
  Error wrong(std::string what) const {
    std::string place = number_ > 0 ? "message " + std::to_string(number_) : "";
    if (time_) place += " after " + timeText(nanoseconds(*time_));
    return {.file = file_, .field = std::move(place), .what = std::move(what)};
  }

  /// Takes the body of the next message; an error if the log is cut off before its end.
  Result<std::string_view> nextBody() {
    const std::size_t left = bytes_.size() - offset_;
    const auto head = left < 4 ? 0 : Body{bytes_.substr(offset_)}.take<std::uint32_t>();
    const std::size_t size = head >> 8;
    if (left < 4 || left - 4 < size) return wrong("the log is cut off; what followed is lost");
    const std::string_view body = bytes_.substr(offset_ + 4, size);
    id_ = static_cast<MessageId>(head & 0xff);
    offset_ += 4 + size;
    return body;
  }

  Result<void> dispatch(MessageId id, std::string_view body) {
    switch (id) {
      case MessageId::jpegImage:
        return image(body);
      case MessageId::joints:
        return joints(body);
      case MessageId::sensors:
        return sensors(body);
      case MessageId::odometry:
        return odometry(body);
      case MessageId::cameraMatrix:
        return cameraMatrix(body);
      case MessageId::imageCoordinateSystem:
        return horizon(body);
    }
    return {};  // Other messages are not needed.
  }

  Result<void> image(std::string_view body) {
    if (body.size() < 16) return wrong("an image without its header");
    Body in{body};
    const auto width = in.take<std::uint32_t>();
    const auto height = in.take<std::uint32_t>();
    const Time time{in.take<std::uint32_t>()};
    const auto size = in.take<std::uint32_t>();
    if (width < 1 || width > 4096 || height < 1 || height > 4096)
      return wrong("an image of " + std::to_string(width) + " by " + std::to_string(height));
    if (size != body.size() - 16) return wrong("an image's size disagrees with its message's");
    NaoImage picture;
    picture.number = static_cast<int>(log_.pictures.size());
    picture.cameraMatrix.time = time;
    picture.cameraMatrix.info = naoCamera(static_cast<int>(width), static_cast<int>(height));
    picture.odometry = odometry_;
    picture.jpegOffset = offset_ - size;
    time_ = time;
    picture.jpegSize = size;
    log_.pictures.push_back(picture);
    return {};
  }

  Result<void> joints(std::string_view body) {
    if (body.size() != 180) return wrong("joint angles must have 180 bytes");
    NaoMotionFrame frame;
    Body in{body};
    for (double& angle : frame.joints) angle = in.take<double>();
    frame.time = {in.take<std::uint32_t>()};
    time_ = frame.time;
    frame.odometry = odometry_;
    log_.motionFrames.push_back(frame);
    return {};
  }

  Result<void> sensors(std::string_view body) {
    if (body.size() != 146) return wrong("sensor values must have 146 bytes");
    if (log_.motionFrames.empty()) return wrong("sensor values before the first joint angles");
    Body in{body};
    for (float& value : log_.motionFrames.back().sensors) value = in.take<float>();
    return {};
  }

  Result<void> odometry(std::string_view body) {
    if (body.size() != 24) return wrong("odometry must have 24 bytes");
    Body in{body};
    odometry_.rotation = in.take<double>();
    odometry_.translation = in.takeVector2();
    if (!std::isfinite(odometry_.rotation) || !odometry_.translation.allFinite())
      return wrong("odometry that is no number");
    if (!log_.motionFrames.empty()) log_.motionFrames.back().odometry = odometry_;
    return {};
  }

  Result<void> cameraMatrix(std::string_view body) {
    if (body.size() != 100) return wrong("a camera matrix must have 100 bytes");
    if (log_.pictures.empty()) return wrong("a camera matrix before the first image");
    Body in{body};
    CameraMatrix& matrix = log_.pictures.back().cameraMatrix;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) matrix.pose.rotation(row, column) = in.take<double>();
    for (int i = 0; i < 3; ++i) matrix.pose.translation[i] = in.take<double>();
    matrix.valid = in.take<std::uint8_t>() != 0;
    const Matrix3d product = matrix.pose.rotation * matrix.pose.rotation.transpose();
    if (!matrix.pose.translation.allFinite() || !product.isIdentity(1e-3))
      return wrong("a camera matrix that is no pose");
    return {};
  }

  Result<void> horizon(std::string_view body) {
    if (body.size() != 160) return wrong("an image coordinate system must have 160 bytes");
    if (log_.pictures.empty()) return wrong("an image coordinate system before the first image");
    Body in{body};
    NaoImage& picture = log_.pictures.back();
    picture.horizonDirection = in.takeVector2();
    in.skip(6 * sizeof(double));
    picture.horizon = in.takeVector2();
    if (!picture.horizonDirection.allFinite() || !picture.horizon.allFinite())
      return wrong("a horizon that is no number");
    return {};
  }

  std::string_view bytes_;
  const std::string& file_;
  NaoLog& log_;
  std::size_t offset_ = 0;
  std::uint32_t number_ = 0;  ///< Of the message that is taken.
  MessageId id_{};
  std::optional<Time> time_;  ///< Of what was taken last.
  Pose2D odometry_;
};

}  // namespace

Result<void> NaoLog::decode(const NaoImage& picture, Image& image) const {
  const auto wrong = [&](std::string what) {
    return Error{.file = file_,
                 .field = "image " + std::to_string(picture.number) + " at " +
                          timeText(nanoseconds(picture.cameraMatrix.time)),
                 .what = std::move(what)};
  };
  const std::string_view jpeg =
      std::string_view{bytes_}.substr(picture.jpegOffset, picture.jpegSize);
  const auto raw = decodeJpeg({reinterpret_cast<const std::uint8_t*>(jpeg.data()), jpeg.size()});
  if (!raw) return wrong(raw.error().what);
  const CameraInfo& info = picture.cameraMatrix.info;
  if (raw->components != 4 || raw->width != info.width || raw->height != info.height)
    return wrong("the JPEG's size or number of components is not that of the image");
  image.time = picture.cameraMatrix.time;
  image.info = info;
  image.allocate();
  // The four components are padding, Cb, Y, Cr (facts, 3). They are marked as Adobe's inverted
  // CMYK, which decoding without conversion leaves alone.
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::uint8_t* p = raw->data.data() + 4 * i;
    image.pixels[i] = {p[2], p[1], p[3], 0};
  }
  return {};
}

bool isNaoLog(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::array<char, headerSize + 4> begin{};
  if (!stream.read(begin.data(), begin.size())) return false;
  // As numbers these bytes might be the sizes of such a log.
  if (std::string_view{begin.data(), begin.size()}.starts_with(
          std::string_view{mcap::magic, mcap::magicSize}))
    return false;
  Body header{{begin.data(), begin.size()}};
  const auto size = header.take<std::uint32_t>();
  const auto count = header.take<std::uint32_t>();
  const auto first = header.take<std::uint32_t>();
  constexpr std::uint32_t mostIds = 32;  // a text's first letter is beyond
  return count > 0 && count <= size / 4 && (first & 0xff) < mostIds && (first >> 8) <= size - 4;
}

Result<NaoLog> parseNaoLog(std::string bytes, const std::string& file) {
  NaoLog log;
  if (auto done = Parser{bytes, file, log}.parse(); !done) return done.error();
  log.file_ = file;
  log.bytes_ = std::move(bytes);
  return log;
}

Result<NaoLog> readNaoLog(const std::string& file) {
  auto bytes = readFile(file);
  return bytes ? parseNaoLog(*std::move(bytes), file) : bytes.error();
}

}  // namespace gt
