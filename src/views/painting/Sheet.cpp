#include "views/painting/Sheet.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "colors/Rgb.h"
#include "streams/File.h"
#include "streams/Png.h"

namespace gt {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

constexpr int largest = 4096;

Context contextOf(cairo_surface_t* surface) {
  return {cairo_create(surface), cairo_destroy};
}

/// A line of a text that Cairo's own font can show.
std::string printable(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

Surface surfaceOf(const RgbPicture& picture) {
  Surface image{cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height),
                cairo_surface_destroy};
  cairo_surface_flush(image.get());
  const int stride = cairo_image_surface_get_stride(image.get()) / 4;
  auto* to = reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(image.get()));
  const std::uint8_t* from = picture.pixels.data();
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x, from += 3)
      to[y * stride + x] = static_cast<std::uint32_t>(from[0] << 16 | from[1] << 8 | from[2]);
  cairo_surface_mark_dirty(image.get());
  return image;
}

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

RgbPicture rgbOf(const Image& image) {
  RgbPicture picture{
      std::clamp(image.info.width, 0, largest), std::clamp(image.info.height, 0, largest), {}};
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
  const auto count =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  for (std::size_t i = 0; i < count; ++i) {
    const Rgb color = rgbOf(i < image.pixels.size() ? image.pixels[i] : Pixel{});
    for (const double part : {color.red, color.green, color.blue})
      picture.pixels.push_back(byte(part));
  }
  return picture;
}

Sheet::Sheet(int width, int height, Color background)
    : width_{std::clamp(width, 1, largest)}, height_{std::clamp(height, 1, largest)} {
  box({0, 0}, {width_, height_}, background);
}

void Sheet::paint(const Drawing& drawing, const Placement& placement) {
  for (const DrawingElement& element : drawing.elements)
    strokes_.emplace_back([element, placement](cairo_surface_t* surface) {
      gt::paint(contextOf(surface).get(), {{}, {}, {element}}, placement);
    });
}

void Sheet::paint(const RgbPicture& picture, const Vector2d& at, double scale) {
  if (picture.width <= 0 || picture.height <= 0) return;
  strokes_.emplace_back([picture, at, scale](cairo_surface_t* surface) {
    const Surface image = surfaceOf(picture);
    const Context context = contextOf(surface);
    cairo_translate(context.get(), at.x(), at.y());
    cairo_scale(context.get(), scale, scale);
    cairo_set_source_surface(context.get(), image.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context.get()), CAIRO_FILTER_NEAREST);
    cairo_paint(context.get());
  });
}

void Sheet::text(const Vector2d& at, const std::string& text, Color color, double height) {
  strokes_.emplace_back([at, text = printable(text), color, height](cairo_surface_t* surface) {
    const Context context = contextOf(surface);
    // Cairo's own font: no fonts have to be installed, and text looks the same everywhere.
    cairo_select_font_face(context.get(), "@cairo:sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context.get(), height);
    cairo_set_source_rgb(context.get(), color.r / 255.0, color.g / 255.0, color.b / 255.0);
    cairo_move_to(context.get(), at.x(), at.y());
    cairo_text_path(context.get(), text.c_str());
    cairo_fill(context.get());
  });
}

void Sheet::box(const Vector2d& corner, const Vector2d& size, Color color) {
  const Vector2d end = corner + size;
  paint({"",
         DrawingSpace::image,
         {{ElementType::area,
           {corner, {end.x(), corner.y()}, end, {corner.x(), end.y()}},
           0,
           color,
           1,
           ""}}});
}

void Sheet::line(const Vector2d& from, const Vector2d& to, Color color, double penWidth) {
  paint({"", DrawingSpace::image, {{ElementType::line, {from, to}, 0, color, penWidth, ""}}});
}

RgbPicture Sheet::pixels() const {
  const Surface image{cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_),
                      cairo_surface_destroy};
  paintOn(image.get());
  cairo_surface_flush(image.get());
  const int stride = cairo_image_surface_get_stride(image.get()) / 4;
  const auto* from =
      reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(image.get()));
  RgbPicture result{width_, height_, {}};
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      for (const int shift : {16, 8, 0})
        result.pixels.push_back(static_cast<std::uint8_t>(from[y * stride + x] >> shift));
  return result;
}

Result<void> Sheet::write(const std::string& file) const {
  const std::filesystem::path path{file};
  std::error_code ignored;  // then writing tells what is wrong
  std::filesystem::create_directories(path.parent_path(), ignored);
  if (path.extension() == ".png") return writePng(file, width_, height_, pixels().pixels);
  if (path.extension() != ".svg")
    return Error{file, 0, "", "a picture's file ends in .png or .svg"};
  std::string text;
  {
    const Surface svg{cairo_svg_surface_create_for_stream(append, &text, width_, height_),
                      cairo_surface_destroy};
    paintOn(svg.get());
  }
  return writeFile(file, text);
}

void Sheet::paintOn(cairo_surface_t* surface) const {
  for (const auto& stroke : strokes_) stroke(surface);
}

}  // namespace gt
