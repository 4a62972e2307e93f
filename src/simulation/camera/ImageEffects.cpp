#include "simulation/camera/ImageEffects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>

#include "base/Random.h"

namespace gt {
namespace {

constexpr int channels = 4;
/// Values between the steps are kept with 5 binary digits, so that all fits in 16 bits.
constexpr int fractionBits = 5;
constexpr double fractionOne = 1 << fractionBits;
constexpr int gainOne = 1 << 14;
constexpr int noiseOne = 1 << 12;
constexpr int weightOne = 8;
constexpr std::size_t noisePixels = 1 << 14;

/// Normally distributed numbers, in units of 1 / noiseOne, that all images share: each row of a
/// image begins at a random place.
class NoiseTable {
 public:
  explicit NoiseTable(std::uint64_t seed) : values_(channels * noisePixels) {
    Random random{seed};
    for (auto& value : values_)
      value = static_cast<std::int16_t>(
          std::lround(std::clamp(random.gaussian(), -7.5, 7.5) * noiseOne));
  }
  const std::vector<std::int16_t>& values() const { return values_; }
  /// Where a row begins.
  static std::size_t place(std::uint64_t seed, int y, int width) {
    return channels * (hash(hash(seed) + static_cast<std::uint64_t>(y)) %
                       (noisePixels - static_cast<std::size_t>(width)));
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

/// The part of the light that is lost in a column because of its distance from the middle; the same
/// for rows. Both together are the loss at a pixel.
double lost(const CameraEffects& effects, int i, int count) {
  const double place = (2.0 * i + 1) / count - 1;
  return effects.vignetting / 2 * place * place;
}

/// Mixes values with their neighbors on both sides; the neighbors' weight is in eighths. Built
/// from averages of two, which processors have instructions for.
struct Mix {
  const std::uint8_t *before, *middle, *after;
  int weight;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    const auto mask = [&](int bit) { return static_cast<std::uint8_t>(weight & bit ? 255 : 0); };
    const std::uint8_t one = mask(1), two = mask(2), four = mask(4);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t own = middle[i];
      const auto change = static_cast<std::uint8_t>(own ^ average(before[i], after[i]));
      std::uint8_t mixed = average(own, static_cast<std::uint8_t>(own ^ (change & one)));
      mixed = average(mixed, static_cast<std::uint8_t>(own ^ (change & two)));
      out[i] = average(mixed, static_cast<std::uint8_t>(own ^ (change & four)));
    }
  }
  static std::uint8_t average(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a + b + 1) >> 1);
  }
};

/// Changes the light of a row's values and adds what noise and color cast add.
struct Shade {
  const std::uint8_t* in;
  const std::int16_t *offset, *gain, *added;
  std::int16_t rowLoss;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto light = static_cast<std::int16_t>(gain[i] - rowLoss);
      const auto value = static_cast<std::int16_t>((in[i] - offset[i]) << 7);
      const auto sum = static_cast<std::int16_t>(((value * light) >> 16) + added[i]);
      out[i] = static_cast<std::uint8_t>(
          std::clamp<std::int16_t>(static_cast<std::int16_t>(sum >> fractionBits), 0, 255));
    }
  }
};

// Whole numbers only: processors that work on twice as many at a time get the same bits.
#ifdef __x86_64__
template <typename Change>
[[gnu::target("avx2")]] void changeWide(const Change& change, std::uint8_t* out,
                                        std::size_t count) {
  change(out, count);
}
#endif

template <typename Change>
void changeRow(const Change& change, std::uint8_t* out, std::size_t count) {
#ifdef __x86_64__
  static const bool wide = __builtin_cpu_supports("avx2");
  if (wide) return changeWide(change, out, count);
#endif
  change(out, count);
}

}  // namespace

void ImageEffects::setLight(int width, const CameraEffects& effects) {
  const auto size = static_cast<std::size_t>(channels * width);
  for (auto* table : {&offset_, &gain_}) table->resize(size);
  for (auto* row : {&vertical_, &blurred_}) row->resize(size + 2 * channels);
  const std::array<double, channels> neutral{0, 128, 128, 0};
  for (std::size_t i = 0; i < size; ++i) {
    offset_[i] = fixed(neutral[i % channels]);
    gain_[i] = fixed(effects.brightness * gainOne *
                     (1 - lost(effects, static_cast<int>(i / channels), width)));
  }
}

void ImageEffects::setNoise(const CameraEffects& effects) {
  // The sum of the unused channel is always negative, so that the byte becomes 0.
  const std::array<double, channels> base{0.5, 128.5 + effects.shiftCb, 128.5 + effects.shiftCr,
                                          -512};
  const std::array<double, channels> noise{effects.noiseY, effects.noiseCb, effects.noiseCr, 0};
  const std::vector<std::int16_t>& normal = noiseTable.values();
  added_.resize(normal.size());
  for (std::size_t i = 0; i < added_.size(); ++i) {
    const std::int16_t sigma = fixed(noise[i % channels] * fractionOne * 65536 / noiseOne);
    added_[i] = static_cast<std::int16_t>(fixed(base[i % channels] * fractionOne) +
                                          (normal[i] * sigma >> 16));
  }
}

void ImageEffects::setTables(int width, const CameraEffects& effects) {
  const auto light = [](const CameraEffects& e) { return std::tie(e.brightness, e.vignetting); };
  const auto noise = [](const CameraEffects& e) {
    return std::tie(e.shiftCb, e.shiftCr, e.noiseY, e.noiseCb, e.noiseCr);
  };
  if (width != width_ || light(effects) != light(known_)) setLight(width, effects);
  if (added_.empty() || noise(effects) != noise(known_)) setNoise(effects);
  width_ = width;
  known_ = effects;
}

const std::uint8_t* ImageEffects::blurRow(const Rasterizer& picture, int y, int weight) {
  const auto bytes = [&](int row) {
    return reinterpret_cast<const std::uint8_t*>(
        picture.row(std::clamp(row, 0, picture.height() - 1)));
  };
  if (weight == 0) return bytes(y);
  const std::size_t size = static_cast<std::size_t>(channels * picture.width());
  std::uint8_t* middle = vertical_.data() + channels;
  changeRow(Mix{bytes(y - 1), bytes(y), bytes(y + 1), weight}, middle, size);
  std::memcpy(middle - channels, middle, channels);
  std::memcpy(middle + size, middle + size - channels, channels);
  changeRow(Mix{middle - channels, middle, middle + channels, weight}, blurred_.data(), size);
  return blurred_.data();
}

void ImageEffects::apply(const Rasterizer& picture, const CameraEffects& effects,
                         std::uint64_t seed, Image& image) {
  setTables(picture.width(), effects);
  const auto size = static_cast<std::size_t>(channels * picture.width());
  // The variance of the kernel w/2, 1 - w, w/2 is w.
  const int weight = static_cast<int>(
      std::clamp(std::lround(weightOne * effects.blur * effects.blur), 0l, weightOne - 1l));
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* in = blurRow(picture, y, weight);
    const std::int16_t* added = &added_[NoiseTable::place(seed, y, picture.width())];
    const auto rowLoss = fixed(effects.brightness * gainOne * lost(effects, y, picture.height()));
    changeRow(Shade{in, offset_.data(), gain_.data(), added, rowLoss},
              reinterpret_cast<std::uint8_t*>(&image.at(0, y)), size);
  }
}

void ImageEffects::copy(const Rasterizer& picture, Image& image) {
  const auto size = static_cast<std::size_t>(picture.width());
  for (int y = 0; y < picture.height(); ++y) {
    const PackedColor* in = picture.row(y);
    auto* out = reinterpret_cast<std::uint8_t*>(&image.at(0, y));
    for (std::size_t x = 0; x < size; ++x) {
      const PackedColor color = in[x] & 0xffffff;
      std::memcpy(out + channels * x, &color, channels);
    }
  }
}

}  // namespace gt
