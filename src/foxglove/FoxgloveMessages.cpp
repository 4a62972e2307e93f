#include "foxglove/FoxgloveMessages.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "representations/perception/LandmarksPercept.h"

namespace gt::foxglove {
namespace {

constexpr double metersPerMm = 0.001;
constexpr int circleCorners = 32, pointCorners = 8;
/// Areas of more corners are taken as convex, since cutting them up would take too long.
constexpr std::size_t mostCorners = 200;
constexpr double liftOfDrawings = 5;  ///< mm above the ground, so that both can be seen.
constexpr double arrowHead = 0.25;    ///< Of an arrow's length.

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The schema that a type's fields yield, by the names that viewers know.
template <typename T>
Schema publicSchema(const std::string& name) {
  Schema schema = detail::schemaOf(typeOf<T>());
  schema.name = "foxglove_msgs/msg/" + name;
  replaceAll(schema.text, "gt2003_msgs/RosTime", "builtin_interfaces/Time");
  replaceAll(schema.text, "gt2003_msgs/Duration", "builtin_interfaces/Duration");
  replaceAll(schema.text, "gt2003_msgs/", "foxglove_msgs/");
  return schema;
}

Point3 pointOf(const Vector3d& mm) {
  const Vector3d m = metersPerMm * mm;
  return {m.x(), m.y(), m.z()};
}

Point3 onGround(const Vector2d& mm, double height = liftOfDrawings) {
  return pointOf({mm.x(), mm.y(), height});
}

SpatialPose poseAt(const Vector3d& mm) {
  return {pointOf(mm), {}};
}

/// Points of an ellipse around a middle, between two angles in the axes' frame.
std::vector<Vector2d> arc(const Vector2d& middle, const Vector2d& first, const Vector2d& second,
                          double from = 0, double to = 2 * pi, int corners = circleCorners) {
  std::vector<Vector2d> points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = from + (to - from) * i / corners;
    points.emplace_back(middle + std::cos(angle) * first + std::sin(angle) * second);
  }
  return points;
}

std::vector<Vector2d> circle(const Vector2d& middle, double radius, int corners = circleCorners) {
  return arc(middle, {radius, 0}, {0, radius}, 0, 2 * pi, corners);
}

/// How many points an element of a type needs at least.
std::size_t leastPoints(ElementType type) {
  switch (type) {
    case ElementType::line:
    case ElementType::arrow:
      return 2;
    case ElementType::ellipse:
    case ElementType::sector:
      return 3;
    default:
      return 1;
  }
}

std::vector<Vector2d> sector(const DrawingElement& element) {
  const Vector2d& middle = element.points[0];
  const Vector2d begin = element.points[1] - middle, end = element.points[2] - middle;
  const double from = std::atan2(begin.y(), begin.x());
  double to = std::atan2(end.y(), end.x());
  if (to <= from) to += 2 * pi;
  const double radius = begin.norm();
  std::vector<Vector2d> points = arc(middle, {radius, 0}, {0, radius}, from, to);
  points.push_back(middle);
  return points;
}

/// The lines of which an element consists; empty if it is a text.
std::vector<std::vector<Vector2d>> strokes(const DrawingElement& element) {
  const auto& points = element.points;
  switch (element.type) {
    case ElementType::point:
      return {circle(points[0], element.size, pointCorners)};
    case ElementType::circle:
    case ElementType::disk:
      return {circle(points[0], element.size)};
    case ElementType::ellipse:
      return {arc(points[0], points[1] - points[0], points[2] - points[0])};
    case ElementType::sector:
      return {sector(element)};
    case ElementType::arrow: {
      const Vector2d back = arrowHead * (points[0] - points[1]);
      const Vector2d aside{-0.5 * back.y(), 0.5 * back.x()};
      return {{points[0], points[1]},
              {points[1] + back + aside, points[1], points[1] + back - aside}};
    }
    case ElementType::polygon: {
      auto closed = points;
      closed.push_back(points.front());
      return {closed};
    }
    case ElementType::line:
    case ElementType::path:
    case ElementType::area:
      return {points};
    case ElementType::text:
      break;
  }
  return {};
}

bool isFilled(ElementType type) {
  return type == ElementType::point || type == ElementType::disk || type == ElementType::sector ||
         type == ElementType::area;
}

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether a point that is no corner lies in a triangle or on its border.
bool inTriangle(const Vector2d& p, const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return p != a && p != b && p != c && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
         cross(a - c, p - c) >= 0;
}

/// Cuts ears off a polygon until nothing is left of it. Returns the corners of triangles.
std::vector<std::uint32_t> triangulated(const std::vector<Vector2d>& points) {
  std::vector<std::uint32_t> left(points.size());
  std::iota(left.begin(), left.end(), 0u);
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    area += cross(points[i], points[(i + 1) % points.size()]);
  if (area < 0) std::ranges::reverse(left);
  std::vector<std::uint32_t> triangles;
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    std::size_t ear = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d &a = points[left[(i + n - 1) % n]], &b = points[left[i]],
                     &c = points[left[(i + 1) % n]];
      const bool free = std::ranges::none_of(
          left, [&](std::uint32_t corner) { return inTriangle(points[corner], a, b, c); });
      if (cross(b - a, c - b) < 0 || !free) continue;
      ear = i;
      break;
    }
    triangles.insert(triangles.end(), {left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

/// Triangles around the last corner: right for whatever is convex, and for sectors.
std::vector<std::uint32_t> fan(std::size_t corners) {
  std::vector<std::uint32_t> triangles;
  const auto last = static_cast<std::uint32_t>(corners - 1);
  for (std::uint32_t i = 0; i + 1 < last; ++i) triangles.insert(triangles.end(), {last, i, i + 1});
  return triangles;
}

void fill(Triangles& triangles, const std::vector<Vector2d>& corners, const Rgba& color,
          double height, bool convex = true) {
  const auto first = static_cast<std::uint32_t>(triangles.points.size());
  for (const std::uint32_t corner : convex ? fan(corners.size()) : triangulated(corners))
    triangles.indices.push_back(first + corner);
  for (const Vector2d& corner : corners) {
    triangles.points.push_back(onGround(corner, height));
    triangles.colors.push_back(color);
  }
}

void fill(Triangles& triangles, double left, double right, double low, double high,
          const Color& color, double height) {
  fill(triangles, {{left, low}, {right, low}, {right, high}, {left, high}}, Rgba::of(color),
       height);
}

Solid box(const Vector3d& middle, const Vector3d& size, const Color& color) {
  return {poseAt(middle), pointOf(size), Rgba::of(color)};
}

void addFlags(SceneEntity& entity, const FieldDimensions& f) {
  struct Colors {
    FlagType type;
    Color upper, lower;
  };
  const Colors flags[] = {{FlagType::pinkAboveYellow, colors::pink, colors::yellow},
                          {FlagType::pinkAboveGreen, colors::pink, colors::green},
                          {FlagType::pinkAboveSkyblue, colors::pink, colors::skyblue},
                          {FlagType::yellowAbovePink, colors::yellow, colors::pink},
                          {FlagType::greenAbovePink, colors::green, colors::pink},
                          {FlagType::skyblueAbovePink, colors::skyblue, colors::pink}};
  const double height = (f.flagTop - f.flagBottom) / 2;
  const Point3 size = pointOf({2 * f.flagRadius, 2 * f.flagRadius, height});
  for (const auto& [type, upper, lower] : flags) {
    const Vector2d at = positionOf(type, TeamColor::red, f);
    const auto add = [&](double middle, const Color& color) {
      entity.cylinders.push_back({poseAt({at.x(), at.y(), middle}), size, 1, 1, Rgba::of(color)});
    };
    add(f.flagBottom + height / 2, lower);
    add(f.flagBottom + 1.5 * height, upper);
  }
}

SceneEntity emptyEntity(Time time, std::string frame, std::string id) {
  SceneEntity entity;
  entity.timestamp = RosTime::of(time);
  entity.frameId = std::move(frame);
  entity.id = std::move(id);
  return entity;
}

}  // namespace

Rgba Rgba::of(const Color& color) {
  constexpr double most = 255;
  return {color.r / most, color.g / most, color.b / most, color.a / most};
}

SpatialPose SpatialPose::of(const Pose3D& pose) {
  const Eigen::Quaterniond rotation{pose.rotation};
  return {pointOf(pose.translation), {rotation.x(), rotation.y(), rotation.z(), rotation.w()}};
}

Schema SceneUpdate::schema() {
  return publicSchema<SceneUpdate>("SceneUpdate");
}
Schema ImageAnnotations::schema() {
  return publicSchema<ImageAnnotations>("ImageAnnotations");
}
Schema FrameTransforms::schema() {
  return publicSchema<FrameTransforms>("FrameTransforms");
}
Schema Log::schema() {
  return publicSchema<Log>("Log");
}

FrameTransform transformOf(Time time, std::string parent, std::string child, const Pose3D& pose) {
  const SpatialPose spatial = SpatialPose::of(pose);
  return {RosTime::of(time), std::move(parent), std::move(child), spatial.position,
          spatial.orientation};
}

SceneEntity sceneEntity(const Drawing& drawing, Time time, std::string frame) {
  SceneEntity entity = emptyEntity(time, std::move(frame), drawing.key);
  entity.frameLocked = true;
  Triangles areas;
  std::map<double, Lines> lines;  // by their widths
  for (const DrawingElement& element : drawing.elements) {
    if (element.points.size() < leastPoints(element.type)) continue;
    const Rgba color = Rgba::of(element.color);
    if (element.type == ElementType::text) {
      SpatialText text{.color = color, .text = element.text};
      text.pose.position = onGround(element.points[0]);
      text.fontSize = metersPerMm * element.size;
      entity.texts.push_back(std::move(text));
      continue;
    }
    for (const auto& stroke : strokes(element)) {
      if (isFilled(element.type)) {
        fill(areas, stroke, color, liftOfDrawings,
             element.type != ElementType::area || stroke.size() > mostCorners);
        continue;
      }
      Lines& to = lines[element.penWidth];
      for (std::size_t i = 1; i < stroke.size(); ++i) {
        to.points.insert(to.points.end(), {onGround(stroke[i - 1]), onGround(stroke[i])});
        to.colors.insert(to.colors.end(), {color, color});
      }
    }
  }
  if (!areas.points.empty()) entity.triangles.push_back(std::move(areas));
  for (auto& [width, some] : lines) {
    some.thickness = width;
    entity.lines.push_back(std::move(some));
  }
  return entity;
}

ImageAnnotations imageAnnotations(const Drawing& drawing, Time time) {
  ImageAnnotations annotations;
  const RosTime now = RosTime::of(time);
  for (const DrawingElement& element : drawing.elements) {
    if (element.points.size() < leastPoints(element.type)) continue;
    const Rgba color = Rgba::of(element.color);
    Rgba fillColor = color;
    if (!isFilled(element.type)) fillColor.a = 0;
    const Vector2d& at = element.points[0];
    if (element.type == ElementType::text) {
      annotations.texts.push_back({now, {at.x(), at.y()}, element.text, element.size, color});
    } else if (element.type == ElementType::point || element.type == ElementType::disk ||
               element.type == ElementType::circle) {
      annotations.circles.push_back(
          {now, {at.x(), at.y()}, 2 * element.size, element.penWidth, fillColor, color});
    } else {
      for (const auto& stroke : strokes(element)) {
        PointsAnnotation points{.timestamp = now,
                                .outlineColor = color,
                                .fillColor = fillColor,
                                .thickness = element.penWidth};
        if (isFilled(element.type)) points.type = PointsAnnotation::loop;
        for (const Vector2d& point : stroke) points.points.push_back({point.x(), point.y()});
        annotations.points.push_back(std::move(points));
      }
    }
  }
  return annotations;
}

SceneEntity fieldEntity(const FieldDimensions& f, Time time, std::string frame) {
  constexpr Color grass{30, 110, 50}, line{235, 235, 235};
  constexpr double linesAt = 2, thin = 10;  // mm
  SceneEntity entity = emptyEntity(time, std::move(frame), "field");
  Triangles ground;
  const double x = f.xGroundline, y = f.ySideline, w = f.lineWidth / 2;
  fill(ground, -f.xGoalBack, f.xGoalBack, -y, y, grass, 0);
  fill(ground, -w, w, -y, y, line, linesAt);
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * f.xPenaltyArea;
    fill(ground, inner - w, inner + w, -f.yPenaltyArea, f.yPenaltyArea, line, linesAt);
    fill(ground, side * x - w, side * x + w, -y, y, line, linesAt);
    for (const double wing : {-1.0, 1.0})
      fill(ground, std::min(inner, side * x), std::max(inner, side * x), wing * f.yPenaltyArea - w,
           wing * f.yPenaltyArea + w, line, linesAt);
    const Color color = side < 0 ? colors::yellow : colors::skyblue;
    const double depth = f.xGoalBack - x, z = f.goalHeight / 2;
    entity.cubes.push_back(
        box({side * f.xGoalBack, 0, z}, {thin, 2 * f.yGoal, f.goalHeight}, color));
    for (const double wing : {-1.0, 1.0})
      entity.cubes.push_back(
          box({side * (x + depth / 2), wing * f.yGoal, z}, {depth, thin, f.goalHeight}, color));
    entity.cubes.push_back(box({0, side * (y + thin / 2), f.wallHeight / 2},
                               {2 * f.xSideCorner, thin, f.wallHeight}, colors::white));
  }
  entity.triangles.push_back(std::move(ground));
  const auto round = circle({0, 0}, f.centerCircleRadius);
  Lines center;
  center.type = Lines::strip;
  center.thickness = metersPerMm * f.lineWidth;
  center.scaleInvariant = false;
  center.color = Rgba::of(line);
  for (const Vector2d& point : round) center.points.push_back(onGround(point, linesAt));
  entity.lines.push_back(std::move(center));
  addFlags(entity, f);
  return entity;
}

SceneEntity robotEntity(const TrueBody& robot, Time time, std::string frame) {
  const Vector3d trunk{210, 110, 90}, head{100, 80, 80};                // mm
  const Vector3d headAt{150, 0, 50};                                    // from the body's origin
  constexpr double legs = 120, footWidth = 30, aside = 50, ahead = 75;  // mm
  constexpr double nameAbove = 200, letters = 80;                       // mm
  const Color color = robot.team == TeamColor::red ? colors::red : colors::blue;
  SceneEntity entity = emptyEntity(time, std::move(frame), robot.name);
  const auto add = [&](const Vector3d& at, const Vector3d& size, const Color& of) {
    Pose3D pose = robot.pose;
    pose.translate(at);
    entity.cubes.push_back({SpatialPose::of(pose), pointOf(size), Rgba::of(of)});
  };
  add({0, 0, 0}, trunk, color);
  add(headAt, head, colors::gray);
  for (const double x : {-ahead, ahead})
    for (const double y : {-aside, aside})
      add({x, y, -legs / 2}, {footWidth, footWidth, legs}, colors::gray);
  SpatialText name{.fontSize = metersPerMm * letters, .color = Rgba::of(color), .text = robot.name};
  name.pose.position = pointOf(robot.pose.translation + Vector3d{0, 0, nameAbove});
  entity.texts.push_back(std::move(name));
  return entity;
}

SceneEntity ballEntity(const TrueBody& ball, double radius, Time time, std::string frame) {
  SceneEntity entity = emptyEntity(time, std::move(frame), ball.name);
  const double size = 2 * radius;
  entity.spheres.push_back(
      {SpatialPose::of(ball.pose), pointOf({size, size, size}), Rgba::of(colors::orange)});
  return entity;
}

}  // namespace gt::foxglove
