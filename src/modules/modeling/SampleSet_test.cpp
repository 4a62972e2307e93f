#include "modules/modeling/SampleSet.h"

#include <gtest/gtest.h>

#include <map>

namespace gt {
namespace {

const FieldDimensions fieldDimensions;

TEST(SampleSet, ResamplingCopiesByProbability) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random{seed};
    std::vector<Sample> samples, buffer;
    double sum = 0;
    std::vector<double> weights;
    for (int i = 0; i < 50; ++i) {
      weights.push_back(i % 5 == 0 ? 0 : random.uniform());
      sum += weights.back();
      samples.push_back(Sample::at({0, static_cast<double>(i), 0}, weights.back()));
    }
    std::map<int, int> copies;
    constexpr int rounds = 4000;
    for (int round = 0; round < rounds; ++round) {
      std::vector<Sample> set = samples;
      resample(set, buffer, random);
      ASSERT_EQ(set.size(), samples.size());
      std::map<int, int> now;
      for (const Sample& sample : set) ++now[static_cast<int>(sample.position.x())];
      for (int i = 0; i < 50; ++i) {
        const double expected = 50 * weights[static_cast<std::size_t>(i)] / sum;
        EXPECT_GE(now[i], std::floor(expected));
        EXPECT_LE(now[i], std::ceil(expected));
        copies[i] += now[i];
      }
    }
    for (int i = 0; i < 50; ++i)
      EXPECT_NEAR(static_cast<double>(copies[i]) / rounds,
                  50 * weights[static_cast<std::size_t>(i)] / sum, 0.04);
  }
}

TEST(SampleSet, WithoutAnyProbabilitySamplesStay) {
  Random random{1};
  std::vector<Sample> samples{Sample::at({0, 1, 0}, 0), Sample::at({0, 2, 0}, 0)}, buffer;
  resample(samples, buffer, random);
  EXPECT_EQ(samples[0].position.x(), 1);
  EXPECT_EQ(samples[1].position.x(), 2);
}

TEST(SampleSet, TheLargestClusterWins) {
  Random random{5};
  std::vector<Sample> samples;
  for (int i = 0; i < 60; ++i) {
    const Vector2d position{800 + 50 * random.symmetric(), -300 + 50 * random.symmetric()};
    samples.push_back(Sample::at({0.5 + 0.05 * random.symmetric(), position}, 0.8));
  }
  for (int i = 0; i < 40; ++i) samples.push_back(Sample::at({-2, -1500, 900}, 1));
  const Cluster cluster = largestCluster(samples, fieldDimensions);
  EXPECT_EQ(cluster.size, 60);
  EXPECT_NEAR(cluster.pose.translation.x(), 800, 20);
  EXPECT_NEAR(cluster.pose.translation.y(), -300, 20);
  EXPECT_NEAR(cluster.pose.rotation, 0.5, 0.02);
  EXPECT_NEAR(cluster.validity, 0.6 * 0.8, 1e-9);  // (3.16)
}

TEST(SampleSet, RotationsAreAveragedAcrossTheSeam) {
  const std::vector<Sample> samples{Sample::at({pi - 0.1, 0, 0}, 1),
                                    Sample::at({-pi + 0.1, 0, 0}, 1)};
  const Cluster cluster = largestCluster(samples, fieldDimensions);
  EXPECT_EQ(cluster.size, 2);
  EXPECT_NEAR(std::abs(cluster.pose.rotation), pi, 1e-9);
}

TEST(SampleSet, ClustersAtTheFieldsEdgesAreFound) {
  for (const double x : {-2400.0, 2400.0})
    for (const double y : {-1350.0, 1350.0}) {
      const std::vector<Sample> samples{Sample::at({0, x, y}, 1)};
      EXPECT_EQ(largestCluster(samples, fieldDimensions).pose.translation, (Vector2d{x, y}));
    }
}

TEST(SampleSet, RandomPosesCoverTheField) {
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

}  // namespace
}  // namespace gt
