#include "modules/modeling/selflocator/LinesSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/selflocator/Fusion2003SelfLocator.h"
#include "modules/modeling/testing/LocalizationTrial.h"
#include "modules/modeling/testing/Locators.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

const FieldDimensions fieldDimensions;

/// A set of one particle, judged by one point.
struct Judge {
  ParticleSet set{Likelihood::lines, Likelihood::border, Likelihood::goals};
  EdgeModel model;
  EdgeModel::Parameters parameters;
  Vector3d camera{100, 0, 200};
  Random random{1};

  Judge() {
    model.prepare(fieldDimensions, TeamColor::red);
    set.resize(1, fieldDimensions, 0.5, random);
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

TEST(EdgeTables, KnowTheClosestEdgeOfEachCell) {
  const EdgeTables tables{fieldDimensions, TeamColor::blue};
  const FieldEdges edges{fieldDimensions, TeamColor::blue};
  EXPECT_EQ(tables.resolution(), 25);
  Random random{1};
  int far = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d place{2500 * random.symmetric(), 1500 * random.symmetric()};
    for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
      const auto type = static_cast<EdgeType>(t);
      const EdgeTables::Point found =
          tables.closest(type, static_cast<float>(place.x()), static_cast<float>(place.y()));
      const double distance = (Vector2d{found.x, found.y} - place).norm();
      const double least = (edges.closest(type, place) - place).norm();
      EXPECT_NEAR(distance, least, 35);  // where two edges or arcs are near
      far += std::abs(distance - least) > 1;
    }
  }
  EXPECT_LT(far, 400);  // of 8000: the nearest edge is nearly always a straight one
  // Wherever a point is, there is an answer.
  EXPECT_NEAR(tables.closest(EdgeType::border, 9000, 900).x, fieldDimensions.xGroundline, 1);
}

TEST(EdgeTables, AreOfBoundedSizeOnAnyField) {
  FieldDimensions huge;
  huge.xGroundline = huge.xGoalBack = 1e5;
  EXPECT_GT(EdgeTables(huge, TeamColor::red).resolution(), 300);
}

/// From a drawn pose an edge of that type is seen where the point was measured.
TEST(EdgeTables, DrawPosesThatSeeWhatWasSeen) {
  const EdgeTables tables{fieldDimensions, TeamColor::red};
  const FieldEdges edges{fieldDimensions, TeamColor::red};
  Random random{2};
  int drawn = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto type = static_cast<EdgeType>(random.index(4));
    const Vector2d seen = random.uniform(200, 2500) * direction(1.5 * random.symmetric());
    if (tables.posesCount(type, seen) == 0) continue;
    ++drawn;
    const Pose2D pose = tables.drawPose(type, seen, random);
    const Vector2d place = pose * seen;
    EXPECT_LT((edges.closest(type, place) - place).norm(), 51) << place.transpose();
    EXPECT_LE(std::abs(pose.translation.x()), fieldDimensions.xGroundline);
  }
  EXPECT_GT(drawn, 1900);
}

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
  set.resize(100, fieldDimensions, 0.5, random);
  for (std::size_t i = 0; i < 50; ++i) set.likelihood[Likelihood::goals][i] = 0.01f;
  set.multiplyLikelihoods();
  const ParticleSet before = set;
  EdgeModel model;
  model.prepare(fieldDimensions, TeamColor::red);
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

template <typename Solution>
LocalizationTrial walk(std::uint64_t seed, bool flags) {
  SyntheticWorld world;
  world.flags = flags;
  world.turnsHeadAlways = true;
  world.walkingSpeed = 150;
  SyntheticRobot robot{seed, world};
  Solution locator;
  RobotPose estimate;
  Random random{seed};
  Debug debug{1024};
  const auto locate = [&](const SyntheticRobot& r) {
    if constexpr (std::is_same_v<Solution, LinesSelfLocator>)
      locator.update(r.lines, r.camera, r.odometry, r.field, r.player, estimate, random, debug);
    else
      locator.update(r.percept, r.lines, r.camera, r.odometry, r.field, r.player, estimate, random,
                     debug);
    return estimate;
  };
  follow(robot, 1000, locate);
  return follow(robot, 4000, locate);
}

TEST(LinesSelfLocator, FollowsAWalkingRobotWithoutBeacons) {
  std::vector<double> medians;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    medians.push_back(quantile(walk<LinesSelfLocator>(seed, false).errors, 0.5));
  EXPECT_LT(quantile(medians, 0.5), 90);  // report 3.3.3.4
}

TEST(GT2003SelfLocator, IsMoreExactThanBeaconsAlone) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    errors.push_back(mean(walk<GT2003SelfLocator>(seed, true).errors));
  EXPECT_LT(mean(errors), 80);
}

TEST(Fusion2003SelfLocator, NeedsFewParticles) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    errors.push_back(mean(walk<Fusion2003SelfLocator>(seed, true).errors));
  EXPECT_LT(mean(errors), 90);
}

TEST(SelfLocators, AllocateNothing) {
  for (const LocatorKind& kind : locatorKinds()) {
    const auto locator = kind.make(1);
    SyntheticRobot robot{1};
    long sum = 0;
    for (int i = 0; i < 1000; ++i) {
      robot.step();
      const long before = allocations();
      (*locator)(seenBy(robot));
      if (i >= 500) sum += allocations() - before;
    }
    EXPECT_EQ(sum, 0) << kind.name;
  }
}

}  // namespace
}  // namespace gt
