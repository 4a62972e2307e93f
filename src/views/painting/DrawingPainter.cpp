#include "views/painting/DrawingPainter.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

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

/// Paints one element.
class ElementPainter {
 public:
  ElementPainter(cairo_t* context, const Placement& placement, const DrawingElement& element)
      : context_(context),
        placement_(placement),
        element_(element),
        size_(limited(element.size * placement.scale)) {
    const Color& c = element.color;
    cairo_set_source_rgba(context, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
    const double width = std::clamp(element.penWidth, 0.5, 100.0);
    cairo_set_line_width(context, width);
    // The round ends take a width of each gap.
    const double dashes[] = {element.penStyle == PenStyle::dash ? 4 * width : 0, 3 * width};
    if (element.penStyle != PenStyle::solid) cairo_set_dash(context, dashes, 2, 0);
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
    const Vector2d p = placement_.of(element_.points[i]);
    return {limited(p.x()), limited(p.y())};
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
    const auto arcTo = placement_.up ? cairo_arc_negative : cairo_arc;
    arcTo(context_, at(0).x(), at(0).y(), first.norm(), angleOf(first), angleOf(second));
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
    cairo_set_dash(context_, nullptr, 0, 0);
    const Vector2d tip = at(element_.points.size() - 1), shaft = tip - at(0);
    const double length = std::min(shaft.norm() * 0.4, std::max(4 * placement_.scale, 6.0));
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
  Placement placement_;
  const DrawingElement& element_;
  double size_;
};

}  // namespace

void paint(cairo_t* context, const Drawing& drawing, const Placement& placement) {
  for (const DrawingElement& element : drawing.elements) {
    if (!isDrawable(element)) continue;
    cairo_save(context);
    cairo_new_path(context);
    ElementPainter{context, placement, element}.paint();
    cairo_restore(context);
  }
}

}  // namespace gt
