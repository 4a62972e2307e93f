#include "debug/Debug.h"

namespace gt {

Canvas::Canvas(Debug& debug, const DebugKey& key, DrawingSpace space)
    : debug_{&debug}, drawing_{std::string{key.name()}, space, {}} {}

Canvas::~Canvas() {
  if (debug_) debug_->out().write(debug_->now(), drawing_);
}

DrawingElement& Canvas::add(ElementType type, std::vector<Vector2d> points, Color color,
                            double penWidth) {
  DrawingElement& element = drawing_.elements.emplace_back();
  element.type = type;
  element.points = std::move(points);
  element.color = color;
  element.penWidth = penWidth;
  return element;
}

void Canvas::point(const Vector2d& at, Color color, double radius) {
  add(ElementType::point, {at}, color, 1).size = radius;
}

void Canvas::line(const Vector2d& from, const Vector2d& to, Color color, double penWidth) {
  add(ElementType::line, {from, to}, color, penWidth);
}

void Canvas::arrow(const Vector2d& from, const Vector2d& to, Color color, double penWidth) {
  add(ElementType::arrow, {from, to}, color, penWidth);
}

void Canvas::circle(const Vector2d& center, double radius, Color color, double penWidth) {
  add(ElementType::circle, {center}, color, penWidth).size = radius;
}

void Canvas::disk(const Vector2d& center, double radius, Color color) {
  add(ElementType::disk, {center}, color, 1).size = radius;
}

void Canvas::polygon(std::vector<Vector2d> corners, Color color, double penWidth) {
  add(ElementType::polygon, std::move(corners), color, penWidth);
}

void Canvas::text(const Vector2d& at, std::string text, Color color, double height) {
  DrawingElement& element = add(ElementType::text, {at}, color, 1);
  element.size = height;
  element.text = std::move(text);
}

void Canvas::pose(const Pose2D& pose, Color color, double length) {
  arrow(pose.translation, pose * Vector2d{length, 0}, color);
}

}  // namespace gt
