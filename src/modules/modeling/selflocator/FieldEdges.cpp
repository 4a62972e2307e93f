#include "modules/modeling/selflocator/FieldEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gt {

FieldEdges::FieldEdges(const FieldDimensions& f, TeamColor team)
    : circleRadius_(f.centerCircleRadius) {
  const Vector2d half{0, f.ySideline};
  const EdgeType border = f.wallHeight > 0 ? EdgeType::border : EdgeType::line;
  segments_[EdgeType::line].push_back({half, -half});
  addMirrored(EdgeType::line, {f.xPenaltyArea, f.yPenaltyArea}, {f.xPenaltyArea, -f.yPenaltyArea});
  for (const double side : {-1, 1}) {
    addMirrored(EdgeType::line, {f.xPenaltyArea, side * f.yPenaltyArea},
                {f.xGroundline, side * f.yPenaltyArea});
    addMirrored(border, {f.xGroundline, side * f.yGoal}, {f.xGroundline, side * f.ySideCorner});
    addMirrored(border, {f.xGroundline, side * f.ySideCorner}, {f.xSideCorner, side * f.ySideline});
    const Vector2d corner{f.xSideCorner, side * f.ySideline};
    segments_[border].push_back({corner, {-corner.x(), corner.y()}});
  }
  addMirrored(EdgeType::line, {f.xGroundline, f.yGoal}, {f.xGroundline, -f.yGoal});
  for (const EdgeType type : {EdgeType::yellowGoal, EdgeType::skyblueGoal}) {
    const double x = (type == EdgeType::skyblueGoal) == (team == TeamColor::red) ? 1 : -1;
    const auto at = [&](double along, double y) { return Vector2d{x * along, y}; };
    segments_[type].push_back({at(f.xGoalBack, -f.yGoal), at(f.xGoalBack, f.yGoal)});
    for (const double y : {-f.yGoal, f.yGoal})
      segments_[type].push_back({at(f.xGroundline, y), at(f.xGoalBack, y)});
  }
}

void FieldEdges::addMirrored(EdgeType type, const Vector2d& from, const Vector2d& to) {
  segments_[type].push_back({from, to});
  segments_[type].push_back({{-from.x(), from.y()}, {-to.x(), to.y()}});
}

Vector2d FieldEdges::closest(EdgeType type, const Vector2d& point) const {
  Vector2d best = Vector2d::Zero();
  double least = std::numeric_limits<double>::max();
  const auto consider = [&](const Vector2d& candidate) {
    const double distance = (candidate - point).squaredNorm();
    if (distance >= least) return;
    least = distance;
    best = candidate;
  };
  for (const Segment& s : segments_[type]) {
    const Vector2d way = s.to - s.from;
    const double along = std::clamp((point - s.from).dot(way) / way.squaredNorm(), 0., 1.);
    consider(s.from + along * way);
  }
  if (type == EdgeType::line && point.squaredNorm() > 0)
    consider(circleRadius_ * point.normalized());
  return best;
}

void FieldEdges::crossings(EdgeType type, const Vector2d& from, const Vector2d& ray,
                           std::vector<double>& distances) const {
  const auto cross = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  for (const Segment& s : segments_[type]) {
    const Vector2d way = s.to - s.from, toSegment = s.from - from;
    const double slope = cross(ray, way);
    if (std::abs(slope) < 1e-9) continue;  // parallel: seen lengthwise
    const double distance = cross(toSegment, way) / slope;
    const double along = cross(toSegment, ray) / slope;
    if (distance > 0 && along >= 0 && along <= 1) distances.push_back(distance);
  }
  if (type != EdgeType::line) return;
  const double middle = -from.dot(ray);
  const double squared = circleRadius_ * circleRadius_ - (from.squaredNorm() - middle * middle);
  if (squared <= 0) return;
  for (const double distance : {middle - std::sqrt(squared), middle + std::sqrt(squared)})
    if (distance > 0) distances.push_back(distance);
}

}  // namespace gt
