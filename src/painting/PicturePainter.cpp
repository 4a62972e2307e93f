#include "painting/PicturePainter.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// Full-range YCbCr (JFIF) as Cairo's RGB24.
std::uint32_t rgbOf(const Pixel& pixel) {
  const double cb = pixel.cb - 128.0, cr = pixel.cr - 128.0;
  const auto byte = [](double value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  return byte(pixel.y + 1.402 * cr) << 16 | byte(pixel.y - 0.344136 * cb - 0.714136 * cr) << 8 |
         byte(pixel.y + 1.772 * cb);
}

/// Coordinates beyond these mean the same on every picture, but not to Cairo's fixed point numbers.
double limited(double value) {
  return std::clamp(value, -1e5, 1e5);
}

std::size_t pointsOf(ElementType type) {
  switch (type) {
    case ElementType::ellipse:
    case ElementType::sector:
    case ElementType::area:
      return 3;
    case ElementType::line:
    case ElementType::arrow:
    case ElementType::path:
    case ElementType::polygon:
      return 2;
    default:
      return 1;
  }
}

bool isDrawable(const DrawingElement& element) {
  return element.points.size() >= pointsOf(element.type) && std::isfinite(element.size) &&
         std::isfinite(element.penWidth) &&
         std::all_of(element.points.begin(), element.points.end(),
                     [](const Vector2d& p) { return p.allFinite(); });
}

/// Text that Cairo accepts: what is not ASCII becomes a question mark.
std::string printable(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

/// Paints one element on an enlarged picture.
class ElementPainter {
 public:
  ElementPainter(cairo_t* context, double scale, const DrawingElement& element)
      : context_(context), scale_(scale), element_(element), size_(limited(element.size * scale)) {
    const Color& c = element.color;
    cairo_set_source_rgba(context, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
    cairo_set_line_width(context, std::clamp(element.penWidth, 0.5, 100.0));
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  }

  void paint() {
    switch (element_.type) {
      case ElementType::point:
      case ElementType::disk:
        disk();
        return;
      case ElementType::circle:
        circle();
        return;
      case ElementType::ellipse:
        ellipse();
        return;
      case ElementType::sector:
        sector();
        return;
      case ElementType::line:
      case ElementType::path:
      case ElementType::polygon:
        lines();
        return;
      case ElementType::area:
        area();
        return;
      case ElementType::arrow:
        lines();
        arrowHead();
        return;
      case ElementType::text:
        text();
        return;
    }
  }

 private:
  Vector2d at(std::size_t i) const {
    return {limited(element_.points[i].x() * scale_), limited(element_.points[i].y() * scale_)};
  }
  void arc(double radius) {
    cairo_arc(context_, at(0).x(), at(0).y(), std::max(radius, 0.0), 0, 2 * pi);
  }
  void disk() {
    arc(std::max(size_, 1.0));
    cairo_fill(context_);
  }
  void circle() {
    arc(size_);
    cairo_stroke(context_);
  }
  void ellipse() {
    const Vector2d first = at(1) - at(0), second = at(2) - at(0);
    constexpr int corners = 64;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * pi * i / corners;
      const Vector2d p = at(0) + std::cos(angle) * first + std::sin(angle) * second;
      cairo_line_to(context_, p.x(), p.y());
    }
    cairo_close_path(context_);
    cairo_stroke(context_);
  }
  void sector() {
    const Vector2d first = at(1) - at(0), second = at(2) - at(0);
    cairo_move_to(context_, at(0).x(), at(0).y());
    cairo_arc(context_, at(0).x(), at(0).y(), first.norm(), angleOf(first), angleOf(second));
    cairo_close_path(context_);
    cairo_fill(context_);
  }
  void area() {
    for (std::size_t i = 0; i < element_.points.size(); ++i)
      cairo_line_to(context_, at(i).x(), at(i).y());
    cairo_close_path(context_);
    cairo_fill(context_);
  }
  void lines() {
    for (std::size_t i = 0; i < element_.points.size(); ++i)
      cairo_line_to(context_, at(i).x(), at(i).y());
    if (element_.type == ElementType::polygon) cairo_close_path(context_);
    cairo_stroke(context_);
  }
  void arrowHead() {
    const Vector2d tip = at(element_.points.size() - 1), shaft = tip - at(0);
    const double length = std::min(shaft.norm() * 0.4, 4 * scale_);
    for (const double side : {-1.0, 1.0}) {
      const Vector2d end = tip - direction(angleOf(shaft) + side * 0.5) * length;
      cairo_move_to(context_, tip.x(), tip.y());
      cairo_line_to(context_, end.x(), end.y());
    }
    cairo_stroke(context_);
  }
  /// With a dark or bright seam, so that it can be read on any picture.
  void text() {
    const Color& c = element_.color;
    const double seam = c.r + c.g + c.b > 380 ? 0 : 1;
    // Cairo's own font: no fonts have to be installed, and text looks the same everywhere.
    cairo_select_font_face(context_, "@cairo:sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_font_size(context_, std::clamp(size_, 1.0, 1000.0));
    cairo_move_to(context_, at(0).x(), at(0).y());
    cairo_text_path(context_, printable(element_.text).c_str());
    cairo_set_source_rgba(context_, seam, seam, seam, 0.7 * c.a / 255);
    cairo_set_line_width(context_, std::max(2.0, size_ / 6));
    cairo_stroke_preserve(context_);
    cairo_set_source_rgba(context_, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
    cairo_fill(context_);
  }

  cairo_t* context_;
  double scale_;
  const DrawingElement& element_;
  double size_;
};

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
      if (from < image.pixels.size()) to[y * stride + x] = rgbOf(image.pixels[from]);
    }
  cairo_surface_mark_dirty(surface_.get());
}

void PicturePainter::paint(const Drawing& drawing) {
  for (const DrawingElement& element : drawing.elements) {
    if (!isDrawable(element)) continue;
    // A context of its own: whatever Cairo dislikes about one element spoils no other.
    const Context context{cairo_create(surface_.get()), cairo_destroy};
    ElementPainter{context.get(), scale_, element}.paint();
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
