#include "modules/behavior/potentialfields/PotentialScene.h"

#include <algorithm>
#include <limits>

namespace gt {
namespace {

constexpr double robotRadius = 110, ballRadius = 50;  // mm

Vector2d nearestOnLine(const Vector2d& from, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length = along.squaredNorm();
  if (length == 0) return a;
  return a + std::clamp((from - a).dot(along) / length, 0., 1.) * along;
}

PotentialShape rectangle(double left, double right, double bottom, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, true};
}

/// Adds walls, goals and the own penalty area.
void addField(const FieldDimensions& field, PotentialScene& scene) {
  scene.objects[PotentialObject::ownPenaltyArea] = {
      rectangle(-field.xGoalBack, -field.xPenaltyArea, -field.yPenaltyArea, field.yPenaltyArea)};
  auto& walls = scene.objects[PotentialObject::walls];
  auto& edges = scene.objects[PotentialObject::goalEdges];
  for (const double end : {-1., 1.})
    for (const double side : {-1., 1.}) {
      const Vector2d post{end * field.xGroundline, side * field.yGoal};
      edges.push_back({{post, {end * field.xGoalBack, side * field.yGoal}}});
      walls.push_back({{post,
                        {end * field.xGroundline, side * field.ySideCorner},
                        {end * field.xSideCorner, side * field.ySideline},
                        {0, side * field.ySideline}}});
    }
}

}  // namespace

double PotentialRule::forceAt(double distance) const {
  const double share = std::max(distance, 0.) / range;
  if (effect == PotentialEffect::attract) {
    switch (function) {
      case PotentialFunction::linear:
        return strength * std::min(1., share);
      case PotentialFunction::parabolic:
        return strength * std::min(1., share * share);
      case PotentialFunction::asymptotic:
        return strength * share / (1 + share);
    }
    return 0;
  }
  if (share >= 1) return 0;
  switch (function) {
    case PotentialFunction::linear:
      return strength * (1 - share);
    case PotentialFunction::parabolic:
      return strength * (1 - share) * (1 - share);
    case PotentialFunction::asymptotic:
      return strength * std::min(mostRepulsion, 1 / std::max(share, 1e-6) - 1);
  }
  return 0;
}

Vector2d PotentialShape::nearest(const Vector2d& from) const {
  Vector2d best = points.front();
  double least = std::numeric_limits<double>::max();
  const std::size_t lines = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < std::max<std::size_t>(lines, 1); ++i) {
    const Vector2d on = nearestOnLine(from, points[i], points[(i + 1) % points.size()]);
    if (const double distance = (on - from).squaredNorm(); distance < least)
      least = distance, best = on;
  }
  return best;
}

bool PotentialShape::contains(const Vector2d& place) const {
  if (!closed) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
    const Vector2d along = b - a, to = place - a;
    if (along.x() * to.y() - along.y() * to.x() < 0) return false;
  }
  return true;
}

PotentialScene PotentialScene::of(const WorldState& world, const ObstaclesModel& obstacles,
                                  const Vector2d& ball) {
  PotentialScene scene;
  addField(world.field, scene);
  scene.objects[PotentialObject::ball] = {{{ball}, false, ballRadius}};
  const auto add = [&](PotentialObject object, const std::vector<LocatedPlayer>& players) {
    for (const LocatedPlayer& player : players)
      scene.objects[object].push_back({{player.position}, false, robotRadius});
  };
  add(PotentialObject::teammates, world.players.ownTeam);
  add(PotentialObject::opponents, world.players.opponents);
  for (const ObstaclesModel::Sector& sector : obstacles.sectors)
    if (sector.obstacle)
      scene.objects[PotentialObject::obstacles].push_back(
          {{world.self.pose * sector.representative}});
  return scene;
}

double PotentialScene::strength(const PotentialRule& rule, const Vector2d& at) const {
  double strongest = 0;
  for (const PotentialShape& shape : objects[rule.object]) {
    const double distance = shape.contains(at) ? 0 : (shape.nearest(at) - at).norm() - shape.radius;
    strongest = std::max(strongest, rule.forceAt(distance));
  }
  return strongest;
}

Vector2d PotentialScene::force(const PotentialRule& rule, const Vector2d& at) const {
  Vector2d sum = Vector2d::Zero();
  const auto& shapes = objects[rule.object];
  // The obstacles' sectors are points of a few bodies: the nearest one counts, not their number.
  double strongest = 0;
  for (const PotentialShape& shape : shapes) {
    const Vector2d to = shape.nearest(at) - at;
    const double distance = to.norm();
    if (distance < 1e-9) continue;
    const bool inside = shape.contains(at);
    const double force = rule.forceAt(inside ? 0 : distance - shape.radius);
    const bool away = (rule.effect == PotentialEffect::repel) != inside;
    const Vector2d pull = (away ? -force : force) / distance * to;
    if (rule.object != PotentialObject::obstacles) {
      sum += pull;
    } else if (force > strongest) {
      strongest = force;
      sum = pull;
    }
  }
  return sum;
}

Vector2d PotentialScene::force(const PotentialField& field, const Vector2d& at) const {
  Vector2d sum = Vector2d::Zero();
  for (const PotentialRule& rule : field.rules) sum += force(rule, at);
  return sum;
}

}  // namespace gt
