#include "modules/modeling/selflocator/ParticleDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gt {
namespace {

const DebugKey drawParticles{"SelfLocator/samples"};
const DebugKey poseKey{"SelfLocator/pose"};
const DebugKey drawEdges{"SelfLocator/edges"};
const std::array<DebugKey, enumCount<EdgeType>> distanceKeys{
    DebugKey{"SelfLocator/distances/lines"}, DebugKey{"SelfLocator/distances/border"},
    DebugKey{"SelfLocator/distances/yellowGoal"}, DebugKey{"SelfLocator/distances/skyblueGoal"}};

const EnumArray<EdgeType, Color> edgeColors{colors::white, colors::gray, colors::yellow,
                                            colors::skyblue};

void drawDistances(EdgeType type, const EdgeTables& tables, const FieldDimensions& field,
                   Canvas& canvas) {
  constexpr double step = 100, farthest = 1500;
  for (double x = -field.xGoalBack; x <= field.xGoalBack; x += step)
    for (double y = -field.ySideline; y <= field.ySideline; y += step) {
      const EdgeTables::Point edge =
          tables.closest(type, static_cast<float>(x), static_cast<float>(y));
      const double distance = std::hypot(edge.x - x, edge.y - y);
      canvas.disk({x, y}, step / 2 * std::min(distance / farthest, 1.), edgeColors[type]);
    }
}

}  // namespace

void drawPose(const Pose2D& pose, Debug& debug) {
  if (auto canvas = debug.onField(poseKey)) canvas.pose(pose, colors::red);
}

void draw(const ParticleSet& particles, const RobotPose& robotPose, Debug& debug) {
  if (auto canvas = debug.onField(drawParticles))
    for (std::size_t i = 0; i < particles.size(); ++i)
      canvas.pose(particles.pose(i), colors::gray, 60);
  drawPose(robotPose.pose, debug);
}

void draw(const EdgeModel& edges, const FieldDimensions& field, const Pose2D& pose, Debug& debug) {
  if (auto canvas = debug.onField(drawEdges))
    for (const ChosenPoint& chosen : edges.chosen()) {
      const Vector2d place = pose * chosen.point;
      const EdgeTables::Point model = edges.tables().closest(
          chosen.type, static_cast<float>(place.x()), static_cast<float>(place.y()));
      canvas.disk(place, 20, edgeColors[chosen.type]);
      canvas.line(place, {model.x, model.y}, edgeColors[chosen.type]);
    }
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t)
    if (auto canvas = debug.onField(distanceKeys[t]))
      drawDistances(static_cast<EdgeType>(t), edges.tables(), field, canvas);
}

}  // namespace gt
