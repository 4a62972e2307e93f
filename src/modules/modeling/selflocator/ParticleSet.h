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

/// What is observed apart from each other: each kind has a filtered probability of its own, so that
/// what is seen often does not outvote what is seen rarely (report 3.3.3.1).
enum class Likelihood { landmarks, lines, border, goals };

/// How far a step may lead elsewhere than the odometry measures (report (3.8)), and how far
/// improbable particles are moved in search of a better place (3.14).
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
            Unit::mm, "farthest random search of an improbable particle, (3.14)", {0, 1000}),
        field<&M::searchAngle>(Unit::rad, "widest random search of an improbable particle, (3.14)",
                               {0, 3})};
  }
};

/// How fast a filtered probability follows (report (3.13), (3.19)).
struct ProbabilityFilter {
  float rise, fall;

  float operator()(float old, float now) const {
    const float least = old - fall, most = old + rise;
    const float notLess = now < least ? least : now;
    return notLess > most ? most : notLess;
  }
};

/// The average of the largest cluster, and how certain it is (report 3.3.2.4).
struct Cluster {
  Pose2D pose;
  double validity = 0;
  int size = 0;
};

/// A pose anywhere on the field.
Pose2D randomPose(const FieldDimensions& field, Random& random);

/// The hypotheses of where the robot is (report (3.7)), each with a probability. Single precision,
/// and an array for each number, since a loop over all particles then computes several at once;
/// instead of a rotation its cosine and sine, so that none has to be computed.
class ParticleSet {
 public:
  /// Particles with a filtered probability for each of these, at least one.
  explicit ParticleSet(std::initializer_list<Likelihood> kinds) : kinds_{kinds} {}

  /// So many particles; new ones stand anywhere on the field. Allocates if the number changes.
  void resize(std::size_t size, const FieldDimensions& field, double probability, Random& random);
  std::size_t size() const { return x.size(); }

  /// Moves all particles with the robot, by the odometry's step and an error of their own; if
  /// `search`, improbable ones also search. Walls stop particles as they stop robots.
  void move(const Pose2D& step, const MotionModel& model, bool search, const FieldDimensions& field,
            Random& random);
  /// The probability of each particle is the product of its likelihood (3.20).
  void multiplyLikelihoods();
  /// Copies particles so often as their probability demands (importance resampling, 3.3.2.3).
  void resample(Random& random);
  /// Puts a particle elsewhere, with that likelihood of each kind.
  void replace(std::size_t i, const Pose2D& pose, const EnumArray<Likelihood, float>& with);
  /// The mean likelihood of each kind over all particles; 1 of kinds that are not kept.
  EnumArray<Likelihood, float> meanLikelihoods() const;
  /// The particles in the fullest 2 x 2 x 2 of 10 x 10 x 10 cells over the field, averaged
  /// (report 3.3.2.4, (3.15), (3.16)).
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
  std::vector<std::int32_t> source_;  ///< Of each particle, in resampling.
  std::vector<std::int32_t> cellX_, cellY_, cellAngle_;
};

}  // namespace gt
