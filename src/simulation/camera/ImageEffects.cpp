#include "simulation/camera/ImageEffects.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

#include "base/Random.h"
#include "base/SplitMix.h"
#include "base/WideInstructions.h"

namespace gt {
namespace {

/// Values between the steps are kept with 5 binary digits, so that all fits in 16 bits.
constexpr int fractionBits = 5;
constexpr double fractionOne = 1 << fractionBits;
constexpr int lightBits = 14;
constexpr double lightOne = 1 << lightBits;
constexpr int noiseOne = 1 << 12;
constexpr int weightOne = 8;
/// Number of rows that share their uneven light, which differs by less than a percent among them.
constexpr int rowsOfLight = 4;
constexpr std::size_t noisePixels = 1 << 14;

std::int16_t fixed(double value) {
  constexpr int low = -32768, high = 32767;
  return static_cast<std::int16_t>(
      static_cast<int>(std::clamp<double>(value, low, high) - low + 0.5) + low);
}

/// Normally distributed numbers for each channel, in units of 1 / noiseOne, that all images share:
/// each row of an image begins at a random place.
class NoiseTable {
 public:
  explicit NoiseTable(std::uint64_t seed) : values_(noisePixels) {
    Random random{seed};
    for (auto& channels : values_)
      for (std::size_t i = 0; i < 4; ++i) {
        const double number = std::clamp(random.gaussian(), -7.5, 7.5);
        if (i < channelCount)
          channels[i] = static_cast<std::int16_t>(std::lround(number * noiseOne));
      }
  }
  /// The numbers of a channel, each mixed with its neighbors in the row so that they correlate.
  std::vector<std::int16_t> channel(std::size_t c, double correlation) const {
    std::vector<std::int16_t> values(noisePixels + Plane::step);
    // The kernel a, 1, a gives neighbors the correlation 2 a / (1 + 2 a^2).
    const double a = correlation == 0
                         ? 0
                         : (1 - std::sqrt(1 - 2 * correlation * correlation)) / (2 * correlation);
    const double norm = 1 / std::sqrt(1 + 2 * a * a);
    for (std::size_t i = 0; i < noisePixels; ++i) {
      const double beside =
          i == 0 || i + 1 == noisePixels ? 0 : values_[i - 1][c] + values_[i + 1][c];
      values[i] = fixed(norm * (values_[i][c] + a * beside));
    }
    return values;
  }
  /// The index at which the noise of a row begins.
  static std::size_t place(std::uint64_t seed, int y, int width) {
    return splitMix(splitMix(seed) + static_cast<std::uint64_t>(y)) %
           (noisePixels - static_cast<std::size_t>(width));
  }

 private:
  std::vector<std::array<std::int16_t, channelCount>> values_;
};
const NoiseTable noiseTable{2003};

/// Half of the squared distance from the middle, of a column or a row: both together are 1 in the
/// corners.
double outward(int i, int count) {
  const double place = (2.0 * i + 1) / count - 1;
  return place * place / 2;
}

/// Mixes values with their neighbors on both sides; the neighbors' weight is in eighths. Built
/// from averages of two, which processors have instructions for.
template <int weight>
struct Mix {
  const std::uint8_t *before, *middle, *after;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t own = middle[i], sides = average(before[i], after[i]);
      const std::uint8_t one = average(own, weight & 1 ? sides : own);
      const std::uint8_t two = average(one, weight & 2 ? sides : own);
      out[i] = average(two, weight & 4 ? sides : own);
    }
  }
  static std::uint8_t average(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a + b + 1) >> 1);
  }
};

/// Mixes a row of a plane with those above and below.
template <int weight>
[[gnu::always_inline]] inline void mixRows(const Plane& plane, int y, std::uint8_t* out) {
  Mix<weight>{plane.nearestRow(y - 1), plane.row(y), plane.nearestRow(y + 1)}(out,
                                                                              plane.paddedWidth());
}

struct CopyRow {
  const std::uint8_t* in;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; i += Plane::step) std::memcpy(out + i, in + i, Plane::step);
  }
};

/// Greatest weight of the neighbors in a pass, in eighths: a half, so that all passes together have
/// one peak.
constexpr int mostWeight = 4;

/// Calls work<weight>(), so that the weight is a compile-time constant.
template <typename Work>
[[gnu::always_inline]] inline void withWeight(int weight, const Work& work) {
  switch (weight) {
    case 0:
      return work.template operator()<0>();
    case 1:
      return work.template operator()<1>();
    case 2:
      return work.template operator()<2>();
    case 3:
      return work.template operator()<3>();
    default:
      assert(weight == mostWeight);
      return work.template operator()<mostWeight>();
  }
}

/// Computes the light of each pixel of a row: its column's light minus the row's loss.
struct Illuminate {
  const std::int16_t* gain;
  std::int16_t rowLoss;

  [[gnu::always_inline]] inline void operator()(std::int16_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::int16_t>(gain[i] - rowLoss);
  }
};

/// Computes the light as Illuminate does, times the uneven light at each pixel.
struct IlluminateUnevenly {
  const std::int16_t *gain, *uneven;
  int rowLoss;

  [[gnu::always_inline]] inline void operator()(std::int16_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      out[i] =
          static_cast<std::int16_t>(std::min((gain[i] - rowLoss) * uneven[i] >> lightBits, 32767));
  }
};

/// A row of one channel in some light.
struct LitRow {
  const std::uint8_t* in;
  std::int16_t neutral;
  const std::int16_t* light;

  [[gnu::always_inline]] inline int at(std::size_t i) const {
    const auto value = static_cast<std::int16_t>((in[i] - neutral) << 7);
    return static_cast<std::int16_t>((value * light[i]) >> 16);
  }
};

[[gnu::always_inline]] inline std::uint8_t toByte(int sum) {
  return static_cast<std::uint8_t>(std::clamp<std::int16_t>(
      static_cast<std::int16_t>(static_cast<std::int16_t>(sum) >> fractionBits), 0, 255));
}

/// Adds noise and color casts that are the same whatever the image shows.
struct AddSteadily {
  LitRow row;
  const std::int16_t* added;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) out[i] = toByte(row.at(i) + added[i]);
  }
};

/// Adds noise that grows with the brightness, and color casts that depend on the place.
struct Add {
  LitRow row;
  const std::uint8_t* bright;  ///< The row's y.
  const std::int16_t* noise;
  std::int16_t deviation, growth;  ///< Of the noise where y is 0, and its increase up to y 256.
  const std::int16_t* columnCast;
  std::int16_t rowCast;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto brightness = static_cast<std::int16_t>(bright[i] << 7);
      const auto half = static_cast<std::int16_t>((brightness * growth) >> 16);
      const auto strength = static_cast<std::int16_t>(deviation + 2 * half);
      const auto added = static_cast<std::int16_t>((noise[i] * strength) >> 16);
      out[i] = toByte(row.at(i) + added + columnCast[i] + rowCast);
    }
  }
};

constexpr std::array<std::int16_t, channelCount> neutral{0, 128, 128};

/// The color casts in the middle of the image, and a half for rounding.
std::array<double, channelCount> castOf(const CameraEffects& effects) {
  return {0.5, 128.5 + effects.shiftCb, 128.5 + effects.shiftCr};
}

/// Whether noise and color casts depend neither on a pixel's brightness nor on its place.
bool isSteady(const CameraEffects& effects) {
  return effects.noiseGrowth == 0 && effects.rimCb == 0 && effects.rimCr == 0;
}

/// Factors of the noise of each channel where y is 0, and their increase up to y 256.
struct NoiseStrength {
  std::array<std::int16_t, channelCount> deviation{}, growth{};

  explicit NoiseStrength(const CameraEffects& effects) {
    constexpr double one = fractionOne * 65536 / noiseOne;
    const std::array<double, channelCount> noise{effects.noiseY, effects.noiseCb, effects.noiseCr};
    for (std::size_t c = 0; c < channelCount; ++c) {
      deviation[c] = fixed(noise[c] * one);
      growth[c] = std::min(
          fixed(effects.noiseGrowth * noise[c] * one),
          static_cast<std::int16_t>(std::numeric_limits<std::int16_t>::max() - deviation[c]));
    }
  }
};

}  // namespace

void ImageEffects::setColumns(const CameraEffects& effects, int width, std::size_t padded) {
  const auto needed = [](const CameraEffects& e) {
    return std::tie(e.brightness, e.vignetting, e.shiftCb, e.shiftCr, e.rimCb, e.rimCr);
  };
  if (width == width_ && needed(effects) == needed(known_)) return;
  width_ = width;
  known_ = effects;
  for (auto* row : {&gain_, &uneven_, &light_}) row->resize(padded);
  for (auto* rows : {&blurred_, &shaded_})
    for (auto& row : *rows) row.resize(padded);
  const std::array<double, channelCount> cast = castOf(effects);
  const std::array<double, channelCount> rim{0, effects.rimCb, effects.rimCr};
  for (auto& column : cast_) column.resize(padded);
  for (std::size_t x = 0; x < padded; ++x) {
    const double out = outward(static_cast<int>(x), width);
    gain_[x] = fixed(effects.brightness * lightOne * (1 - effects.vignetting * out));
    for (std::size_t c = 0; c < channelCount; ++c)
      cast_[c][x] = fixed((cast[c] + rim[c] * out) * fractionOne);
  }
}

void ImageEffects::setNoise(const CameraEffects& effects) {
  const auto needed = [](const CameraEffects& e) {
    return std::tie(e.noiseY, e.noiseCb, e.noiseCr, e.shiftCb, e.shiftCr);
  };
  if (effects.noiseCorrelation != correlation_) {
    correlation_ = effects.noiseCorrelation;
    for (std::size_t c = 0; c < channelCount; ++c) noise_[c] = noiseTable.channel(c, correlation_);
  } else if (!isSteady(effects) || needed(effects) == needed(steady_)) {
    return;
  }
  steady_ = effects;
  const std::array<double, channelCount> cast = castOf(effects);
  const NoiseStrength strength{effects};
  for (std::size_t c = 0; c < channelCount; ++c) {
    const int own = fixed(cast[c] * fractionOne), factor = strength.deviation[c];
    added_[c].resize(noise_[c].size());
    std::ranges::transform(noise_[c], added_[c].begin(), [=](int noise) {
      return static_cast<std::int16_t>(own + (noise * factor >> 16));
    });
  }
}

/// A blur of a given variance (square pixels): passes with the kernel w/2, 1 - w, w/2, each of
/// which has the variance w.
struct ImageEffects::Spread {
  int passes, least = 0, more = 0;

  explicit Spread(double variance) {
    const int eighths = static_cast<int>(std::lround(weightOne * variance));
    passes = (eighths + mostWeight - 1) / mostWeight;
    if (passes == 0) return;
    least = eighths / passes;
    more = eighths % passes;
  }
  /// The weight of the neighbors in a pass, in eighths; nearly the same in all passes.
  int weight(int pass) const { return least + (pass < more ? 1 : 0); }
};

[[gnu::always_inline]] inline const Plane& ImageEffects::spreadRows(const Plane& plane,
                                                                    const Spread& spread,
                                                                    Plane& out) {
  const Plane* from = &plane;
  for (int pass = 0; pass + 1 < spread.passes; ++pass) {
    withWeight(
        spread.weight(pass), [&]<int weight>() __attribute__((always_inline)) {
          for (int y = 0; y < plane.height(); ++y) mixRows<weight>(*from, y, mixed_.row(y));
        });
    std::swap(mixed_, out);
    from = &out;
  }
  return *from;
}

[[gnu::always_inline]] inline const std::uint8_t* ImageEffects::spreadAcross(const Plane& plane,
                                                                             int y,
                                                                             const Spread& across,
                                                                             std::uint8_t* out) {
  if (across.passes == 0) return plane.row(y);
  withWeight(
      across.weight(across.passes - 1), [&]<int weight>() __attribute__((always_inline)) {
        mixRows<weight>(plane, y, out);
      });
  return out;
}

[[gnu::always_inline]] inline const std::uint8_t* ImageEffects::spreadAlong(const std::uint8_t* row,
                                                                            const Spread& along,
                                                                            std::uint8_t* middle,
                                                                            std::uint8_t* out) {
  const auto width = static_cast<std::size_t>(width_);
  for (int pass = 0; pass < along.passes; ++pass) {
    if (row != middle) CopyRow{row}(middle, mixedRows_.paddedWidth());
    middle[-1] = middle[0];
    middle[width] = middle[width - 1];
    withWeight(
        along.weight(pass), [&]<int weight>() __attribute__((always_inline)) {
          Mix<weight>{middle - 1, middle, middle + 1}(out, mixedRows_.paddedWidth());
        });
    row = out;
  }
  return row;
}

[[gnu::always_inline]] inline void ImageEffects::lightRow(const CameraEffects& effects, int y,
                                                          double out) {
  const std::int16_t rowLoss = fixed(effects.brightness * lightOne * effects.vignetting * out);
  if (effects.unevenLight > 0) {
    if (y % rowsOfLight == 0) unevenLight_.row(y, uneven_.data());
    IlluminateUnevenly{gain_.data(), uneven_.data(), rowLoss}(light_.data(), light_.size());
  } else {
    Illuminate{gain_.data(), rowLoss}(light_.data(), light_.size());
  }
}

[[gnu::always_inline]] inline void ImageEffects::applyWide(const ImagePlanes& picture,
                                                           const CameraEffects& effects,
                                                           std::uint64_t seed, Image& image) {
  const int width = image.info.width, height = image.info.height;
  const std::size_t padded = picture[0].paddedWidth();
  const double lens = effects.blur * effects.blur,
               bleeding = effects.chromaBlur * effects.chromaBlur;
  const Spread along{lens};
  const std::array<Spread, channelCount> across{along, Spread{lens + bleeding},
                                                Spread{lens + bleeding}};
  std::array<const Plane*, channelCount> spread{};
  for (std::size_t c = 0; c < channelCount; ++c)
    spread[c] = &spreadRows(picture[c], across[c], spread_[c]);
  const std::array<double, channelCount> rim{0, effects.rimCb, effects.rimCr};
  const NoiseStrength strength{effects};
  const bool steady = isSteady(effects);
  for (int y = 0; y < height; ++y) {
    const double out = outward(y, height);
    lightRow(effects, y, out);
    // Channel by channel: a row that was just written is not at once available for reading.
    std::array<const std::uint8_t*, channelCount> in{};
    const auto middle = [&](std::size_t c) { return mixedRows_.row(static_cast<int>(c)); };
    for (std::size_t c = 0; c < channelCount; ++c)
      in[c] = spreadAcross(*spread[c], y, across[c], middle(c));
    for (std::size_t c = 0; c < channelCount; ++c)
      in[c] = spreadAlong(in[c], along, middle(c), blurred_[c].data());
    const std::size_t place = NoiseTable::place(seed, y, width);
    for (std::size_t c = 0; c < channelCount; ++c) {
      const LitRow row{in[c], neutral[c], light_.data()};
      if (steady)
        AddSteadily{row, &added_[c][place]}(shaded_[c].data(), padded);
      else
        Add{row,
            in[0],
            &noise_[c][place],
            strength.deviation[c],
            strength.growth[c],
            cast_[c].data(),
            fixed(rim[c] * out * fractionOne)}(shaded_[c].data(), padded);
    }
    joinRow({shaded_[0].data(), shaded_[1].data(), shaded_[2].data()},
            {&image.at(0, y), static_cast<std::size_t>(width)});
  }
}

void ImageEffects::apply(const ImagePlanes& picture, const CameraView& view,
                         const CameraEffects& effects, std::uint64_t seed, Image& image) {
  const int width = view.info.width, height = view.info.height;
  setColumns(effects, width, picture[0].paddedWidth());
  setNoise(effects);
  mixedRows_.resize(width, channelCount);
  mixed_.resize(width, height);
  for (Plane& plane : spread_) plane.resize(width, height);
  if (effects.unevenLight > 0) unevenLight_.set(view, effects.unevenLight);
  withWideInstructions([&]() __attribute__((always_inline)) {
    applyWide(picture, effects, seed, image);
  });
}

}  // namespace gt
