#pragma once
#include <vector>

#include "debug/Debug.h"
#include "modules/behavior/potentialfields/PotentialScene.h"

namespace gt {

/// Follows potential fields (report 3.8.3). A robot that only follows the force at its place ends
/// in the first local minimum. So the pilot walks the path ahead in thought. Where that gets stuck,
/// it plans by a wave front: the cheapest path to the target on a grid, on which repulsion makes
/// the way longer; the resulting potential has no other minimum than the target.
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
          field<&P::step>(Unit::mm, "between two points of the path ahead", {5, 500}),
          field<&P::arrival>(Unit::mm, "nearer to the target the path has arrived", {1, 1000}),
          field<&P::longest>(Unit::mm, "longest path", {100, 1e5}),
          field<&P::cell>(Unit::mm, "size of the cells on which a way out is planned", {20, 1000}),
          field<&P::repulsionCost>(
              "by which a way gets longer for each unit of repulsion on it; 0: local minima are "
              "not left",
              {0, 100}),
          field<&P::lookAhead>(Unit::mm, "the robot heads for this point of the path", {1, 1000})};
    }
  };

  /// Plans the path from a place to the target of the scene. Returns the force by which the robot
  /// moves there: as strong as at the place, and along the path.
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
  /// Whether nothing keeps the robot off the target itself; else it waits where the forces balance.
  bool reachable() const;
  void walkAhead(const Vector2d& from);
  void planByWave(const Vector2d& from);
  Vector2d onPath() const;
  /// The part of the field with an effect.
  PotentialField part(PotentialEffect effect) const;

  PotentialField field_;
  PotentialScene scene_;
  Parameters parameters_;
  std::vector<Vector2d> path_;
  bool arrives_ = false, leavesMinimum_ = false;
};
static_assert(complete<FieldPilot::Parameters>);

}  // namespace gt
