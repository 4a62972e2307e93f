#pragma once
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Random.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "streams/Reflection.h"

namespace gt {

/// Kinds of observations with separate filtered likelihoods, so that frequent observations do not
/// outvote rare ones (report 3.3.3.1).
enum class Likelihood { landmarks, lines, border, goals };

/// Errors of a step measured by the odometry (report (3.8)), and distances by which improbable
/// particles are moved to search for a better pose (3.14).
struct MotionModel {
  double forwardError = 0.1;
  double sidewardError = 0.02;
  double turnErrorByDistance = 0.002;
  double turnErrorByAngle = 0.2;
  double searchDistance = 100;
  double searchAngle = 0.5;

  static constexpr auto fields() {
    using M = MotionModel;
    return Fields{
        field<&M::forwardError>("error ahead, as a share of the distance walked, (3.8)", {0, 1}),
        field<&M::sidewardError>("error sideways, as a share of the distance walked, (3.8)",
                                 {0, 1}),
        field<&M::turnErrorByDistance>(Unit::radPerMm,
                                       "error of the rotation for each mm walked, (3.8)", {0, 0.1}),
        field<&M::turnErrorByAngle>("error of the rotation, as a share of the angle turned, (3.8)",
                                    {0, 1}),
        field<&M::searchDistance>(
            Unit::mm, "greatest random displacement of an improbable particle, (3.14)", {0, 1000}),
        field<&M::searchAngle>(
            Unit::rad, "greatest random rotation of an improbable particle, (3.14)", {0, 3})};
  }
};

/// Limits the change of a filtered likelihood (report (3.13), (3.19)).
struct ProbabilityFilter {
  float rise, fall;

  float operator()(float old, float now) const {
    const float least = old - fall, most = old + rise;
    const float notLess = now < least ? least : now;
    return notLess > most ? most : notLess;
  }
};

/// The average pose of the largest cluster, and its validity (report 3.3.2.4).
struct Cluster {
  Pose2D pose;
  double validity = 0;
  int size = 0;
};

/// A random pose on the field (mm, rad).
Pose2D randomPose(const FieldDimensions& field, Random& random);

/// The particles (samples of the report, (3.7)): possible poses of the robot, each with a
/// probability. Numbers have single precision and an array each, so that loops over all particles
/// are vectorized. Cosine and sine replace the rotation, so that they need not be computed.
class ParticleSet {
 public:
  /// Creates particles with a filtered likelihood of each of these kinds, at least one.
  explicit ParticleSet(std::initializer_list<Likelihood> kinds) : kinds_{kinds} {}

  /// Sets the number of particles; new ones have random poses on the field. Allocates if the number
  /// changes.
  void resize(std::size_t size, const FieldDimensions& field, double probability, Random& random);
  std::size_t size() const { return x.size(); }

  /// Moves all particles by the odometry's step (mm, rad) and a random error each. If `search`,
  /// improbable ones are also moved to search for a better pose. Walls stop particles as they stop
  /// robots.
  void move(const Pose2D& step, const MotionModel& model, bool search, const FieldDimensions& field,
            Random& random);
  /// Sets the probability of each particle to the product of its likelihoods (3.20).
  void multiplyLikelihoods();
  /// Copies each particle in proportion to its probability (importance resampling, 3.3.2.3).
  void resample(Random& random);
  /// Replaces a particle by a pose (mm, rad; on the field) with the given likelihood of each kind.
  void replace(std::size_t i, const Pose2D& pose, const EnumArray<Likelihood, float>& with);
  /// The mean likelihood of each kind over all particles; 1 for kinds that are not kept.
  EnumArray<Likelihood, float> meanLikelihoods() const;
  /// The average of the particles in the block of 2 x 2 x 2 cells that contains most of them, of 10
  /// x 10 x 10 cells over the field and all rotations (report 3.3.2.4, (3.15), (3.16)).
  Cluster largestCluster(const FieldDimensions& field);

  Pose2D pose(std::size_t i) const;
  const std::vector<Likelihood>& kinds() const { return kinds_; }

  std::vector<float> x, y;                               ///< In mm on the field.
  std::vector<float> cosine, sine;                       ///< Of the rotation.
  std::vector<float> probability;                        ///< Of the particle.
  EnumArray<Likelihood, std::vector<float>> likelihood;  ///< Empty for kinds that are not kept.

 private:
  void drawNoise(std::size_t columns, Random& random);
  void assignCells(const FieldDimensions& field);
  template <typename Work>
  void forEachColumn(Work&& work);

  std::vector<Likelihood> kinds_;
  std::vector<float> noise_, buffer_;
  /// Index of the particle of which each is a copy, in resampling.
  std::vector<std::int32_t> source_;
  std::vector<std::int32_t> cellX_, cellY_, cellAngle_;
};

}  // namespace gt
