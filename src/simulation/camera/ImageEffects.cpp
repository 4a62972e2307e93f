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
/// The noise where y is 0; the table for it holds four times the noise.
constexpr int noiseGrowthOne = 1 << 14;

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

/// A column's part of the squared distance from the middle, and a row's; both together are 1 in the
/// corners.
double outward(int i, int count) {
  const double place = (2.0 * i + 1) / count - 1;
  return place * place / 2;
}

/// What is added to each channel; that of the unused one is always negative, so that the byte
/// becomes 0.
std::array<double, channels> baseOf(const CameraEffects& effects) {
  return {0.5, 128.5 + effects.shiftCb, 128.5 + effects.shiftCr, -512};
}

/// The numbers of the table, each mixed with its neighbors in the row so that they correlate.
std::vector<std::int16_t> correlated(double correlation) {
  std::vector<std::int16_t> values = noiseTable.values();
  if (correlation == 0) return values;
  // Of a (1 + a) kernel's neighbors: 2 a / (1 + 2 a^2).
  const double a = (1 - std::sqrt(1 - 2 * correlation * correlation)) / (2 * correlation);
  const double norm = 1 / std::sqrt(1 + 2 * a * a);
  const std::vector<std::int16_t>& own = noiseTable.values();
  for (std::size_t i = channels; i + channels < own.size(); ++i)
    values[i] = fixed(norm * (own[i] + a * (own[i - channels] + own[i + channels])));
  return values;
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

/// The same where light and strength of the noise differ from pixel to pixel.
struct PixelShade {
  const std::uint8_t* in;
  const std::int16_t *offset, *light, *noise, *strength, *columnCast, *rowCast;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<std::int16_t>((in[i] - offset[i]) << 7);
      const auto added = static_cast<std::int16_t>((noise[i] * strength[i]) >> 16);
      const auto cast = static_cast<std::int16_t>(columnCast[i] + rowCast[i]);
      const auto sum = static_cast<std::int16_t>(((value * light[i]) >> 16) + added + cast);
      out[i] = static_cast<std::uint8_t>(
          std::clamp<std::int16_t>(static_cast<std::int16_t>(sum >> fractionBits), 0, 255));
    }
  }
};

/// Gives pixels the cb and cr of others.
struct TakeColors {
  const std::uint8_t *own, *colors;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; i += channels) {
      PackedColor mine = 0, theirs = 0;
      std::memcpy(&mine, own + i, channels);
      std::memcpy(&theirs, colors + i, channels);
      const PackedColor mixed = (mine & 0xff0000ff) | (theirs & 0x00ffff00);
      std::memcpy(out + i, &mixed, channels);
    }
  }
};

/// The light of each pixel of a row, for all of its channels. In a form that the compiler makes
/// wide instructions of, as what follows.
void spreadLight(const std::int16_t* __restrict gain, const std::int16_t* __restrict uneven,
                 int rowLoss, std::int16_t* __restrict out, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const int light = (gain[channels * x] - rowLoss) * uneven[x] >> 14;
    const auto value = static_cast<std::int16_t>(std::min(light, 32767));
    out[4 * x] = value;
    out[4 * x + 1] = value;
    out[4 * x + 2] = value;
    out[4 * x + 3] = value;
  }
}

/// How strong the noise of each pixel is, likewise.
void spreadNoise(const std::uint8_t* __restrict in, int growth, std::int16_t* __restrict out,
                 std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const auto value = static_cast<std::int16_t>(noiseGrowthOne + (growth * in[channels * x] >> 8));
    out[4 * x] = value;
    out[4 * x + 1] = value;
    out[4 * x + 2] = value;
    out[4 * x + 3] = value;
  }
}

/// Whether light or noise differ from pixel to pixel otherwise than by row and column.
bool needsPixels(const CameraEffects& effects) {
  return effects.noiseGrowth > 0 || effects.rimCb != 0 || effects.rimCr != 0 ||
         effects.unevenLight > 0;
}

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
  for (auto* row : {&columnCast_, &rowCast_, &rowLight_, &rowNoise_}) row->resize(size);
  for (auto& row : bled_) row.resize(size);
  uneven_.resize(static_cast<std::size_t>(width));
  const std::array<double, channels> neutral{0, 128, 128, 0};
  for (std::size_t i = 0; i < size; ++i) {
    offset_[i] = fixed(neutral[i % channels]);
    gain_[i] = fixed(effects.brightness * gainOne *
                     (1 - lost(effects, static_cast<int>(i / channels), width)));
  }
}

void ImageEffects::setNoise(const CameraEffects& effects) {
  const std::array<double, channels> noise{effects.noiseY, effects.noiseCb, effects.noiseCr, 0};
  const std::vector<std::int16_t> normal = correlated(effects.noiseCorrelation);
  noise_.resize(normal.size());
  for (std::size_t i = 0; i < noise_.size(); ++i)
    noise_[i] = fixed(4 * noise[i % channels] * fractionOne * normal[i] / noiseOne);
}

void ImageEffects::setAdded(const CameraEffects& effects) {
  const std::array<double, channels> base = baseOf(effects);
  const std::array<double, channels> noise{effects.noiseY, effects.noiseCb, effects.noiseCr, 0};
  const std::vector<std::int16_t> normal = correlated(effects.noiseCorrelation);
  added_.resize(normal.size());
  for (std::size_t i = 0; i < added_.size(); ++i) {
    const std::int16_t sigma = fixed(noise[i % channels] * fractionOne * 65536 / noiseOne);
    added_[i] = static_cast<std::int16_t>(fixed(base[i % channels] * fractionOne) +
                                          (normal[i] * sigma >> 16));
  }
}

void ImageEffects::setRim(int width, const CameraEffects& effects) {
  const std::array<double, channels> base = baseOf(effects);
  const std::array<double, channels> rim{0, effects.rimCb, effects.rimCr, 0};
  for (std::size_t i = 0; i < columnCast_.size(); ++i) {
    const double cast = rim[i % channels] * outward(static_cast<int>(i / channels), width);
    columnCast_[i] = fixed((base[i % channels] + cast) * fractionOne);
  }
}

void ImageEffects::setTables(int width, const CameraEffects& effects) {
  const auto light = [](const CameraEffects& e) { return std::tie(e.brightness, e.vignetting); };
  const auto noise = [](const CameraEffects& e) {
    return std::tie(e.noiseY, e.noiseCb, e.noiseCr, e.noiseCorrelation);
  };
  const auto cast = [](const CameraEffects& e) {
    return std::tie(e.shiftCb, e.shiftCr, e.rimCb, e.rimCr);
  };
  const bool resized = width != width_, otherNoise = noise(effects) != noise(known_);
  const bool otherCast = cast(effects) != cast(known_);
  if (resized || light(effects) != light(known_)) setLight(width, effects);
  if (resized || otherCast) setRim(width, effects);
  // The large tables: robots whose cameras differ share the noise, but not what is added with it.
  if (otherNoise) noise_.clear();
  if (otherNoise || otherCast) added_.clear();
  if (needsPixels(effects) && noise_.empty()) setNoise(effects);
  if (!needsPixels(effects) && added_.empty()) setAdded(effects);
  width_ = width;
  known_ = effects;
}

const std::uint8_t* ImageEffects::colorRow(const Rasterizer& picture, int y) {
  const auto bytes = [&](int row) {
    return reinterpret_cast<const std::uint8_t*>(
        picture.row(std::clamp(row, 0, picture.height() - 1)));
  };
  const double variance = known_.chromaBlur * known_.chromaBlur;
  if (variance == 0) return bytes(y);
  y = std::clamp(y, 0, picture.height() - 1);
  const auto place = static_cast<std::size_t>(y) % bled_.size();
  std::vector<std::uint8_t>& row = bled_[place];
  if (bledRow_[place] == y) return row.data();
  bledRow_[place] = y;
  // The variance of the kernel w/2, 1 - w, w/2 is w, of one twice as wide 4 w.
  const int reach = std::lround(weightOne * variance) < weightOne ? 1 : 2;
  const int weight = static_cast<int>(std::lround(weightOne * variance / (reach * reach)));
  changeRow(Mix{bytes(y - reach), bytes(y), bytes(y + reach), std::min(weight, weightOne - 1)},
            row.data(), row.size());
  changeRow(TakeColors{bytes(y), row.data()}, blurred_.data(), row.size());
  std::memcpy(row.data(), blurred_.data(), row.size());
  return row.data();
}

const std::uint8_t* ImageEffects::blurRow(const Rasterizer& picture, int y, int weight) {
  const auto bytes = [&](int row) { return colorRow(picture, row); };
  if (weight == 0) return bytes(y);
  const std::size_t size = static_cast<std::size_t>(channels * picture.width());
  std::uint8_t* middle = vertical_.data() + channels;
  changeRow(Mix{bytes(y - 1), bytes(y), bytes(y + 1), weight}, middle, size);
  std::memcpy(middle - channels, middle, channels);
  std::memcpy(middle + size, middle + size - channels, channels);
  changeRow(Mix{middle - channels, middle, middle + channels, weight}, blurred_.data(), size);
  return blurred_.data();
}

void ImageEffects::prepareRow(const std::uint8_t* in, int y, int height, std::int16_t rowLoss) {
  const auto growth = static_cast<int>(std::lround(known_.noiseGrowth * (noiseGrowthOne - 1)));
  std::array<std::int16_t, channels> cast{0, fixed(known_.rimCb * outward(y, height) * fractionOne),
                                          fixed(known_.rimCr * outward(y, height) * fractionOne),
                                          0};
  if (known_.unevenLight > 0)
    light_.row(y, uneven_.data());
  else
    std::fill(uneven_.begin(), uneven_.end(), std::int16_t{1 << 14});
  spreadLight(gain_.data(), uneven_.data(), rowLoss, rowLight_.data(), uneven_.size());
  spreadNoise(in, growth, rowNoise_.data(), uneven_.size());
  for (std::size_t x = 0; x < uneven_.size(); ++x)
    std::memcpy(&rowCast_[channels * x], cast.data(), sizeof cast);
}

void ImageEffects::apply(const Rasterizer& picture, const CameraView& view,
                         const CameraEffects& effects, std::uint64_t seed, Image& image) {
  setTables(picture.width(), effects);
  bledRow_.fill(-1);
  const bool byPixel = needsPixels(effects);
  if (effects.unevenLight > 0) light_.set(view, effects.unevenLight);
  const auto size = static_cast<std::size_t>(channels * picture.width());
  // The variance of the kernel w/2, 1 - w, w/2 is w.
  const int weight = static_cast<int>(
      std::clamp(std::lround(weightOne * effects.blur * effects.blur), 0l, weightOne - 1l));
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* in = blurRow(picture, y, weight);
    const std::size_t place = NoiseTable::place(seed, y, picture.width());
    const auto rowLoss = fixed(effects.brightness * gainOne * lost(effects, y, picture.height()));
    auto* out = reinterpret_cast<std::uint8_t*>(&image.at(0, y));
    if (byPixel) {
      prepareRow(in, y, picture.height(), rowLoss);
      changeRow(PixelShade{in, offset_.data(), rowLight_.data(), &noise_[place], rowNoise_.data(),
                           columnCast_.data(), rowCast_.data()},
                out, size);
    } else {
      changeRow(Shade{in, offset_.data(), gain_.data(), &added_[place], rowLoss}, out, size);
    }
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
