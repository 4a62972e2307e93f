#include "views/painting/PicturePainter.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "colors/Rgb.h"
#include "views/painting/DrawingPainter.h"

namespace gt {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// A colour as Cairo's RGB24.
std::uint32_t rgb24(const Pixel& pixel) {
  const Rgb color = rgbOf(pixel);
  const auto byte = [](double value) { return static_cast<std::uint32_t>(std::lround(value)); };
  return byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
}

}  // namespace

PicturePainter::PicturePainter(const Image& image, int scale)
    : scale_(std::clamp(scale, 1, 7)) {  // at most 4096 pixels a side, and Cairo takes 32767
  const int factor = static_cast<int>(scale_);
  const int wide = std::clamp(image.info.width, 0, 4096) * factor;
  const int high = std::clamp(image.info.height, 0, 4096) * factor;
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, wide, high));
  cairo_surface_flush(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get()) / 4;
  auto* to = reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface_.get()));
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      const std::size_t from = static_cast<std::size_t>(y / factor) * (wide / factor) + x / factor;
      if (from < image.pixels.size()) to[y * stride + x] = rgb24(image.pixels[from]);
    }
  cairo_surface_mark_dirty(surface_.get());
}

void PicturePainter::paint(const Drawing& drawing) {
  for (const DrawingElement& element : drawing.elements) {
    // A context of its own: whatever Cairo dislikes about one element spoils no other.
    const Context context{cairo_create(surface_.get()), cairo_destroy};
    gt::paint(context.get(), {{}, {}, {element}}, {Vector2d::Zero(), scale_, false});
  }
  cairo_surface_flush(surface_.get());
}

int PicturePainter::width() const {
  return cairo_image_surface_get_width(surface_.get());
}

int PicturePainter::height() const {
  return cairo_image_surface_get_height(surface_.get());
}

std::vector<std::uint8_t> PicturePainter::rgb() const {
  const int stride = cairo_image_surface_get_stride(surface_.get()) / 4;
  const auto* from =
      reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface_.get()));
  std::vector<std::uint8_t> result;
  result.reserve(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 3);
  for (int y = 0; y < height(); ++y)
    for (int x = 0; x < width(); ++x) {
      const std::uint32_t pixel = from[y * stride + x];
      for (const int shift : {16, 8, 0})
        result.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  return result;
}

void PicturePainter::Release::operator()(_cairo_surface* surface) const {
  cairo_surface_destroy(surface);
}

}  // namespace gt
