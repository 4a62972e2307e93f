#include "modules/modeling/selflocator/LandmarkModel.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

const FieldDimensions anyField;

/// One particle at a pose, judged from 0.5 on by bearings.
float judgeBy(const LandmarkModel::Parameters& parameters, const Bearings& bearings,
              const Vector2d& cameraOffset, const Pose2D& pose) {
  Random random{1};
  ParticleSet set{Likelihood::landmarks};
  set.resize(1, anyField, 0.5, random);
  EnumArray<Likelihood, float> half;
  half.values.fill(0.5f);
  set.replace(0, pose, half);
  LandmarkModel model;
  model.observe(parameters, bearings, cameraOffset, set);
  return set.likelihood[Likelihood::landmarks][0];
}

TEST(LandmarkModel, SimilaritiesFollowTheReport) {
  const LandmarkModel::Parameters unfiltered{.steepness = 50, .rise = 1, .fall = 1};
  Random random{2};
  for (int i = 0; i < 500; ++i) {
    const Pose2D pose{pi * random.symmetric(), 1500 * random.symmetric(), 900 * random.symmetric()};
    const Vector2d camera{random.uniform(0, 120), 30 * random.symmetric()};
    const Pose2D seenFrom{pose.rotation, pose * camera};
    Bearings bearings;
    double product = 1;
    for (int edge = 0; edge < 3; ++edge) {
      const Vector2d landmark{edge % 2 == 0 ? 1350. : -2100., 1350. * (edge - 1)};
      const double radius = edge == 0 ? 0 : edge == 1 ? 50 : -50;  // a post, edges of flags
      const Vector2d expected = relative(seenFrom, landmark);
      if (expected.norm() < 200) continue;
      const double error = 0.3 * random.symmetric();
      bearings.add(landmark, radius,
                   angleOf(expected) + std::asin(radius / expected.norm()) + error);
      product *= std::exp(-50 * (error / pi) * (error / pi));  // (3.11), (3.12)
    }
    EXPECT_NEAR(judgeBy(unfiltered, bearings, camera, pose), product, 5e-3);
  }
}

TEST(LandmarkModel, ALikelihoodChangesByBoundedSteps) {
  const LandmarkModel::Parameters parameters;
  Bearings right, wrong;
  right.add({1000, 0}, 0, 0);
  wrong.add({1000, 0}, 0, 3);
  EXPECT_FLOAT_EQ(judgeBy(parameters, right, {0, 0}, {}), 0.6f);  // (3.13)
  EXPECT_FLOAT_EQ(judgeBy(parameters, wrong, {0, 0}, {}), 0.45f);
}

}  // namespace
}  // namespace gt
