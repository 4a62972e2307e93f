#include "views/painting/CairoPainter.h"

#include <cairo.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <string>

namespace gt {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

constexpr double fullCircle = 2 * std::numbers::pi;

Surface surfaceOf(const RgbImage& picture) {
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

class CairoPainter : public SheetPainter {
 public:
  explicit CairoPainter(cairo_surface_t* surface) : surface_{surface} {}

  void line(std::span<const Vector2d> points, bool closed, const Pen& pen) override {
    const Context context = contextOf(pen);
    addPath(context.get(), points, closed);
    cairo_stroke(context.get());
  }
  void area(std::span<const Vector2d> corners, Color color) override {
    const Context context = contextOf({color});
    addPath(context.get(), corners, true);
    cairo_fill(context.get());
  }
  void circle(const Vector2d& center, double radius, const Pen& pen) override {
    const Context context = contextOf(pen);
    cairo_arc(context.get(), center.x(), center.y(), radius, 0, fullCircle);
    cairo_stroke(context.get());
  }
  void disk(const Vector2d& center, double radius, Color color) override {
    const Context context = contextOf({color});
    cairo_arc(context.get(), center.x(), center.y(), radius, 0, fullCircle);
    cairo_fill(context.get());
  }
  void sector(const Vector2d& center, double radius, double from, double to, Color color) override {
    const Context context = contextOf({color});
    cairo_move_to(context.get(), center.x(), center.y());
    cairo_arc(context.get(), center.x(), center.y(), radius, from, to);
    cairo_close_path(context.get());
    cairo_fill(context.get());
  }
  void text(const Vector2d& at, std::string_view text, const Font& font) override {
    const std::string line{text};
    const Color& c = font.color;
    const Context context = contextOf({c});
    // Cairo's own font: no fonts have to be installed, and text looks the same everywhere. It knows
    // ASCII only.
    const bool ascii = std::ranges::all_of(line, [](char letter) { return letter >= 0; });
    cairo_select_font_face(context.get(), ascii ? "@cairo:sans" : "Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context.get(), font.height);
    cairo_move_to(context.get(), at.x(), at.y());
    cairo_text_path(context.get(), line.c_str());
    if (font.seam) {
      const double seam = c.r + c.g + c.b > 380 ? 0 : 1;
      cairo_set_source_rgba(context.get(), seam, seam, seam, 0.7 * c.a / 255);
      cairo_set_line_width(context.get(), std::max(2.0, font.height / 6));
      cairo_stroke_preserve(context.get());
      setColor(context.get(), c);
    }
    cairo_fill(context.get());
  }
  void picture(const RgbImage& picture, const Vector2d& at, double scale) override {
    const Surface image = surfaceOf(picture);
    const Context context = contextOf({});
    cairo_translate(context.get(), at.x(), at.y());
    cairo_scale(context.get(), scale, scale);
    cairo_set_source_surface(context.get(), image.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context.get()), CAIRO_FILTER_NEAREST);
    cairo_paint(context.get());
  }

 private:
  static void setColor(cairo_t* context, const Color& c) {
    cairo_set_source_rgba(context, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
  }
  static void addPath(cairo_t* context, std::span<const Vector2d> points, bool closed) {
    for (const Vector2d& p : points) cairo_line_to(context, p.x(), p.y());
    if (closed) cairo_close_path(context);
  }
  /// A context of its own: an error of Cairo in one stroke does not affect others.
  Context contextOf(const Pen& pen) const {
    Context context{cairo_create(surface_), cairo_destroy};
    setColor(context.get(), pen.color);
    cairo_set_line_width(context.get(), pen.width);
    // The round ends take a width of each gap.
    const double dashes[] = {pen.style == PenStyle::dash ? 4 * pen.width : 0, 3 * pen.width};
    if (pen.style != PenStyle::solid) cairo_set_dash(context.get(), dashes, 2, 0);
    cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
    return context;
  }

  cairo_surface_t* surface_;
};

}  // namespace

RgbImage paintByCairo(const Sheet& sheet) {
  const int width = sheet.width(), height = sheet.height();
  const Surface image{cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
                      cairo_surface_destroy};
  CairoPainter painter{image.get()};
  sheet.paintOn(painter);
  cairo_surface_flush(image.get());
  const int stride = cairo_image_surface_get_stride(image.get()) / 4;
  const auto* from =
      reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(image.get()));
  RgbImage result{width, height, {}};
  result.pixels.reserve(3u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int shift : {16, 8, 0})
        result.pixels.push_back(static_cast<std::uint8_t>(from[y * stride + x] >> shift));
  return result;
}

}  // namespace gt
