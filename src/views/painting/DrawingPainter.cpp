#include "views/painting/DrawingPainter.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// Limits a coordinate: beyond the limits nothing changes on any sheet, but Cairo's fixed point
/// numbers overflow.
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

std::vector<Vector2d> ellipse(const Vector2d& center, const Vector2d& first,
                              const Vector2d& second) {
  constexpr int corners = 64;
  std::vector<Vector2d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    points.push_back(center + std::cos(angle) * first + std::sin(angle) * second);
  }
  return points;
}

/// The two strokes at the tip of an arrow.
std::vector<Vector2d> arrowHead(const Vector2d& begin, const Vector2d& tip, double scale) {
  const Vector2d shaft = tip - begin;
  const double length = std::min(shaft.norm() * 0.4, std::max(4 * scale, 6.0));
  const auto end = [&](double side) -> Vector2d {
    return tip - direction(angleOf(shaft) + side * 0.5) * length;
  };
  return {end(-1), tip, end(1)};
}

}  // namespace

void paint(SheetPainter& painter, const DrawingElement& element, const Placement& placement) {
  if (!isDrawable(element)) return;
  std::vector<Vector2d> points;
  for (const Vector2d& point : element.points) {
    const Vector2d p = placement.of(point);
    points.emplace_back(limited(p.x()), limited(p.y()));
  }
  const double size = limited(element.size * placement.scale);
  const SheetPainter::Pen pen{element.color, std::clamp(element.penWidth, 0.5, 100.0),
                              element.penStyle};
  switch (element.type) {
    case ElementType::point:
    case ElementType::disk:
      return painter.disk(points[0], std::max(size, 1.0), element.color);
    case ElementType::circle:
      return painter.circle(points[0], std::max(size, 0.0), pen);
    case ElementType::ellipse:
      return painter.line(ellipse(points[0], points[1] - points[0], points[2] - points[0]), true,
                          pen);
    case ElementType::sector: {
      const Vector2d first = points[1] - points[0], second = points[2] - points[0];
      const double from = angleOf(placement.up ? second : first);
      const double to = angleOf(placement.up ? first : second);
      return painter.sector(points[0], first.norm(), from, to, element.color);
    }
    case ElementType::line:
    case ElementType::path:
      return painter.line(points, false, pen);
    case ElementType::polygon:
      return painter.line(points, true, pen);
    case ElementType::area:
      return painter.area(points, element.color);
    case ElementType::arrow:
      painter.line(points, false, pen);
      return painter.line(arrowHead(points[0], points.back(), placement.scale), false,
                          {pen.color, pen.width});
    case ElementType::text:
      return painter.text(points[0], element.text,
                          {element.color, std::clamp(size, 1.0, 1000.0), true, true});
  }
}

}  // namespace gt
