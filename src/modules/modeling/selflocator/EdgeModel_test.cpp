#include "modules/modeling/selflocator/EdgeModel.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

const FieldDimensions dimensions;

/// A set of one particle, judged by one point.
struct Judge {
  ParticleSet set{Likelihood::lines, Likelihood::border, Likelihood::goals};
  EdgeModel model;
  EdgeModel::Parameters parameters;
  Vector3d camera{100, 0, 200};
  Random random{1};

  Judge() {
    model.prepare(dimensions, TeamColor::red);
    set.resize(1, dimensions, 0.5, random);
  }
  /// The likelihood after a point was seen from a pose, from 0.5 on.
  float see(EdgeType type, const Pose2D& pose, const Vector2d& point, double speed = 0) {
    EnumArray<Likelihood, float> half;
    half.values.fill(0.5f);
    set.replace(0, pose, half);
    LinesPercept percept;
    percept.points[type].push_back(point);
    model.choose(percept, 1, 3000, random);
    model.observe(parameters, camera, speed, set);
    return set.likelihood[likelihoodOf(type)][0];
  }
};

TEST(EdgeModel, SimilaritiesFollowTheReport) {
  Judge judge;
  judge.parameters.rise = judge.parameters.fall = 1;  // unfiltered
  judge.parameters.correction = 0;
  Random random{3};
  for (int i = 0; i < 500; ++i) {
    const Pose2D pose{pi * random.symmetric(), 1500 * random.symmetric(), 900 * random.symmetric()};
    const Vector2d point = random.uniform(300, 2000) * direction(random.symmetric());
    const double speed = random.uniform(0, 300);
    const auto place = pose * point;
    const EdgeTables::Point model = judge.model.tables().closest(
        EdgeType::border, static_cast<float>(place.x()), static_cast<float>(place.y()));
    const Vector2d offset = judge.camera.head<2>();
    const Vector2d seen = point - offset, expected = relative(pose, {model.x, model.y}) - offset;
    const double alpha = std::atan2(200, seen.norm()) - std::atan2(200, expected.norm());
    const double beta = normalize(angleOf(seen) - angleOf(expected));
    const double q = std::exp(-(10 - 9 * std::min(speed, 200.) / 200) * alpha * alpha) *
                     std::exp(-100 * beta * beta);  // (3.17), (3.18)
    EXPECT_NEAR(judge.see(EdgeType::border, pose, point, speed), q, 2e-3);
  }
}

TEST(EdgeModel, LikelihoodChangesByBoundedSteps) {
  Judge judge;
  const Pose2D atLine{0, -500, 800};
  EXPECT_FLOAT_EQ(judge.see(EdgeType::line, atLine, {500, 0}), 0.51f);  // (3.19)
  EXPECT_FLOAT_EQ(judge.see(EdgeType::line, {-0.8, -400, 800}, {900, 500}), 0.495f);
  EXPECT_FLOAT_EQ(judge.see(EdgeType::yellowGoal, {0, 1000, 0}, {500, 0}), 0.495f);
  EXPECT_FLOAT_EQ(judge.set.likelihood[Likelihood::lines][0], 0.5f);  // each kind apart
}

TEST(EdgeModel, CorrectsPerpendicularToTheEdge) {
  Judge judge;
  judge.see(EdgeType::line, {0, -500, 800}, {400, 0});  // 100 mm short of the halfway line
  EXPECT_GT(judge.set.x[0], -500 + 5);
  EXPECT_LT(judge.set.x[0], -500 + 50);
  EXPECT_NEAR(judge.set.y[0], 800, 1e-3) << "along the line nothing is known";
  const float standing = judge.set.x[0];
  judge.see(EdgeType::line, {0, -500, 800}, {400, 0}, 200);
  EXPECT_LT(judge.set.x[0], standing) << "a fast robot's head shakes";
  judge.see(EdgeType::line, {0, -500, 800}, {900, 0});  // too far off to belong to it
  EXPECT_EQ(judge.set.x[0], -500);
}

TEST(EdgeModel, ReplacesOnlyParticlesBelowTheAverage) {
  ParticleSet set{Likelihood::lines, Likelihood::border, Likelihood::goals};
  Random random{1};
  set.resize(100, dimensions, 0.5, random);
  for (std::size_t i = 0; i < 50; ++i) set.likelihood[Likelihood::goals][i] = 0.01f;
  set.multiplyLikelihoods();
  const ParticleSet before = set;
  EdgeModel model;
  model.prepare(dimensions, TeamColor::red);
  LinesPercept percept;
  percept.points[EdgeType::border].push_back({800, 0});
  model.choose(percept, 1, 3000, random);
  model.replaceImprobable({}, set, random);
  int replaced = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    if (set.x[i] == before.x[i]) continue;
    ++replaced;
    EXPECT_LT(i, 50u);
    EXPECT_NEAR(set.likelihood[Likelihood::goals][i], 0.95 * 0.255, 1e-3);  // a little below
    EXPECT_NEAR(set.likelihood[Likelihood::lines][i], 0.95 * 0.5, 1e-3);
  }
  EXPECT_GT(replaced, 35);  // (3.21): 1 - 2 * 0.01 / 0.51 of them
}

}  // namespace
}  // namespace gt
