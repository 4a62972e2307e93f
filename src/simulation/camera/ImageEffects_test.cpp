#include "simulation/camera/ImageEffects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

/// The mean and standard deviation of a channel.
struct Statistics {
  double mean = 0, standardDeviation = 0;
};
template <typename Channel>
Statistics statisticsOf(const Image& image, Channel channel) {
  double sum = 0, squares = 0;
  for (const Pixel& pixel : image.pixels) {
    sum += channel(pixel);
    squares += channel(pixel) * channel(pixel);
  }
  const auto n = static_cast<double>(image.pixels.size());
  return {sum / n, std::sqrt(squares / n - sum / n * sum / n)};
}
double yOf(const Pixel& p) {
  return p.y;
}
double cbOf(const Pixel& p) {
  return p.cb;
}
double crOf(const Pixel& p) {
  return p.cr;
}

/// An image of nothing but floor: all pixels alike, but for the effects.
class ImageEffectsTest : public testing::Test {
 protected:
  Image floor(const CameraEffects& effects, std::uint64_t seed = 1) const {
    return world_.picture(viewFrom({0, 0, 200}, 0, -pi / 2), effects, nullptr, seed);
  }
  TestWorld world_ =
      TestWorld::fromBodies(R"(<geom type="plane" size="5 5 1" rgba="0.55 0.45 0.4 1"/>)");
  const Pixel plain_ = floor(CameraEffects::none()).at(0, 0);
};

TEST_F(ImageEffectsTest, NothingChangesWithoutEffects) {
  CameraEffects hardly = CameraEffects::none();
  hardly.brightness = 1.000001;  // All is computed, but comes out as it was.
  for (const Image& image : {floor(CameraEffects::none()), floor(hardly)})
    for (const Pixel& p : image.pixels) {
      ASSERT_EQ(p.y, plain_.y);
      ASSERT_EQ(p.cb, plain_.cb);
      ASSERT_EQ(p.cr, plain_.cr);
      ASSERT_EQ(p.unused, 0);
    }
}

// What is added is tabulated if it is the same everywhere: anew for other noise or another cast.
TEST_F(ImageEffectsTest, SteadyNoiseIsTheLimitOfOtherNoise) {
  const CameraView view = viewFrom({0, 0, 200}, 0, -pi / 2);
  Rasterizer drawn;
  drawn.begin(view.info.width, view.info.height, 0x00907050, false);
  ImagePlanes planes;
  takePlanes(drawn, planes);
  ImageEffects tabulated, computed;
  for (const auto& [noise, cast] : {std::pair{2, 0}, {5, 0}, {5, 9}}) {
    CameraEffects effects;
    effects.noiseY = effects.noiseCb = noise;
    effects.shiftCr = cast;
    Image actual, expected;
    for (Image* image : {&actual, &expected}) {
      image->info = view.info;
      image->allocate();
    }
    tabulated.apply(planes, view, effects, 1, actual);
    effects.rimCb = 1e-9;
    computed.apply(planes, view, effects, 1, expected);
    EXPECT_EQ(std::memcmp(actual.pixels.data(), expected.pixels.data(),
                          sizeof(Pixel) * actual.pixels.size()),
              0)
        << noise << ", " << cast;
  }
}

TEST_F(ImageEffectsTest, NoiseHasTheStandardDeviationAskedFor) {
  CameraEffects effects = CameraEffects::none();
  effects.noiseY = 5;
  effects.noiseCb = 2;
  effects.noiseCr = 1;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Image image = floor(effects, seed);
    // Rounding adds a variance of 1/12.
    const Statistics y = statisticsOf(image, yOf), cb = statisticsOf(image, cbOf),
                     cr = statisticsOf(image, crOf);
    EXPECT_NEAR(y.mean, plain_.y, 0.15);
    EXPECT_NEAR(cb.mean, plain_.cb, 0.1);
    EXPECT_NEAR(cr.mean, plain_.cr, 0.1);
    EXPECT_NEAR(y.standardDeviation, std::sqrt(25 + 1.0 / 12), 0.15);
    EXPECT_NEAR(cb.standardDeviation, std::sqrt(4 + 1.0 / 12), 0.08);
    EXPECT_NEAR(cr.standardDeviation, std::sqrt(1 + 1.0 / 12), 0.05);
    // Neighbors, across, along and in the next channel, have nothing to do with each other.
    double across = 0, along = 0, channels = 0;
    const int width = image.info.width, height = image.info.height;
    for (int row = 1; row < height; ++row)
      for (int x = 1; x < width; ++x) {
        const double value = image.at(x, row).y - y.mean;
        across += value * (image.at(x - 1, row).y - y.mean);
        along += value * (image.at(x, row - 1).y - y.mean);
        channels += value * (image.at(x, row).cb - cb.mean);
      }
    const double n = width * height;
    EXPECT_NEAR(across / n / 25, 0, 0.04);
    EXPECT_NEAR(along / n / 25, 0, 0.04);
    EXPECT_NEAR(channels / n / 10, 0, 0.04);
  }
}

TEST_F(ImageEffectsTest, EachSeedHasItsOwnNoise) {
  const Image one = floor({}, 1), again = floor({}, 1), two = floor({}, 2);
  const std::size_t bytes = one.pixels.size() * sizeof(Pixel);
  EXPECT_EQ(std::memcmp(one.pixels.data(), again.pixels.data(), bytes), 0);
  // Two independent values of standard deviation 3 are equal in one of 10 pixels, also in shifted
  // rows.
  for (int shift = 0; shift < 3; ++shift) {
    int same = 0, count = 0;
    for (int y = shift; y < one.info.height; ++y)
      for (int x = 0; x < one.info.width; ++x, ++count)
        same += one.at(x, y).y == two.at(x, y - shift).y;
    EXPECT_NEAR(same / static_cast<double>(count), 0.095, 0.02);
  }
}

TEST_F(ImageEffectsTest, BrightnessActsOnAllChannels) {
  for (const double factor : {0.5, 0.75, 1.25}) {
    CameraEffects effects = CameraEffects::none();
    effects.brightness = factor;
    const Pixel p = floor(effects).at(30, 30);
    EXPECT_NEAR(p.y, factor * plain_.y, 0.6);
    EXPECT_NEAR(p.cb - 128, factor * (plain_.cb - 128), 0.6);
    EXPECT_NEAR(p.cr - 128, factor * (plain_.cr - 128), 0.6);
  }
  CameraEffects effects = CameraEffects::none();
  effects.brightness = 0;
  EXPECT_EQ(floor(effects).at(5, 5).y, 0);
}

TEST_F(ImageEffectsTest, ACastShiftsTheColors) {
  CameraEffects effects = CameraEffects::none();
  effects.shiftCb = 7;
  effects.shiftCr = -11;
  const Pixel p = floor(effects).at(100, 100);
  EXPECT_EQ(p.y, plain_.y);
  EXPECT_EQ(p.cb, plain_.cb + 7);
  EXPECT_EQ(p.cr, plain_.cr - 11);
  effects.shiftCb = 128;
  EXPECT_LE(floor(effects).at(100, 100).cb, 255);
}

TEST_F(ImageEffectsTest, TheCornersLoseLight) {
  CameraEffects effects = CameraEffects::none();
  effects.vignetting = 0.4;
  const Image image = floor(effects);
  EXPECT_NEAR(image.at(88, 72).y, plain_.y, 0.6);
  EXPECT_NEAR(image.at(0, 72).y, 0.8 * plain_.y, 1);
  EXPECT_NEAR(image.at(88, 0).y, 0.8 * plain_.y, 1);
  for (const int x : {0, 175})
    for (const int y : {0, 143}) EXPECT_NEAR(image.at(x, y).y, 0.6 * plain_.y, 1.5);
}

TEST(ImageEffects, BlurSpreadsAnEdgeByItsStandardDeviation) {
  const TestWorld world = TestWorld::fromBodies(R"(
      <geom type="box" size="0.01 2 2" pos="2 0 0" rgba="0 0 0 1"/>
      <geom type="box" size="0.01 1 2" pos="1.9 1 0" rgba="1 1 1 1"/>)");
  const CameraView view = viewFrom({0, 0, 0});
  const Image sharp = world.picture(view);
  for (const double blur : {0.36, 0.5, 0.61, 0.71, 0.94, 1.66}) {
    CameraEffects effects = CameraEffects::none();
    effects.blur = blur;
    const Image image = world.picture(view, effects);
    const int y = 70;
    double sum = 0, mean = 0, square = 0, highest = 0;
    bool falls = false;
    for (int x = 1; x < image.info.width; ++x) {
      // The derivative of the edge is the kernel: it rises to one peak and falls.
      const double step = image.at(x - 1, y).y - image.at(x, y).y;
      if (step < highest - 2) falls = true;
      EXPECT_TRUE(!falls || step <= highest + 2) << blur;
      highest = falls ? step : std::max(highest, step);
      sum += step;
      mean += step * x;
      square += step * x * x;
      EXPECT_GE(step, 0);
    }
    mean /= sum;
    EXPECT_NEAR(std::sqrt(square / sum - mean * mean), blur, 0.03);
    EXPECT_EQ(image.at(10, y).y, sharp.at(10, y).y);
    EXPECT_EQ(image.at(170, y).y, sharp.at(170, y).y);
  }
}

TEST_F(ImageEffectsTest, NoiseGrowsWithTheBrightness) {
  CameraEffects effects = CameraEffects::none();
  effects.noiseY = 4;
  effects.noiseCb = 3;
  effects.noiseCr = 2;
  effects.noiseGrowth = 0.8;
  for (const double light : {0.3, 1.0, 1.8}) {
    effects.brightness = light;
    const Image image = floor(effects);
    // It grows with the brightness before the light's own changes: what the sensor's pixel gets.
    const double factor = 1 + effects.noiseGrowth * plain_.y / 256;
    EXPECT_NEAR(statisticsOf(image, yOf).standardDeviation, 4 * factor, 0.15) << light;
    EXPECT_NEAR(statisticsOf(image, cbOf).standardDeviation, 3 * factor, 0.15) << light;
    EXPECT_NEAR(statisticsOf(image, crOf).standardDeviation, 2 * factor, 0.1) << light;
    EXPECT_NEAR(statisticsOf(image, yOf).mean, light * plain_.y, 0.8) << light;
  }
}

TEST_F(ImageEffectsTest, NoiseOfNeighborsCorrelates) {
  CameraEffects effects = CameraEffects::none();
  effects.noiseY = effects.noiseCb = 6;
  for (const double correlation : {0.0, 0.2, 0.45}) {
    effects.noiseCorrelation = correlation;
    const Image image = floor(effects);
    for (const auto channel : {yOf, cbOf}) {
      const Statistics all = statisticsOf(image, channel);
      EXPECT_NEAR(all.standardDeviation, 6, 0.25);
      double across = 0, along = 0;
      int n = 0;
      for (int y = 1; y < image.info.height; ++y)
        for (int x = 1; x < image.info.width; ++x, ++n) {
          const double value = channel(image.at(x, y)) - all.mean;
          across += value * (channel(image.at(x - 1, y)) - all.mean);
          along += value * (channel(image.at(x, y - 1)) - all.mean);
        }
      EXPECT_NEAR(across / n / 36, correlation, 0.04);
      EXPECT_NEAR(along / n / 36, 0, 0.04);
    }
  }
}

TEST_F(ImageEffectsTest, TheCornersAreBluish) {
  CameraEffects effects = CameraEffects::none();
  effects.rimCb = 16;
  effects.rimCr = -6;
  const Image image = floor(effects);
  EXPECT_NEAR(image.at(88, 72).cb, plain_.cb, 0.6);
  EXPECT_NEAR(image.at(0, 72).cb, plain_.cb + 8, 1);
  EXPECT_NEAR(image.at(88, 0).cr, plain_.cr - 3, 1);
  for (const int x : {0, 175})
    for (const int y : {0, 143}) {
      EXPECT_NEAR(image.at(x, y).y, plain_.y, 0.6);
      EXPECT_NEAR(image.at(x, y).cb, plain_.cb + 16, 1);
      EXPECT_NEAR(image.at(x, y).cr, plain_.cr - 6, 1);
      EXPECT_EQ(image.at(x, y).unused, 0);
    }
}

/// The standard deviation of the kernel that a step between two halves of an image was blurred by;
/// `value` is a channel at a place along the step.
template <typename Value>
double spreadOf(const Value& value, int from, int to) {
  double sum = 0, mean = 0, square = 0;
  for (int i = from + 1; i < to; ++i) {
    const double step = value(i - 1) - value(i);
    sum += step;
    mean += step * i;
    square += step * i * i;
  }
  mean /= sum;
  return std::sqrt(std::max(0.0, square / sum - mean * mean));
}

TEST(ImageEffects, ColorsBleedIntoTheRowsAboveAndBelow) {
  const TestWorld world = TestWorld::fromBodies(R"(
      <geom type="box" size="0.01 2 2" pos="2 0 0" rgba="0 0 1 1"/>
      <geom type="box" size="0.01 2 1" pos="1.9 0 1" rgba="0.1 0.9 0 1"/>
      <geom type="box" size="0.01 1 2" pos="1.8 1 0" rgba="1 0.2 0 1"/>)");
  const CameraView view = viewFrom({0, 0, 0});
  for (const double bleeding : {0.36, 0.71, 0.93, 1.41, 1.73}) {
    CameraEffects effects = CameraEffects::none();
    effects.chromaBlur = bleeding;
    const Image image = world.picture(view, effects), sharp = world.picture(view);
    EXPECT_NEAR(spreadOf([&](int y) { return crOf(image.at(140, y)); }, 60, 84), bleeding, 0.1);
    EXPECT_NEAR(spreadOf([&](int y) { return cbOf(image.at(140, y)); }, 60, 84), bleeding, 0.1);
    EXPECT_LT(spreadOf([&](int x) { return crOf(image.at(x, 20)); }, 76, 100), 0.05);
    for (int y = 0; y < image.info.height; ++y) ASSERT_EQ(image.at(140, y).y, sharp.at(140, y).y);
  }
}

TEST(ImageEffects, LightDiffersOverTheField) {
  const TestWorld world =
      TestWorld::fromBodies(R"(<geom type="plane" size="5 5 1" rgba="0.4 0.4 0.4 1"/>)");
  const CameraView view = viewFrom({-1500, 300, 200}, 0.4, -0.2);
  CameraEffects effects = CameraEffects::none();
  const double plain = world.picture(view, effects).at(88, 120).y;
  effects.unevenLight = 0.3;
  const Image image = world.picture(view, effects);
  for (const auto& [x, y] : {std::pair{10, 80}, {88, 90}, {170, 100}, {60, 140}, {120, 143}}) {
    const Vector3d ray = view.last.rotation * view.info.ray(x + 0.5, y + 0.5);
    const Vector2d seen = (view.last.translation - 200 / ray.z() * ray).head<2>();
    EXPECT_NEAR(image.at(x, y).y, plain * (1 + 0.3 * UnevenLight::at(seen)), 2.5) << x << " " << y;
  }
}

TEST(CameraEffects, LightGrowsAndShrinks) {
  CameraEffects effects;
  effects.lightChange = 0.4;
  effects.lightPeriod = 8;
  EXPECT_NEAR(effects.at({0}).brightness, 1, 1e-9);
  EXPECT_NEAR(effects.at({2000}).brightness, 1.4, 1e-9);
  EXPECT_NEAR(effects.at({6000}).brightness, 0.6, 1e-9);
  EXPECT_NEAR(effects.at({8000}).brightness, 1, 1e-9);
  effects.brightness = 1.8;
  EXPECT_EQ(effects.at({2000}).brightness, 1.9) << "brighter it does not get";
  CameraSettings slow;
  slow.shutterSpeed = ShutterSpeed::shutter_slow;
  effects.exposure = 10;
  EXPECT_EQ(withSettings(effects, slow).exposure, 20);
}

}  // namespace
}  // namespace gt
