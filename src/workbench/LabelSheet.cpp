#include "workbench/LabelSheet.h"

#include <cmath>
#include <optional>
#include <utility>

namespace gt {
namespace {

constexpr Color labelColor{0, 255, 120}, perceptColor{255, 60, 220}, drawnColor{255, 255, 255};

/// Elements of a drawing on an image.
class ImageDrawing {
 public:
  explicit ImageDrawing(Color color) : color_{color} { drawing_.space = DrawingSpace::image; }

  void circle(const Vector2d& center, double radius) {
    add(ElementType::circle, {center}, radius);
    cross(center);
  }
  void cross(const Vector2d& at) {
    constexpr double arm = 2;
    add(ElementType::line, {at - Vector2d{arm, 0}, at + Vector2d{arm, 0}});
    add(ElementType::line, {at - Vector2d{0, arm}, at + Vector2d{0, arm}});
  }
  void path(const std::vector<Vector2d>& points) {
    for (std::size_t i = 1; i < points.size(); ++i)
      add(ElementType::line, {points[i - 1], points[i]});
    for (const Vector2d& point : points) cross(point);
  }
  void box(const BoxLabel& label, const std::string& name) {
    add(ElementType::polygon,
        {label.from, {label.to.x(), label.from.y()}, label.to, {label.from.x(), label.to.y()}});
    if (!name.empty()) write({label.left(), label.top() - 1}, name);
  }
  void write(const Vector2d& at, const std::string& words) {
    constexpr double height = 5;
    drawing_.elements.push_back({ElementType::text, {at}, height, color_, 1, words});
  }
  /// A vertical line through the whole image.
  void column(double x, double height) { add(ElementType::line, {{x, 0}, {x, height}}); }
  void paintOn(Sheet& sheet) const {
    sheet.paint(drawing_, {Vector2d::Zero(), LabelSheet::zoom, false});
  }

 private:
  void add(ElementType type, std::vector<Vector2d> points, double size = 0) {
    drawing_.elements.push_back({type, std::move(points), size, color_, 1.5, {}});
  }

  Color color_;
  Drawing drawing_;
};

/// Where a direction in the robot's system appears in the image; empty if it is behind the camera.
std::optional<Vector2d> inImage(const CameraMatrix& matrix, const Vector3d& ray) {
  const Vector3d inCamera = matrix.pose.rotation.transpose() * ray;
  if (inCamera.x() <= 0) return std::nullopt;
  return matrix.info.project(inCamera);
}

}  // namespace

LabelSheet::LabelSheet(const Image& image) : taken_{image.time}, sheet_{imageSheet(image, zoom)} {}

void LabelSheet::addPercepts(const SeenInImage& seen) {
  ImageDrawing drawing{perceptColor};
  if (seen.ball.time == taken_ && seen.ball.seen)
    drawing.circle(seen.ball.centerInImage, seen.ball.radiusInImage);
  const auto addColumns = [&](const ConditionalBoundary& boundary) {
    const auto add = [&](double angle, bool onBorder) {
      const auto place =
          inImage(seen.matrix, {std::cos(angle), std::sin(angle), std::tan(boundary.bottom)});
      if (place && !onBorder) drawing.column(place->x(), seen.matrix.info.height);
    };
    add(boundary.left, boundary.leftOnBorder);
    add(boundary.right, boundary.rightOnBorder);
  };
  if (seen.landmarks.time == taken_) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen.landmarks.numberOfFlags); ++i)
      addColumns(seen.landmarks.flags[i].boundary);
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen.landmarks.numberOfGoals); ++i)
      addColumns(seen.landmarks.goals[i].boundary);
  }
  const auto addPoints = [&](const std::vector<Vector2d>& points) {
    for (const Vector2d& point : points)
      if (const auto place = inImage(
              seen.matrix, Vector3d{point.x(), point.y(), 0} - seen.matrix.pose.translation))
        drawing.cross(*place);
  };
  if (seen.lines.time == taken_) addPoints(seen.lines.points[EdgeType::line]);
  if (seen.players.time == taken_)
    for (const auto& players : seen.players.players) addPoints(players);
  drawing.paintOn(sheet_);
}

void LabelSheet::addLabels(const ImageLabels& labels, int number) {
  ImageDrawing drawing{labelColor};
  const auto ball = labels.balls.find(number);
  if (ball != labels.balls.end() && ball->second.view != BallView::none)
    drawing.circle(ball->second.center, ball->second.radius);
  const auto field = labels.fields.find(number);
  if (field != labels.fields.end()) {
    for (const auto& line : field->second.lines) drawing.path(line);
    for (const auto& post : {field->second.leftPost, field->second.rightPost})
      if (post) drawing.cross(*post);
    for (const auto& [name, box] : field->second.boxes) drawing.box(box, name.text());
  }
  drawing.paintOn(sheet_);
}

void LabelSheet::addUnfinished(const LabelTool& tool, const Vector2d& from, const Vector2d& to) {
  ImageDrawing drawing{drawnColor};
  if (tool.kind == LabelTool::Kind::ball)
    drawing.circle(from, (to - from).norm());
  else if (tool.kind == LabelTool::Kind::box)
    drawing.box({from, to}, {});
  drawing.paintOn(sheet_);
}

}  // namespace gt
