#pragma once
#include <vector>

#include "debug/Debug.h"
#include "modules/behavior/potentialfields/PotentialScene.h"

namespace gt {

/// Follows potential fields (report 3.8.3). A robot that only follows the force at its position
/// ends in the first local minimum. Therefore the pilot simulates the path ahead. If that gets
/// stuck, it plans by a wave front: the cheapest path to the target on a grid on which repulsion
/// adds to the cost. The resulting potential has no other minimum than the target.
class FieldPilot {
 public:
  struct Parameters {
    double step = 40;
    double arrival = 60;
    double longest = 8000;
    double cell = 100;
    double repulsionCost = 6;
    double lookAhead = 130;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::step>(Unit::mm, "distance between two points of the path ahead", {5, 500}),
          field<&P::arrival>(Unit::mm, "distance from the target at which the path ends",
                             {1, 1000}),
          field<&P::longest>(Unit::mm, "longest path", {100, 1e5}),
          field<&P::cell>(Unit::mm,
                          "size of the cells on which a path out of a local minimum is planned",
                          {20, 1000}),
          field<&P::repulsionCost>(
              "increase of the cost of a path for each unit of repulsion on it; 0: local minima "
              "are not left",
              {0, 100}),
          field<&P::lookAhead>(
              Unit::mm, "distance of the point of the path for which the robot heads", {1, 1000})};
    }
  };

  /// Plans the path from a place (mm, on the field) to the target of the scene. Returns the force
  /// for the robot's motion: its strength is that at the place, its direction that of the path.
  Vector2d update(const PotentialField& field, PotentialScene scene, const Vector2d& from,
                  const Parameters& parameters);

  const std::vector<Vector2d>& path() const { return path_; }
  /// Whether the path leads to the target.
  bool arrives() const { return arrives_; }
  /// Whether the forces alone end in a local minimum, so that the path was planned around it.
  bool leavesMinimum() const { return leavesMinimum_; }

  /// Draws the field as arrows, and the path: figure 3.17.
  void draw(Canvas& canvas, const FieldDimensions& field) const;

 private:
  /// Whether the robot can reach the target itself; otherwise it waits where the forces are
  /// balanced.
  bool reachable() const;
  void walkAhead(const Vector2d& from);
  void planByWave(const Vector2d& from);
  Vector2d onPath() const;
  /// The rules of the field with an effect.
  PotentialField part(PotentialEffect effect) const;

  PotentialField field_;
  PotentialScene scene_;
  Parameters parameters_;
  std::vector<Vector2d> path_;
  bool arrives_ = false, leavesMinimum_ = false;
};
static_assert(complete<FieldPilot::Parameters>);

}  // namespace gt
