#include "modules/modeling/selflocator/Bearings.h"

namespace gt {

Bearings bearingsIn(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field) {
  Bearings bearings;
  for (int i = 0; i < percept.numberOfFlags; ++i) {
    const FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
    const Vector2d position = positionOf(flag.type, team, field);
    const ConditionalBoundary& edges = flag.boundary;
    if (!edges.leftOnBorder) bearings.add(position, field.flagRadius, edges.left);
    if (!edges.rightOnBorder) bearings.add(position, -field.flagRadius, edges.right);
  }
  for (int i = 0; i < percept.numberOfGoals; ++i) {
    const GoalPercept& goal = percept.goals[static_cast<std::size_t>(i)];
    const ConditionalBoundary& edges = goal.boundary;
    if (!edges.leftOnBorder)
      bearings.add(positionOfPost(goal.color, true, team, field), 0, edges.left);
    if (!edges.rightOnBorder)
      bearings.add(positionOfPost(goal.color, false, team, field), 0, edges.right);
  }
  return bearings;
}

}  // namespace gt
