#include "modules/modeling/FieldEdges.h"

#include <algorithm>
#include <limits>

namespace gt {

FieldEdges::FieldEdges(const FieldDimensions& f, TeamColor team)
    : circleRadius_(f.centerCircleRadius) {
  const Vector2d half{0, f.ySideline};
  segments_[EdgeType::line].push_back({half, -half});
  addMirrored(EdgeType::line, {f.xPenaltyArea, f.yPenaltyArea}, {f.xPenaltyArea, -f.yPenaltyArea});
  for (const double side : {-1, 1}) {
    addMirrored(EdgeType::line, {f.xPenaltyArea, side * f.yPenaltyArea},
                {f.xGroundline, side * f.yPenaltyArea});
    addMirrored(EdgeType::border, {f.xGroundline, side * f.yGoal},
                {f.xGroundline, side * f.ySideCorner});
    addMirrored(EdgeType::border, {f.xGroundline, side * f.ySideCorner},
                {f.xSideCorner, side * f.ySideline});
    const Vector2d corner{f.xSideCorner, side * f.ySideline};
    segments_[EdgeType::border].push_back({corner, {-corner.x(), corner.y()}});
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

}  // namespace gt
