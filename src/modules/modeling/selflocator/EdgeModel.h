#pragma once
#include <memory>
#include <vector>

#include "base/Random.h"
#include "base/Time.h"
#include "modules/modeling/selflocator/EdgeTables.h"
#include "modules/modeling/selflocator/ParticleSet.h"
#include "representations/infrastructure/Player.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

/// A point on an edge that was chosen from those of an image (mm, relative to the robot).
struct ChosenPoint {
  EdgeType type;
  Vector2d point;
};

/// Computes likelihoods of particles from points on edges, corrects the particles, and draws new
/// ones from the points (report 3.3.3). Shared by all self-locators that use edges. The constants
/// are the report's except the number of points, which was 1 for lack of computing time, and the
/// correction, for which its text states no constant.
class EdgeModel {
 public:
  struct Parameters {
    int points = 5;
    double verticalWeight = 10;
    double verticalWeightLoss = 9;
    double fastest = 200;
    double horizontalWeight = 100;
    double rise = 0.01;
    double fall = 0.005;
    double correction = 0.25;
    double correctionRange = 600;
    double correctionLimit = 300;
    double farthest = 3000;
    double newLikelihood = 0.95;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::points>("number of points of each type used in an image", {1, 100}),
          field<&P::verticalWeight>("weight of vertical angles while the robot stands, (3.18)",
                                    {0, 1e5}),
          field<&P::verticalWeightLoss>("loss of that weight at full speed, (3.18)", {0, 1e5}),
          field<&P::fastest>(Unit::mmPerS, "speed of the robot that counts as full speed, (3.18)",
                             {1, 1e4}),
          field<&P::horizontalWeight>("weight of horizontal angles, (3.18)", {0, 1e5}),
          field<&P::rise>("greatest rise of a likelihood by one point, (3.19)", {0, 1}),
          field<&P::fall>("greatest fall of a likelihood by one point, (3.19)", {0, 1}),
          field<&P::correction>(
              "share of the distance to the edge by which a near point corrects a particle of a "
              "standing robot",
              {0, 1}),
          field<&P::correctionRange>(Unit::mm, "distance at which a point corrects half as much",
                                     {1, 1e5}),
          field<&P::correctionLimit>(
              Unit::mm, "distance from the edge beyond which a point corrects nothing", {0, 1e5}),
          field<&P::farthest>(Unit::mm, "greatest distance of points that are used", {0, 1e5}),
          field<&P::newLikelihood>("likelihood of a new particle, as a share of the average",
                                   {0, 1})};
    }
  };

  /// Prepares the tables of a field; computes them if the field or the team has changed.
  void prepare(const FieldDimensions& field, TeamColor team);
  /// Chooses up to `points` points of each type in an image at random, and skips those that are
  /// `farthest` (mm) away or more.
  void choose(const LinesPercept& percept, int points, double farthest, Random& random);
  /// Updates the likelihoods of lines, border and goals of all particles by the chosen points, and
  /// moves the particles towards the edges (report (3.17) to (3.19), 3.3.3.3). `camera` is its
  /// position relative to the robot (mm), `speed` that of the robot (mm/s).
  void observe(const Parameters& parameters, const Vector3d& camera, double speed,
               ParticleSet& particles);
  /// Replaces particles that are improbable relative to the others by poses from which one of the
  /// chosen points may have been seen (3.21).
  void replaceImprobable(const Parameters& parameters, ParticleSet& particles,
                         Random& random) const;

  const std::vector<ChosenPoint>& chosen() const { return chosen_; }
  const EdgeTables& tables() const { return *tables_; }

 private:
  void observe(const Parameters& parameters, const ChosenPoint& chosen, const Vector3d& camera,
               double speed, ParticleSet& particles);

  std::unique_ptr<EdgeTables> tables_;
  FieldDimensions field_;
  TeamColor team_ = TeamColor::red;
  std::vector<ChosenPoint> chosen_;
  std::vector<float> modelX_, modelY_;  ///< The closest model point of each particle.
};

/// The likelihood to which an edge contributes.
constexpr Likelihood likelihoodOf(EdgeType type) {
  return type == EdgeType::line     ? Likelihood::lines
         : type == EdgeType::border ? Likelihood::border
                                    : Likelihood::goals;
}

/// The speed of a robot from image to image, in mm/s, by its odometry.
class SpeedBetweenImages {
 public:
  double operator()(const OdometryData& odometry, Time now);

 private:
  OdometryData last_;
  Time time_ = never();
};

}  // namespace gt
