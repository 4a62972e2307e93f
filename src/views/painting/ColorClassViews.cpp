#include "views/painting/ColorClassViews.h"

#include <array>
#include <cmath>

#include "colors/ClassColors.h"
#include "colors/Rgb.h"

namespace gt {
namespace {

void append(RgbImage& picture, const Color& color) {
  picture.pixels.insert(picture.pixels.end(), {color.r, color.g, color.b});
}

Color colorOf(const Pixel& pixel) {
  const Rgb rgb = rgbOf(pixel);
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
  return {byte(rgb.red), byte(rgb.green), byte(rgb.blue)};
}

/// The colors of one brightness: cb to the right, cr upwards.
template <typename ColorAt>
RgbImage slice(int y, ColorAt colorAt) {
  RgbImage picture{64, 64, {}};
  const auto channel = [](int cube) { return static_cast<std::uint8_t>(4 * cube + 2); };
  for (int cr = 63; cr >= 0; --cr)
    for (int cb = 0; cb < 64; ++cb)
      append(picture, colorAt(Pixel{channel(y), channel(cb), channel(cr), 0}));
  return picture;
}

void legend(Sheet& sheet, const ColorTable64& table, double top) {
  std::array<int, enumCount<ColorClass>> counts{};
  for (const ColorClass c : table.classes) ++counts[static_cast<std::size_t>(c)];
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Vector2d at{10.0 + 182.0 * static_cast<double>(i % 6),
                      top + 20.0 * static_cast<double>(i / 6)};
    sheet.box(at, {14, 14}, colors::gray);
    sheet.box(at + Vector2d{1, 1}, {12, 12}, displayColor(static_cast<ColorClass>(i)));
    sheet.text(at + Vector2d{20, 11},
               std::string{enumNames<ColorClass>[i]} + " " + std::to_string(counts[i]));
  }
}

}  // namespace

RgbImage classesOf(const Image& image, const ColorTable64& table) {
  RgbImage classes{image.info.width, image.info.height, {}};
  for (const Pixel& pixel : image.pixels) append(classes, displayColor(table[pixel]));
  classes.pixels.resize(3u * image.area());
  return classes;
}

Sheet tableSheet(const ColorTable64& table) {
  constexpr int slices = 16, perRow = 8;
  constexpr double size = 128, gap = 8, rowHeight = 2 * size + 30;
  Sheet sheet{static_cast<int>(gap + perRow * (size + gap)),
              static_cast<int>(slices / perRow * rowHeight + 56)};
  for (int i = 0; i < slices; ++i) {
    const int y = 4 * i + 2;
    const Vector2d at{gap + (i % perRow) * (size + gap), 22 + (i / perRow) * rowHeight};
    sheet.text(at - Vector2d{0, 5}, "Y = " + std::to_string(4 * y));
    sheet.paint(slice(y, colorOf), at, size / 64);
    sheet.paint(slice(y, [&](const Pixel& pixel) { return displayColor(table[pixel]); }),
                at + Vector2d{0, size}, size / 64);
  }
  legend(sheet, table, slices / perRow * rowHeight + 12);
  return sheet;
}

}  // namespace gt
