#include "debug/Canvas.h"

#include "debug/Debug.h"

namespace gt {

Canvas::Canvas(Debug& debug, const DebugKey& key, DrawingSpace space)
    : debug_{&debug},
      drawing_{std::make_unique<Drawing>(Drawing{std::string{key.name()}, space, {}})} {}

void Canvas::send() {
  debug_->out().write(debug_->now(), *drawing_);
}

DrawingElement& Canvas::add(ElementType type, std::vector<Vector2d> points, Color color,
                            double penWidth, PenStyle style) {
  DrawingElement& element = drawing_->elements.emplace_back();
  element.type = type;
  element.points = std::move(points);
  element.color = color;
  element.penWidth = penWidth;
  element.penStyle = style;
  return element;
}

void Canvas::point(const Vector2d& at, Color color, double radius) {
  add(ElementType::point, {at}, color).size = radius;
}

void Canvas::line(const Vector2d& from, const Vector2d& to, Color color, double penWidth,
                  PenStyle style) {
  add(ElementType::line, {from, to}, color, penWidth, style);
}

void Canvas::arrow(const Vector2d& from, const Vector2d& to, Color color, double penWidth,
                   PenStyle style) {
  add(ElementType::arrow, {from, to}, color, penWidth, style);
}

void Canvas::circle(const Vector2d& center, double radius, Color color, double penWidth,
                    PenStyle style) {
  add(ElementType::circle, {center}, color, penWidth, style).size = radius;
}

void Canvas::disk(const Vector2d& center, double radius, Color color) {
  add(ElementType::disk, {center}, color).size = radius;
}

void Canvas::ellipse(const Vector2d& center, double first, double second, double angle, Color color,
                     double penWidth, PenStyle style) {
  const Vector2d axis = direction(angle);
  add(ElementType::ellipse,
      {center, center + first * axis, center + second * Vector2d{-axis.y(), axis.x()}}, color,
      penWidth, style);
}

void Canvas::sector(const Vector2d& center, double radius, double from, double to, Color color) {
  add(ElementType::sector,
      {center, center + radius * direction(from), center + radius * direction(to)}, color);
}

void Canvas::path(std::vector<Vector2d> points, Color color, double penWidth, PenStyle style) {
  add(ElementType::path, std::move(points), color, penWidth, style);
}

void Canvas::area(std::vector<Vector2d> corners, Color color) {
  add(ElementType::area, std::move(corners), color);
}

void Canvas::cross(const Vector2d& at, double size, Color color, double penWidth) {
  const Vector2d up{size, size}, down{size, -size};
  line(at - up, at + up, color, penWidth);
  line(at - down, at + down, color, penWidth);
}

void Canvas::polygon(std::vector<Vector2d> corners, Color color, double penWidth, PenStyle style) {
  add(ElementType::polygon, std::move(corners), color, penWidth, style);
}

void Canvas::text(const Vector2d& at, std::string text, Color color, double height) {
  DrawingElement& element = add(ElementType::text, {at}, color);
  element.size = height;
  element.text = std::move(text);
}

void Canvas::pose(const Pose2D& pose, Color color, double length) {
  arrow(pose.translation, pose * Vector2d{length, 0}, color);
}

}  // namespace gt
