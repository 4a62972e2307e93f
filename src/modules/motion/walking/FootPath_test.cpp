#include "modules/motion/walking/FootPath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gt {
namespace {

constexpr int samples = 1000;
constexpr std::array modes{FootMode::rectangle, FootMode::halfEllipse, FootMode::ellipse,
                           FootMode::oval, FootMode::freeFormQuad};

/// A walk whose phases all differ.
WalkParameters walkWith(FootMode mode) {
  WalkParameters walk;
  walk.footMode = mode;
  walk.foreFootLift = 20;
  walk.hindFootLift = 30;
  walk.foreGroundPhase = 0.6;
  walk.foreLiftPhase = 0.1;
  walk.foreLoweringPhase = 0.06;
  return walk;
}

std::vector<FootPath::Point> cycle(const FootPath& path) {
  std::vector<FootPath::Point> points;
  for (int i = 0; i < samples; ++i) points.push_back(path.at(static_cast<double>(i) / samples));
  return points;
}

TEST(FootPath, IsClosedAndWithoutJumps) {
  for (const auto mode : modes) {
    const auto points = cycle({walkWith(mode), Leg::foreLeft});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto &now = points[i], &next = points[(i + 1) % points.size()];
      EXPECT_LT(std::abs(next.along - now.along), 0.04) << static_cast<int>(mode) << " " << i;
      EXPECT_LT(std::abs(next.height - now.height), 0.6) << static_cast<int>(mode) << " " << i;
      EXPECT_LT(std::abs(next.beyond - now.beyond), 0.6) << static_cast<int>(mode) << " " << i;
    }
  }
}

TEST(FootPath, GoesBackOnTheGroundAndAheadInTheAir) {
  for (const auto mode : modes) {
    const FootPath path{walkWith(mode), Leg::foreLeft};
    EXPECT_DOUBLE_EQ(path.groundPhase(), 0.6);
    EXPECT_NEAR(path.at(0.4).along, path.landing().along, 1e-6);
    EXPECT_NEAR(path.at(1 - 1e-9).along, path.lifting().along, 1e-6);
    EXPECT_NEAR(path.at(1e-9).height, path.lifting().height, 1e-3);
    for (double phase = 0.01; phase < 0.39; phase += 0.01) {
      EXPECT_TRUE(path.inAir(phase));
      EXPECT_GE(path.at(phase + 0.005).along, path.at(phase).along - 1e-9);
      EXPECT_GT(path.at(phase).height, 0);
    }
    for (double phase = 0.41; phase < 0.99; phase += 0.01) {
      EXPECT_FALSE(path.inAir(phase));
      EXPECT_LT(path.at(phase + 0.005).along, path.at(phase).along);
      EXPECT_LE(path.at(phase).height, 0);
    }
  }
}

/// The shapes of figure 3.20: how high, how deep and how far beyond its ends a foot gets.
TEST(FootPath, HasTheShapesOfTheReport) {
  struct Shape {
    FootMode mode;
    double highest, deepest, beyond;
  };
  for (const Shape& shape :
       {Shape{FootMode::rectangle, 20, 0, 0}, Shape{FootMode::halfEllipse, 20, 0, 0},
        Shape{FootMode::ellipse, 10, -10, 0}, Shape{FootMode::oval, 20, 0, 10},
        Shape{FootMode::freeFormQuad, 15, 0, 0}}) {
    double highest = 0, deepest = 0, ahead = 0, behind = 0;
    for (const auto& point : cycle({walkWith(shape.mode), Leg::foreRight})) {
      highest = std::max(highest, point.height);
      deepest = std::min(deepest, point.height);
      ahead = std::max(ahead, point.beyond);
      behind = std::min(behind, point.beyond);
    }
    EXPECT_NEAR(highest, shape.highest, 0.01) << static_cast<int>(shape.mode);
    EXPECT_NEAR(deepest, shape.deepest, 0.01) << static_cast<int>(shape.mode);
    EXPECT_NEAR(ahead, shape.beyond, 0.1) << static_cast<int>(shape.mode);
    EXPECT_NEAR(behind, -shape.beyond, 0.1) << static_cast<int>(shape.mode);
  }
  // An ellipse is one: every point has the same distance from its middle in its own units.
  const FootPath path{walkWith(FootMode::ellipse), Leg::hindRight};
  for (const auto& point : cycle(path))
    EXPECT_NEAR(std::hypot(point.along, point.height / 15), 1, 1e-9);
}

/// Lifting and lowering take as long as their phases, in every mode (figure 3.22).
TEST(FootPath, LiftAndLoweringPhasesTimeTheFlight) {
  for (const auto mode : modes) {
    WalkParameters walk = walkWith(mode);
    const FootPath path{walk, Leg::foreLeft};
    // At the end of lifting the foot is where the next part begins, and likewise when lowered.
    const auto lifted = path.at(walk.foreLiftPhase), lowers = path.at(0.4 - walk.foreLoweringPhase);
    walk.foreLiftPhase = 0.2;
    walk.foreLoweringPhase = 0.15;
    const FootPath slower{walk, Leg::foreLeft};
    EXPECT_NEAR(slower.at(0.2).along, lifted.along, 1e-6);
    EXPECT_NEAR(slower.at(0.2).height, lifted.height, 1e-6);
    EXPECT_NEAR(slower.at(0.25).along, lowers.along, 1e-6);
    EXPECT_NEAR(slower.at(0.25).height, lowers.height, 1e-6);
    EXPECT_LT(slower.at(0.05).height, path.at(0.05).height);
  }
}

TEST(FootPath, PhasesThatAreTooLongAreShortenedAlike) {
  WalkParameters walk = walkWith(FootMode::rectangle);
  walk.foreLiftPhase = 0.4;
  walk.foreLoweringPhase = 0.2;
  const FootPath path{walk, Leg::foreLeft};
  // A tenth of 0.4 is left for the way ahead.
  EXPECT_NEAR(path.at(0.24).height, 20, 0.01);
  EXPECT_NEAR(path.at(0.12).height, 10, 0.01);
  EXPECT_NEAR(path.at(0.28).height, 20, 0.01);
  EXPECT_NEAR(path.at(0.34).height, 10, 0.01);
}

TEST(FootPath, AQuadrupleHasItsCorners) {
  WalkParameters walk = walkWith(FootMode::freeFormQuad);
  walk.foreFreeFormQuadPos = {Vector3d{0.8, 1, -2}, Vector3d{-1, 2, -3}, Vector3d{-1.5, 9, 25},
                              Vector3d{1.2, 8, 18}};
  const FootPath path{walk, Leg::foreLeft};
  const std::array phases{0.4, 1 - 1e-9, 0.1, 0.34};
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const auto point = path.at(phases[i]);
    const Vector3d corner = walk.foreFreeFormQuadPos[i];
    EXPECT_NEAR(point.along, corner.x(), 1e-6) << i;
    EXPECT_NEAR(point.aside, corner.y(), 1e-6) << i;
    EXPECT_NEAR(point.height, corner.z(), 1e-6) << i;
  }
}

TEST(FootPath, ForeAndHindLegsHaveTheirOwn) {
  WalkParameters walk = walkWith(FootMode::rectangle);
  walk.hindGroundPhase = 0.7;
  EXPECT_DOUBLE_EQ((FootPath{walk, Leg::foreRight}.airPhase()), 0.4);
  EXPECT_DOUBLE_EQ((FootPath{walk, Leg::hindRight}.airPhase()), 1 - 0.7);
  EXPECT_NEAR((FootPath{walk, Leg::foreRight}.at(0.2).height), 20, 1e-9);
  EXPECT_NEAR((FootPath{walk, Leg::hindRight}.at(0.15).height), 30, 1e-9);
}

}  // namespace
}  // namespace gt
