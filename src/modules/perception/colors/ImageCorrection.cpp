#include "modules/perception/colors/ImageCorrection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/WideInstructions.h"

namespace gt {
namespace {

constexpr int carpetStep = 8;        // Pixels between those that are looked at.
constexpr double wellBelow = 8;      // Pixels below the horizon: what is there is ground, mostly.
constexpr int fewestGreen = 24;      // Pixels of an image that show carpet, to learn from it.
constexpr double greenMemory = 0.9;  // The share of what was learned that an image leaves.
constexpr double lightRate = 0.3;    // With which the brightness follows.
constexpr double steadying = 12;     // Pixels in the corners that would show no cast.
constexpr double mostCast = 40;      // Of cb and cr.
constexpr double leastCast = 4;      // Less is not worth a correction,
constexpr double leastGain = 0.2;    // nor is so little light (the logarithm of the gain).
constexpr double mostGain = 4;       // Above it there is nothing left but noise.
constexpr double middlePart = 0.35;  // Of the squared distance to the corners: the lens loses
                                     // little light there.
constexpr std::size_t channels = 4;  // Bytes of a pixel.
constexpr int chromaOfGray = 128, fraction = 64, gainOne = 4096;

/// The part of a row or column of the squared distance from the middle, which is 1 in the corners.
/// `size` is the size of a pixel if the image ranges from -1 to 1.
double outward(int i, double size) {
  const double place = (i + 0.5) * size - 1;
  return place * place / 2;
}

/// Returns whether a color can be a carpet's. The less red it is, the more blue it may be.
bool isGreenish(double y, const Vector2d& chroma) {
  return -chroma.y() > std::max(8., 0.2 * y) && chroma.x() < 0.15 * -chroma.y();
}

/// Corrects a row with 16-bit integers, for which processors have vector instructions.
struct CorrectRow {
  const std::int16_t *column, *corner, *gain, *gray;  ///< For each byte.
  std::int16_t out;                                   ///< How far out the row is.

  [[gnu::always_inline]] inline void operator()(const std::uint8_t* __restrict from,
                                                std::uint8_t* __restrict to,
                                                std::size_t bytes) const {
    for (std::size_t i = 0; i < bytes; ++i) {
      const auto more = static_cast<std::int16_t>(corner[i] * out >> 16);
      const auto value = static_cast<std::int16_t>(fraction * from[i] - column[i] - more);
      const auto quarters = static_cast<std::int16_t>(value * gain[i] >> 16);
      const auto whole = static_cast<std::int16_t>(((quarters + 2) >> 2) + gray[i]);
      to[i] = static_cast<std::uint8_t>(std::clamp<std::int16_t>(whole, 0, 255));
    }
  }
};

}  // namespace

const Image& ImageCorrection::correct(const Image& image, const Horizon& horizon,
                                      const ColorTable64& colors) {
  allocate(image.info);
  observe(image, horizon);
  gain_ = gainFor(colors);
  if (gain_ == 1 && cast_.norm() < leastCast) return image;
  apply(image);
  return corrected_;
}

// Allocates everything with the first image, so that no later image waits for memory.
void ImageCorrection::allocate(const CameraInfo& info) {
  corrected_.info = info;
  corrected_.allocate();
  const std::size_t bytes = channels * static_cast<std::size_t>(info.width);
  for (auto* values : {&columns_, &corners_, &gains_, &neutral_}) values->resize(bytes);
}

void ImageCorrection::observe(const Image& image, const Horizon& horizon) {
  const int width = image.info.width, height = image.info.height;
  const double columnSize = 2. / width, rowSize = 2. / height;
  double yy = 0, yd = 0, dd = 0, middleY = 0;
  Vector2d yChroma = Vector2d::Zero(), dChroma = Vector2d::Zero();
  int green = 0, inMiddle = 0;
  for (int row = carpetStep / 2; row < height; row += carpetStep)
    for (int column = carpetStep / 2; column < width; column += carpetStep) {
      if (horizon.fromImage({column + 0.5, row + 0.5}).y() <= wellBelow) continue;
      const Pixel& pixel = image.at(column, row);
      const double y = pixel.y, d = outward(column, columnSize) + outward(row, rowSize);
      const Vector2d chroma{pixel.cb - chromaOfGray, pixel.cr - chromaOfGray};
      if (!isGreenish(y, chroma - d * cast_)) continue;
      ++green;
      yy += y * y;
      yd += y * d;
      dd += d * d;
      yChroma += y * chroma;
      dChroma += d * chroma;
      if (d > middlePart) continue;
      middleY += y;
      ++inMiddle;
    }
  if (green < fewestGreen) return;
  yy_ = greenMemory * yy_ + yy;
  yd_ = greenMemory * yd_ + yd;
  dd_ = greenMemory * dd_ + dd;
  yChroma_ = greenMemory * yChroma_ + yChroma;
  dChroma_ = greenMemory * dChroma_ + dChroma;
  solve();
  if (2 * inMiddle < fewestGreen) return;
  const double y = middleY / inMiddle;
  greenY_ += (greenY_ > 0 ? lightRate : 1) * (y - greenY_);
}

// The carpet's chroma is tone * y + cast * d, by least squares.
void ImageCorrection::solve() {
  const double dd = dd_ + steadying, determinant = yy_ * dd - yd_ * yd_;
  if (determinant <= 0) return;
  tone_ = (dd * yChroma_ - yd_ * dChroma_) / determinant;
  cast_ = (yy_ * dChroma_ - yd_ * yChroma_) / determinant;
  cast_ = cast_.cwiseMax(-mostCast).cwiseMin(mostCast);
}

// The middle of the brightnesses at which the table classifies the carpet's tone as green is the
// carpet's brightness in the images for which the table was made. A table that does not depend on
// the brightness needs no gain.
double ImageCorrection::gainFor(const ColorTable64& colors) const {
  constexpr int leastWidth = 16;  // Of the brightnesses.
  constexpr double widest = 6;    // The brightest over the darkest.
  if (greenY_ <= 0) return 1;
  int darkest = 0, brightest = 0;
  for (int y = 2; y < 256; y += 4) {
    const Vector2d chroma = chromaOfGray * Vector2d::Ones() + y * tone_;
    if (chroma.minCoeff() < 0 || chroma.maxCoeff() >= 256) break;
    const Pixel pixel{static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(chroma.x()),
                      static_cast<std::uint8_t>(chroma.y()), 0};
    if (colors[pixel] != ColorClass::green) continue;
    if (darkest == 0) darkest = y;
    brightest = y;
  }
  if (brightest - darkest < leastWidth || brightest > widest * darkest) return 1;
  const double gain = (darkest + brightest) / 2.0 / greenY_;
  return std::abs(std::log(gain)) < leastGain ? 1 : std::clamp(gain, 1 / mostGain, mostGain);
}

void ImageCorrection::apply(const Image& image) {
  const int width = image.info.width, height = image.info.height;
  const std::size_t bytes = channels * static_cast<std::size_t>(width);
  corrected_.time = image.time;
  const std::array<double, channels> cast{0, cast_.x(), cast_.y(), 0};
  const auto fixed = [](double value) {
    constexpr int below = 32768;  // Where it is added, to cut off is to round down.
    return static_cast<std::int16_t>(static_cast<int>(value + (below + 0.5)) - below);
  };
  constexpr double one = 32768;
  for (std::size_t c = 0; c < channels; ++c) {
    const int gray = c == 1 || c == 2 ? chromaOfGray : 0;
    const std::int16_t corner = fixed(2 * fraction * cast[c]);
    const std::int16_t gain = fixed(gainOne * (c < 3 ? gain_ : 1));
    const double columnSize = 2. / width;
    for (int x = 0; x < width; ++x) {
      const std::size_t i = channels * static_cast<std::size_t>(x) + c;
      columns_[i] = fixed(fraction * (gray + cast[c] * outward(x, columnSize)));
      corners_[i] = corner;
      gains_[i] = gain;
      neutral_[i] = static_cast<std::int16_t>(gray);
    }
  }
  withWideInstructions([&]() __attribute__((always_inline)) {
    for (int y = 0; y < height; ++y) {
      const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
      CorrectRow{columns_.data(), corners_.data(), gains_.data(), neutral_.data(),
                 fixed(one * outward(y, 2. / height))}(
          reinterpret_cast<const std::uint8_t*>(image.pixels.data() + row),
          reinterpret_cast<std::uint8_t*>(corrected_.pixels.data() + row), bytes);
    }
  });
}

}  // namespace gt
