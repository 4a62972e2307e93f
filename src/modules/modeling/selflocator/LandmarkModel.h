#pragma once
#include <vector>

#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/ParticleSet.h"

namespace gt {

/// Computes likelihoods of particles from bearings on the edges of flags and goals (report
/// 3.3.2.2).
class LandmarkModel {
 public:
  struct Parameters {
    double steepness = 50;
    double rise = 0.1;
    double fall = 0.05;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::steepness>("steepness of the similarity of bearings, (3.11)", {0, 1e5}),
          field<&P::rise>("greatest rise of a likelihood in one image, (3.13)", {0, 1}),
          field<&P::fall>("greatest fall of a likelihood in one image, (3.13)", {0, 1})};
    }
  };

  /// Updates `Likelihood::landmarks` of all particles by the similarity of an image, (3.11) to
  /// (3.13). `cameraOffset` is the camera's position relative to the robot (mm).
  void observe(const Parameters& parameters, const Bearings& bearings, const Vector2d& cameraOffset,
               ParticleSet& particles);

 private:
  std::vector<float> sum_;  ///< Of squared deviations, for each particle.
};

}  // namespace gt
