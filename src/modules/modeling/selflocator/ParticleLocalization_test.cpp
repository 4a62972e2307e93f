#include "modules/modeling/selflocator/ParticleLocalization.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/SyntheticRobot.h"

namespace gt {
namespace {

/// A robot that stands and sees landmarks and edges, and its particles.
struct ParticleBench {
  ParticleBench() {
    do robot.step();
    while (robot.percept.numberOfFlags == 0 || robot.lines.points[EdgeType::border].empty());
  }
  static SyntheticWorld standing() {
    SyntheticWorld world;
    world.walks = false;
    world.turnsHeadAlways = true;
    return world;
  }
  void update(const RobotPose* candidate = nullptr) {
    localization.update(
        {particles, motion, templates.newProbability, &landmarks, &templates, &edges},
        {&robot.percept, &robot.lines, &robot.camera}, robot.odometry, robot.field, robot.player,
        candidate, estimate, random, debug);
  }
  EnumArray<Likelihood, float> judged() const { return localization.particles().meanLikelihoods(); }

  SyntheticRobot robot{3, standing()};
  int particles = 100;
  MotionModel motion;
  LandmarkModel::Parameters landmarks;
  TemplateReplacement templates;
  EdgeModel::Parameters edges;
  ParticleLocalization localization{Likelihood::landmarks, Likelihood::lines, Likelihood::border,
                                    Likelihood::goals};
  RobotPose estimate;
  Random random{1};
  Debug debug{1024};
};

TEST(ParticleLocalization, EachPerceptCountsOnce) {
  ParticleBench bench;
  bench.update();
  const auto first = bench.judged();
  bench.update();
  EXPECT_EQ(bench.judged().values, first.values) << "the same image again";
  bench.robot.percept.time = bench.robot.percept.time + 40;
  bench.update();
  const auto second = bench.judged();
  EXPECT_NE(second[Likelihood::landmarks], first[Likelihood::landmarks]);
  bench.templates.replacement = bench.templates.randomReplacement = 0;
  bench.edges.newLikelihood = 0;  // nothing is replaced
  bench.robot.lines.time = bench.robot.lines.time + 80;
  bench.update();
  EXPECT_NE(bench.judged()[Likelihood::border], second[Likelihood::border]);
}

TEST(ParticleLocalization, FollowsTheOdometryWhereNothingIsSeen) {
  ParticleBench bench;
  bench.motion = {0, 0, 0, 0, 0, 0};  // no noise
  bench.particles = 1;
  bench.update();
  const Pose2D before = bench.estimate.pose, step{0.1, 50, -20};
  bench.robot.odometry.pose = bench.robot.odometry.pose * step;
  bench.update();
  const Pose2D expected = before * step;
  EXPECT_NEAR((bench.estimate.pose.translation - expected.translation).norm(), 0, 1);
  EXPECT_NEAR(normalize(bench.estimate.pose.rotation - expected.rotation), 0, 1e-2);
}

TEST(ParticleLocalization, ACandidateReplacesImprobableParticlesAsOftenAsItIsValid) {
  const auto share = [](double validity) {
    ParticleBench bench;
    const Vector2d place{777, -333};
    const RobotPose candidate{{1, place}, validity};
    bench.edges.newLikelihood = 0;       // edges replace nothing
    bench.templates.newProbability = 0;  // all are improbable
    bench.particles = 1000;
    bench.motion = {0, 0, 0, 0, 0, 0};
    bench.update(&candidate);
    const ParticleSet& set = bench.localization.particles();
    int there = 0;
    for (std::size_t i = 0; i < set.size(); ++i)
      there += (set.pose(i).translation - place).norm() < 1;
    return there / 1000.;
  };
  EXPECT_EQ(share(0), 0);
  const double half = share(0.5), whole = share(1);
  EXPECT_GT(whole, 0.8);
  EXPECT_NEAR(half, whole / 2, 0.1);
}

TEST(ParticleLocalization, PosesFromWhichAnEdgeIsSeenReplaceImprobableParticles) {
  ParticleBench bench;
  bench.motion = {0, 0, 0, 0, 0, 0};
  bench.edges.correction = 0;  // nothing else moves a particle
  bench.templates.replacement = bench.templates.randomReplacement = 0;
  bench.robot.lines.time = never();  // not seen yet
  bench.robot.percept.time = never();
  bench.update();
  const ParticleSet before = bench.localization.particles();
  for (int i = 0; i < 10; ++i) {
    bench.robot.lines.time = bench.robot.time + i;
    bench.update();
  }
  const FieldEdges edges{bench.robot.field, bench.robot.player.teamColor};
  const ParticleSet& after = bench.localization.particles();
  int fresh = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (std::find(before.x.begin(), before.x.end(), after.x[i]) != before.x.end()) continue;
    ++fresh;
    double nearest = 1e9;
    for (std::size_t t = 0; t < enumCount<EdgeType>; ++t)
      for (const Vector2d& point : bench.robot.lines.points[static_cast<EdgeType>(t)]) {
        const Vector2d place = after.pose(i) * point;
        nearest =
            std::min(nearest, (edges.closest(static_cast<EdgeType>(t), place) - place).norm());
      }
    EXPECT_LT(nearest, 60);
  }
  EXPECT_GT(fresh, 10);
}

}  // namespace
}  // namespace gt
