#include "workbench/QtPainter.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gt {
namespace {

QPointF pointOf(const Vector2d& point) {
  return {point.x(), point.y()};
}

QPolygonF polygonOf(std::span<const Vector2d> points) {
  QPolygonF polygon;
  polygon.reserve(static_cast<qsizetype>(points.size()));
  for (const Vector2d& point : points) polygon << pointOf(point);
  return polygon;
}

QPen penOf(const SheetPainter::Pen& pen) {
  const Qt::PenStyle style = pen.style == PenStyle::dash  ? Qt::DashLine
                             : pen.style == PenStyle::dot ? Qt::DotLine
                                                          : Qt::SolidLine;
  return {qColor(pen.color), pen.width, style, Qt::RoundCap, Qt::RoundJoin};
}

}  // namespace

void QtPainter::line(std::span<const Vector2d> points, bool closed, const Pen& pen) {
  painter_.setPen(penOf(pen));
  painter_.setBrush(Qt::NoBrush);
  if (closed)
    painter_.drawPolygon(polygonOf(points));
  else
    painter_.drawPolyline(polygonOf(points));
}

void QtPainter::area(std::span<const Vector2d> corners, Color color) {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(qColor(color));
  painter_.drawPolygon(polygonOf(corners));
}

void QtPainter::circle(const Vector2d& center, double radius, const Pen& pen) {
  painter_.setPen(penOf(pen));
  painter_.setBrush(Qt::NoBrush);
  painter_.drawEllipse(pointOf(center), radius, radius);
}

void QtPainter::disk(const Vector2d& center, double radius, Color color) {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(qColor(color));
  painter_.drawEllipse(pointOf(center), radius, radius);
}

void QtPainter::sector(const Vector2d& center, double radius, double from, double to, Color color) {
  // Qt counts counterclockwise, in degrees.
  constexpr double degrees = 180 / std::numbers::pi;
  double span = to - from;
  if (span < 0) span += 2 * std::numbers::pi;
  const QRectF box{center.x() - radius, center.y() - radius, 2 * radius, 2 * radius};
  QPainterPath path{pointOf(center)};
  path.arcTo(box, -from * degrees, -span * degrees);
  path.closeSubpath();
  painter_.fillPath(path, qColor(color));
}

void QtPainter::text(const Vector2d& at, std::string_view text, const Font& font) {
  if (!(font.height > 0)) return;
  QFont face{QStringLiteral("DejaVu Sans")};
  face.setStyleHint(QFont::SansSerif);
  // Fonts have whole pixels: the painter does the rest.
  constexpr int pixels = 16;
  const double scale = font.height / pixels;
  face.setPixelSize(pixels);
  face.setBold(font.bold);
  const QString line = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  painter_.save();
  painter_.translate(pointOf(at));
  painter_.scale(scale, scale);
  if (font.seam) {
    const Color& c = font.color;
    const int seam = c.r + c.g + c.b > 380 ? 0 : 255;
    QPainterPath path;
    path.addText(0, 0, face, line);
    painter_.strokePath(path, QPen{QColor{seam, seam, seam, 178}, std::max(2.0, pixels / 6.0)});
    painter_.fillPath(path, qColor(c));
  } else {
    painter_.setFont(face);
    painter_.setPen(qColor(font.color));
    painter_.drawText(QPointF{0, 0}, line);
  }
  painter_.restore();
}

void QtPainter::picture(const RgbImage& picture, const Vector2d& at, double scale) {
  // Qt enlarges this format quickest.
  painter_.drawImage(QRectF{at.x(), at.y(), picture.width * scale, picture.height * scale},
                     wrapped(picture).convertToFormat(QImage::Format_RGB32));
}

}  // namespace gt
