#include "modules/modeling/selflocator/ParticleSet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace gt {
namespace {

const FieldDimensions fieldDimensions;

/// A set of particles at these poses, of the probability of each.
ParticleSet setOf(const std::vector<std::pair<Pose2D, double>>& wanted) {
  ParticleSet set{Likelihood::landmarks};
  Random random{1};
  set.resize(wanted.size(), fieldDimensions, 1, random);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EnumArray<Likelihood, float> with;
    with.values.fill(static_cast<float>(wanted[i].second));
    set.replace(i, wanted[i].first, with);
  }
  return set;
}

TEST(ParticleSet, ResamplingCopiesByProbability) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random{seed};
    std::vector<std::pair<Pose2D, double>> particles;
    double sum = 0;
    std::vector<double> weights;
    for (int i = 0; i < 50; ++i) {
      weights.push_back(i % 5 == 0 ? 0 : random.uniform());
      sum += weights.back();
      particles.push_back({Pose2D{0, static_cast<double>(i), 0}, weights.back()});
    }
    const ParticleSet original = setOf(particles);
    std::map<int, int> copies;
    constexpr int rounds = 4000;
    for (int round = 0; round < rounds; ++round) {
      ParticleSet set = original;
      set.resample(random);
      ASSERT_EQ(set.size(), particles.size());
      std::map<int, int> now;
      for (const float x : set.x) ++now[static_cast<int>(x)];
      for (int i = 0; i < 50; ++i) {
        const double expected = 50 * weights[static_cast<std::size_t>(i)] / sum;
        EXPECT_GE(now[i], std::floor(expected - 1e-4));
        EXPECT_LE(now[i], std::ceil(expected + 1e-4));
        copies[i] += now[i];
      }
    }
    for (int i = 0; i < 50; ++i)
      EXPECT_NEAR(static_cast<double>(copies[i]) / rounds,
                  50 * weights[static_cast<std::size_t>(i)] / sum, 0.04);
  }
}

TEST(ParticleSet, WithoutAnyProbabilityParticlesStay) {
  Random random{1};
  ParticleSet particles = setOf({{{0, 1, 0}, 0}, {{0, 2, 0}, 0}});
  particles.resample(random);
  EXPECT_THAT(particles.x, testing::ElementsAre(1, 2));
}

TEST(ParticleSet, TheLargestClusterWins) {
  Random random{5};
  std::vector<std::pair<Pose2D, double>> particles;
  for (int i = 0; i < 60; ++i) {
    const Vector2d position{800 + 50 * random.symmetric(), -300 + 50 * random.symmetric()};
    particles.push_back({Pose2D{0.5 + 0.05 * random.symmetric(), position}, 0.8});
  }
  for (int i = 0; i < 40; ++i) particles.push_back({Pose2D{-2, -1500, 900}, 1});
  const Cluster cluster = setOf(particles).largestCluster(fieldDimensions);
  EXPECT_EQ(cluster.size, 60);
  EXPECT_NEAR(cluster.pose.translation.x(), 800, 20);
  EXPECT_NEAR(cluster.pose.translation.y(), -300, 20);
  EXPECT_NEAR(cluster.pose.rotation, 0.5, 0.02);
  EXPECT_NEAR(cluster.validity, 0.6 * 0.8, 1e-6);  // (3.16)
}

TEST(ParticleSet, RotationsAreAveragedAcrossTheSeam) {
  const std::vector<std::pair<Pose2D, double>> particles{{{pi - 0.1, 0, 0}, 1},
                                                         {{-pi + 0.1, 0, 0}, 1}};
  const Cluster cluster = setOf(particles).largestCluster(fieldDimensions);
  EXPECT_EQ(cluster.size, 2);
  EXPECT_NEAR(std::abs(cluster.pose.rotation), pi, 1e-6);
}

TEST(ParticleSet, ClustersAtTheFieldsEdgesAreFound) {
  for (const double x : {-2400.0, 2400.0})
    for (const double y : {-1350.0, 1350.0}) {
      const std::vector<std::pair<Pose2D, double>> particles{{{0, x, y}, 1}};
      EXPECT_EQ(setOf(particles).largestCluster(fieldDimensions).pose.translation,
                (Vector2d{x, y}));
    }
}

TEST(ParticleSet, RandomPosesCoverTheField) {
  Random random{6};
  Vector2d low{1e9, 1e9}, high{-1e9, -1e9}, mean{0, 0};
  for (int i = 0; i < 10000; ++i) {
    const Vector2d p = randomPose(fieldDimensions, random).translation;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    mean += p / 10000;
  }
  EXPECT_NEAR(high.x(), fieldDimensions.xGroundline, 10);
  EXPECT_NEAR(low.y(), -fieldDimensions.ySideline, 10);
  EXPECT_LT(mean.norm(), 60);
}

/// The mean and the largest difference of what the same step did to many particles.
TEST(ParticleSet, StepsErrAsTheMotionModelSays) {
  const Pose2D start{0.7, 300, -200}, step{0.2, 50, 20};
  ParticleSet set = setOf(std::vector<std::pair<Pose2D, double>>(5000, {start, 1}));
  Random random{3};
  set.move(step, {}, true, fieldDimensions, random);  // of certain particles none searches
  const double d = step.translation.norm();
  Vector3d sum = Vector3d::Zero(), most = Vector3d::Zero();
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Pose2D moved = set.pose(i).relativeTo(start);
    const Vector3d error{moved.translation.x() - step.translation.x(),
                         moved.translation.y() - step.translation.y(),
                         normalize(moved.rotation - step.rotation)};
    sum += error;
    most = most.cwiseMax(error.cwiseAbs());
  }
  const Vector3d expected{0.1 * d, 0.02 * d, 0.002 * d + 0.2 * 0.2};  // (3.8)
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(most[k], expected[k] * 1.001 + 1e-3);
    EXPECT_GT(most[k], expected[k] * 0.99);
    EXPECT_NEAR(sum[k] / 5000, 0, expected[k] * 0.05);
  }
}

TEST(ParticleSet, ImprobableParticlesSearchInProportion) {
  ParticleSet set = setOf(std::vector<std::pair<Pose2D, double>>(5000, {{0, 0, 0}, 0.7}));
  Random random{3};
  set.move({}, {}, true, fieldDimensions, random);
  Vector3d most = Vector3d::Zero();
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Pose2D pose = set.pose(i);
    most = most.cwiseMax(
        Vector3d{pose.translation.x(), pose.translation.y(), pose.rotation}.cwiseAbs());
  }
  EXPECT_NEAR(most.x(), 30, 0.3);  // (3.14)
  EXPECT_NEAR(most.y(), 30, 0.3);
  EXPECT_NEAR(most.z(), 0.15, 0.002);
}

TEST(ParticleSet, ManyStepsLeaveRotationsWhatTheyAre) {
  ParticleSet set = setOf({{{0.3, 0, 0}, 1}});
  Random random{1};
  for (int i = 0; i < 20000; ++i) set.move({0.5, 0, 0}, {}, true, fieldDimensions, random);
  EXPECT_NEAR(std::hypot(set.cosine[0], set.sine[0]), 1, 1e-5);
}

TEST(ParticleSet, AProbabilityIsTheProductOfItsLikelihood) {
  ParticleSet set{Likelihood::lines, Likelihood::border, Likelihood::goals};
  Random random{1};
  set.resize(3, fieldDimensions, 0.5, random);
  set.likelihood[Likelihood::lines] = {0.5f, 1, 0};
  set.likelihood[Likelihood::border] = {0.5f, 1, 1};
  set.likelihood[Likelihood::goals] = {1, 0.25f, 1};
  set.multiplyLikelihoods();
  EXPECT_THAT(set.probability, testing::ElementsAre(0.25f, 0.25f, 0));  // (3.20)
  EXPECT_FLOAT_EQ(set.meanLikelihoods()[Likelihood::lines], 0.5f);
  EXPECT_FLOAT_EQ(set.meanLikelihoods()[Likelihood::landmarks], 1);
}

}  // namespace
}  // namespace gt
