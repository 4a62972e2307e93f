#include "robot/replay/LogPlatform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
// libjpeg's header needs what <cstdio> declares.
#include <jpeglib.h>

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/FieldDimensions.h"
#include "representations/modeling/BallModel.h"
#include "representations/perception/BallPercept.h"
#include "support/TestLog.h"

namespace gt {
namespace {

constexpr int width = 320, height = 240;
constexpr Pixel orange{140, 60, 200}, green{90, 110, 100};
constexpr double cameraHeight = 480, tilt = 0.5;

/// As the NAO wrote it: components padding, Cb, Y, Cr.
std::string jpegOf(const std::vector<Pixel>& pixels) {
  jpeg_compress_struct info;
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = width;
  info.image_height = height;
  info.input_components = 4;
  info.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);
  jpeg_start_compress(&info, TRUE);
  std::vector<std::uint8_t> row(4 * width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Pixel& p = pixels[static_cast<std::size_t>(y * width + x)];
      const std::array<std::uint8_t, 4> four{p.y, p.cb, p.y, p.cr};
      std::copy(four.begin(), four.end(), row.begin() + 4 * x);
    }
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&info, &pointer, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::string jpeg{reinterpret_cast<const char*>(bytes), size};
  std::free(bytes);
  return jpeg;
}

/// What the camera sees of a ball on the carpet; no ball at distance 0.
std::vector<Pixel> pictureOf(double distance, const FieldDimensions& field) {
  const CameraInfo camera{width, height, 385.54, 385.54, 160, 120, 0};
  const Vector3d ball{distance, 0, field.ballRadius - cameraHeight};
  std::vector<Pixel> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vector3d ray = (rotationY(tilt) * camera.ray(x + 0.5, y + 0.5)).normalized();
      const bool hit = distance > 0 && (ball - ray * ball.dot(ray)).norm() < field.ballRadius;
      pixels.push_back(hit ? orange : green);
    }
  return pixels;
}

void addPicture(LogBuilder& log, std::uint32_t time, const std::string& jpeg, double walked) {
  log.put(0.0).put(walked).put(0.0).end(8);
  log.put(std::uint32_t{width}).put(std::uint32_t{height}).put(time);
  log.put(static_cast<std::uint32_t>(jpeg.size()));
  for (const char c : jpeg) log.put(c);
  log.end(4);
  const Matrix3d rotation = rotationY(tilt);
  for (int i = 0; i < 9; ++i) log.put(rotation(i % 3, i / 3));
  log.put(0.0).put(0.0).put(cameraHeight).put(std::uint32_t{1}).end(17);
}

class LogPlatformTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto loaded = loadConfiguration(
        {"config/nao2009", "motions", "behavior/GT2003.xabsl", "config/coltable.c64"});
    ASSERT_TRUE(loaded) << loaded.error().text();
    auto configuration = std::make_shared<Configuration>(**loaded);
    ColorTable64 colors;
    for (std::size_t i = 0; i < colors.classes.size(); ++i) {
      const int cr = static_cast<int>(i % 64) * 4, cb = static_cast<int>(i / 64 % 64) * 4;
      colors.classes[i] = cr > 160               ? ColorClass::orange
                          : cb < 125 && cr < 125 ? ColorClass::green
                                                 : ColorClass::noColor;
    }
    configuration->set(colors);
    setup_.configuration = configuration;
    const auto layout = loadLayout("layouts/replay.layout");
    ASSERT_TRUE(layout) << layout.error().text();
    setup_.layout = *layout;
  }

  const FieldDimensions& field() const { return setup_.configuration->get<FieldDimensions>(); }

  RobotSetup setup_;
};

TEST_F(LogPlatformTest, FeedsImagesCameraMatricesAndOdometryToARobot) {
  LogBuilder builder;
  std::vector<double> distances{0, 600, 640, 680, 720, 0};
  for (std::size_t i = 0; i < distances.size(); ++i)
    addPicture(builder, static_cast<std::uint32_t>(1000 + 40 * i),
               jpegOf(pictureOf(distances[i], field())), 10.0 * static_cast<double>(i));
  const auto log = parseNaoLog(builder.log(), "built.log");
  ASSERT_TRUE(log) << log.error().text();
  auto platform = LogPlatform::make(*log, setup_);
  ASSERT_TRUE(platform) << platform.error().text();
  ASSERT_TRUE(
      platform->robot().request(DebugRequest{"ImageProcessor/percepts", DebugKeyMode::always}));
  const auto* ball = platform->robot().provided<BallPercept>();
  const auto* model = platform->robot().provided<BallModel>();
  ASSERT_TRUE(ball);
  ASSERT_TRUE(model);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    ASSERT_FALSE(platform->finished());
    ASSERT_TRUE(platform->step());
    EXPECT_EQ(platform->picture().number, static_cast<int>(i));
    EXPECT_EQ(ball->time.ms, 1000 + 40 * static_cast<int>(i));
    EXPECT_EQ(platform->drawings().size(), 1u);
    ASSERT_EQ(ball->seen, distances[i] > 0) << i;
    EXPECT_EQ(platform->drawings().front().elements.size(), ball->seen ? 1u : 0u);
    if (!ball->seen) continue;
    EXPECT_NEAR(ball->offset.x() / distances[i], 1, 0.03) << i;
    EXPECT_NEAR(ball->distanceByProjection / ball->distanceBySize, 1, 0.06) << i;
  }
  EXPECT_TRUE(platform->finished());
  EXPECT_EQ(model->lastSeen.ms, 1160);
}

TEST_F(LogPlatformTest, GoesOnBehindAnImageThatCannotBeDecoded) {
  LogBuilder builder;
  addPicture(builder, 1000, "no JPEG", 0);
  addPicture(builder, 1040, jpegOf(pictureOf(700, field())), 0);
  const auto log = parseNaoLog(builder.log(), "built.log");
  ASSERT_TRUE(log);
  auto platform = LogPlatform::make(*log, setup_);
  ASSERT_TRUE(platform);
  const auto done = platform->step();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), testing::HasSubstr("built.log: image 0 at 1.000 s: "));
  ASSERT_TRUE(platform->step());
  EXPECT_TRUE(platform->robot().provided<BallPercept>()->seen);
}

TEST_F(LogPlatformTest, RefusesLayoutsThatNeedWhatNoLogProvides) {
  const NaoLog log;
  const auto layout = loadLayout("layouts/cmd.layout");
  ASSERT_TRUE(layout);
  setup_.layout = *layout;
  const auto platform = LogPlatform::make(log, setup_);
  ASSERT_FALSE(platform);
  EXPECT_THAT(platform.error().text(), testing::HasSubstr("layouts/cmd.layout:"));
}

}  // namespace
}  // namespace gt
