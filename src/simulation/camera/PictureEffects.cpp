#include "simulation/camera/PictureEffects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/Random.h"

namespace gt {
namespace {

constexpr int channels = 4;
/// Values between the steps are kept with 5 binary digits, so that all fits in 16 bits.
constexpr int fractionBits = 5;
constexpr int gainOne = 1 << 14;
constexpr int noiseOne = 1 << 12;
constexpr std::size_t noisePixels = 1 << 14;

/// Normally distributed numbers, in units of 1 / noiseOne, that all pictures share: each row of a
/// picture begins at a random place.
class NoiseTable {
 public:
  explicit NoiseTable(std::uint64_t seed) : values_(channels * noisePixels) {
    Random random{seed};
    for (auto& value : values_)
      value = static_cast<std::int16_t>(
          std::lround(std::clamp(random.gaussian(), -7.5, 7.5) * noiseOne));
  }
  const std::int16_t* row(std::uint64_t seed, int y, int width) const {
    return &values_[channels * (hash(seed + static_cast<std::uint64_t>(y)) %
                                (noisePixels - static_cast<std::size_t>(width)))];
  }

 private:
  /// Mixes a counter (splitmix64, Steele, Lea and Flood 2014).
  static std::uint64_t hash(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 27) * 0x94d049bb133111eb;
    return x ^ x >> 31;
  }
  std::vector<std::int16_t> values_;
};
const NoiseTable noiseTable{2003};

std::int16_t fixed(double value) {
  return static_cast<std::int16_t>(std::clamp(std::lround(value), -32768l, 32767l));
}

/// What is left of the light at a place from -1 to 1 across or along the picture; the product of
/// both is `1 - loss` in the corners.
double lightAt(double place, double loss) {
  return 1 - (1 - std::sqrt(1 - loss)) * place * place;
}

}  // namespace

void PictureEffects::setTables(int width, const CameraEffects& effects) {
  const auto size = static_cast<std::size_t>(channels * width);
  for (auto* table : {&offset_, &gain_, &base_, &sigma_}) table->resize(size);
  const std::array<double, channels> neutral{0, 128, 128, 0};
  const std::array<double, channels> shift{0, effects.shiftCb, effects.shiftCr, 0};
  const std::array<double, channels> noise{effects.noiseY, effects.noiseCb, effects.noiseCr, 0};
  constexpr double one = 1 << fractionBits;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t channel = i % channels;
    const double place = (2.0 * static_cast<double>(i / channels) + 1) / width - 1;
    const double gain = effects.brightness * lightAt(place, effects.vignetting);
    offset_[i] = fixed(neutral[channel]);
    gain_[i] = fixed(channel == 3 ? 0 : gain * gainOne);
    base_[i] = fixed((neutral[channel] + shift[channel] + (channel == 3 ? 0 : 0.5)) * one);
    sigma_[i] = fixed(noise[channel] * one * 65536 / noiseOne);
  }
}

const std::uint8_t* PictureEffects::blurRow(const Rasterizer& picture, int y, int weight) {
  const auto bytes = [&](int row) {
    return reinterpret_cast<const std::uint8_t*>(
        picture.row(std::clamp(row, 0, picture.height() - 1)));
  };
  if (weight == 0) return bytes(y);
  const std::size_t size = static_cast<std::size_t>(channels * picture.width());
  const auto side = static_cast<std::uint16_t>(weight);
  const auto center = static_cast<std::uint16_t>(256 - 2 * weight);
  vertical_.resize(size + 2 * channels);
  blurred_.resize(size);
  const std::uint8_t *above = bytes(y - 1), *row = bytes(y), *below = bytes(y + 1);
  std::uint8_t* middle = vertical_.data() + channels;
  for (std::size_t i = 0; i < size; ++i)
    middle[i] = static_cast<std::uint8_t>(
        static_cast<std::uint16_t>(row[i] * center + (above[i] + below[i]) * side + 128) >> 8);
  std::memcpy(middle - channels, middle, channels);
  std::memcpy(middle + size, middle + size - channels, channels);
  std::uint8_t* out = blurred_.data();
  for (std::size_t i = 0; i < size; ++i)
    out[i] = static_cast<std::uint8_t>(
        static_cast<std::uint16_t>(middle[i] * center +
                                   (vertical_[i] + vertical_[i + 2 * channels]) * side + 128) >>
        8);
  return out;
}

void PictureEffects::apply(const Rasterizer& picture, const CameraEffects& effects,
                           std::uint64_t seed, Image& image) {
  setTables(picture.width(), effects);
  // A sampled normal distribution, cut off after one pixel.
  const double tail = effects.blur > 0 ? std::exp(-0.5 / (effects.blur * effects.blur)) : 0;
  const int weight = static_cast<int>(std::lround(256 * tail / (1 + 2 * tail)));
  const auto size = static_cast<std::size_t>(channels * picture.width());
  const std::int16_t *offset = offset_.data(), *gain = gain_.data(), *base = base_.data(),
                     *sigma = sigma_.data();
  const auto times = [](std::int16_t a, std::int16_t b) {
    return static_cast<std::int16_t>((a * b) >> 16);
  };
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* in = blurRow(picture, y, weight);
    const std::int16_t* noise = noiseTable.row(seed, y, picture.width());
    auto* out = reinterpret_cast<std::uint8_t*>(&image.at(0, y));
    const double place = (2.0 * y + 1) / picture.height() - 1;
    const auto rowLight = fixed(gainOne * lightAt(place, effects.vignetting));
    for (std::size_t i = 0; i < size; ++i) {
      const auto light = static_cast<std::int16_t>(4 * times(gain[i], rowLight));
      const auto value = static_cast<std::int16_t>((in[i] - offset[i]) << 7);
      const auto sum =
          static_cast<std::int16_t>(times(value, light) + base[i] + times(noise[i], sigma[i]));
      out[i] = static_cast<std::uint8_t>(
          std::clamp<std::int16_t>(static_cast<std::int16_t>(sum >> fractionBits), 0, 255));
    }
  }
}

}  // namespace gt
