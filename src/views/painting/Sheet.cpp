#include "views/painting/Sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/File.h"
#include "images/Png.h"
#include "views/painting/CairoPainter.h"
#include "views/painting/SvgPainter.h"

namespace gt {
namespace {

constexpr int largest = 4096;

/// The number of bytes of the UTF-8 character that a text begins with; 0 if it is invalid.
std::size_t letterSize(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t size = first < 0x80                     ? 1
                           : first >= 0xC2 && first <= 0xDF ? 2
                           : first >= 0xE0 && first <= 0xEF ? 3
                           : first >= 0xF0 && first <= 0xF4 ? 4
                                                            : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Longer than need be, surrogates, beyond Unicode.
  if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F))
    return 0;
  return size;
}

/// Replaces invalid UTF-8 and control characters of a line of text by question marks.
std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t size = letterSize(text);
    const bool control = static_cast<unsigned char>(text[0]) < ' ' || text[0] == 0x7F;
    if (size == 0 || control)
      line += '?';
    else
      line += text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return line;
}

/// The contributions of cb and cr to red, green and blue (colors/Rgb.h), in fixed point.
struct RgbTerms {
  static constexpr int bits = 16, half = 1 << (bits - 1);
  std::array<int, 256> red, greenByCb, greenByCr, blue;

  RgbTerms() {
    for (int i = 0; i < 256; ++i) {
      const auto term = [&](double factor) {
        return static_cast<int>(std::lround(factor * (i - 128) * (1 << bits)));
      };
      const auto at = static_cast<std::size_t>(i);
      red[at] = term(1.402);
      greenByCb[at] = term(-0.344136);
      greenByCr[at] = term(-0.714136);
      blue[at] = term(1.772);
    }
  }
  static std::uint8_t byte(int value) {
    return static_cast<std::uint8_t>(std::clamp((value + half) >> bits, 0, 255));
  }
};

}  // namespace

RgbImage rgbOf(const Image& image) {
  RgbImage picture{
      std::clamp(image.info.width, 0, largest), std::clamp(image.info.height, 0, largest), {}};
  const auto count =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.pixels.resize(3 * count);
  // Viewers do this for each image: the terms of rgbOf(Pixel) from tables, so that it is quick.
  static const RgbTerms terms;
  std::uint8_t* to = picture.pixels.data();
  for (std::size_t i = 0; i < std::min(count, image.pixels.size()); ++i, to += 3) {
    const Pixel& p = image.pixels[i];
    const int y = p.y << RgbTerms::bits;
    to[0] = RgbTerms::byte(y + terms.red[p.cr]);
    to[1] = RgbTerms::byte(y + terms.greenByCb[p.cb] + terms.greenByCr[p.cr]);
    to[2] = RgbTerms::byte(y + terms.blue[p.cb]);
  }
  return picture;
}

Sheet::Sheet(int width, int height, Color background)
    : width_{std::clamp(width, 1, largest)}, height_{std::clamp(height, 1, largest)} {
  box({0, 0}, {width_, height_}, background);
}

void Sheet::paint(const Drawing& drawing, const Placement& placement) {
  for (DrawingElement element : drawing.elements) {
    element.text = printable(element.text);
    strokes_.emplace_back([element = std::move(element), placement](SheetPainter& painter) {
      gt::paint(painter, element, placement);
    });
  }
}

void Sheet::paint(RgbImage picture, const Vector2d& at, double scale) {
  if (picture.width <= 0 || picture.height <= 0) return;
  strokes_.emplace_back([picture = std::move(picture), at, scale](SheetPainter& painter) {
    painter.picture(picture, at, scale);
  });
}

void Sheet::text(const Vector2d& at, const std::string& text, Color color, double height) {
  strokes_.emplace_back([at, text = printable(text), color, height](SheetPainter& painter) {
    painter.text(at, text, {color, height});
  });
}

void Sheet::box(const Vector2d& corner, const Vector2d& size, Color color) {
  strokes_.emplace_back([corner, end = Vector2d{corner + size}, color](SheetPainter& painter) {
    painter.area(std::vector<Vector2d>{corner, {end.x(), corner.y()}, end, {corner.x(), end.y()}},
                 color);
  });
}

void Sheet::line(const Vector2d& from, const Vector2d& to, Color color, double penWidth) {
  strokes_.emplace_back([from, to, color, penWidth](SheetPainter& painter) {
    painter.line(std::vector<Vector2d>{from, to}, false, {color, penWidth});
  });
}

void Sheet::paintOn(SheetPainter& painter) const {
  for (const auto& stroke : strokes_) stroke(painter);
}

RgbImage Sheet::pixels() const {
  return paintByCairo(*this);
}

std::string Sheet::svg() const {
  SvgPainter painter{width_, height_};
  paintOn(painter);
  return painter.svg();
}

Result<void> Sheet::write(const std::string& file) const {
  const std::filesystem::path path{file};
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(path.parent_path(), ignored);
  if (path.extension() == ".png") return writePng(file, width_, height_, pixels().pixels);
  if (path.extension() == ".svg") return writeFile(file, svg());
  return Error{.file = file, .what = "an image's file ends in .png or .svg"};
}

Sheet pictureSheet(RgbImage picture, int scale) {
  Sheet sheet{picture.width * scale, picture.height * scale, colors::black};
  sheet.paint(std::move(picture), {0, 0}, scale);
  return sheet;
}

}  // namespace gt
