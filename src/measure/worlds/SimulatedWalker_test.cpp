#include "measure/worlds/SimulatedWalker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/Simulation.h"

namespace gt {
namespace {

std::unique_ptr<SimulatedWalker> walkerIn(const WalkerWorld& world, std::uint64_t seed = 1) {
  auto walker = SimulatedWalker::make({}, seed, world);
  EXPECT_TRUE(walker) << walker.error().text();
  return *std::move(walker);
}

constexpr int imagesPerSecond = 25;

TEST(SimulatedWalker, WalksAsItIsToldAndKnowsHowFar) {
  const auto walker = walkerIn({.profile = Profile::benign, .walks = false});
  const auto run = [&](const Pose2D& speed, int seconds) {
    const Pose2D before = walker->pose, known = walker->odometry.pose;
    for (int i = 0; i < seconds * imagesPerSecond; ++i) walker->step(speed);
    const Vector2d way = relative(before, walker->pose.translation);
    const Vector2d believed = relative(known, walker->odometry.pose.translation);
    EXPECT_LT((way - believed).norm(), 60);
    return way;
  };
  walker->step({});
  EXPECT_LT(run({}, 2).norm(), 20) << "it stands";
  const Vector2d ahead = run({0, 100, 0}, 3);
  EXPECT_NEAR(ahead.x(), 300, 80);
  EXPECT_NEAR(ahead.y(), 0, 60);
  const Vector2d aside = run({0, 0, -80}, 3);
  EXPECT_NEAR(aside.y(), -240, 80);
  EXPECT_FALSE(walker->hasFallen());
}

TEST(SimulatedWalker, MakesAStepOfEachImage) {
  const auto walker = walkerIn({});
  walker->step();
  double left = 0, right = 0;
  for (int i = 0; i < 5 * imagesPerSecond; ++i) {
    const Time before = walker->percept.time;
    walker->step();
    EXPECT_EQ(walker->percept.time - before, 1000 / imagesPerSecond);
    const Vector3d ahead = walker->trueCamera.pose.rotation.col(0);
    const double pan = std::atan2(ahead.y(), ahead.x());
    left = std::max(left, pan);
    right = std::min(right, pan);
    const double apart =
        (walker->camera.pose.translation - walker->trueCamera.pose.translation).norm();
    EXPECT_LT(apart, 60);
  }
  EXPECT_GT(left, 1.2) << "it looks to both sides";
  EXPECT_LT(right, -1.2);
}

TEST(SimulatedWalker, IsDeterminedByItsSeed) {
  const auto first = walkerIn({}), same = walkerIn({}), other = walkerIn({}, 2);
  for (SimulatedWalker* walker : {first.get(), same.get(), other.get()})
    for (int i = 0; i < imagesPerSecond; ++i) walker->step();
  EXPECT_EQ(first->pose.translation, same->pose.translation);
  EXPECT_EQ(first->percept.numberOfFlags, same->percept.numberOfFlags);
  EXPECT_NE(first->pose.translation, other->pose.translation);
}

TEST(SimulatedWalker, IsKidnappedWithoutKnowing) {
  const auto walker = walkerIn({.walks = false});
  for (int i = 0; i < imagesPerSecond; ++i) walker->step();
  const Pose2D before = walker->pose, known = walker->odometry.pose;
  walker->kidnap();
  walker->step();
  EXPECT_GT((walker->pose.translation - before.translation).norm(), 200);
  EXPECT_LT((walker->odometry.pose.translation - known.translation).norm(), 20);
}

/// How often flags are seen in some seconds, and lines.
struct Seen {
  int flags = 0, points = 0;
};
Seen seenIn(const WalkerWorld& world) {
  const auto walker = walkerIn(world);
  Seen seen;
  for (int i = 0; i < 10 * imagesPerSecond; ++i) {
    walker->step();
    seen.flags += walker->percept.numberOfFlags;
    for (const auto& points : walker->lines.points) seen.points += static_cast<int>(points.size());
  }
  return seen;
}

TEST(SimulatedWalker, SeesWhatItsWorldHas) {
  const Seen all = seenIn({});
  EXPECT_GT(all.flags, 10);
  EXPECT_GT(all.points, 100);
  EXPECT_EQ(seenIn({.flags = false}).flags, 0);
  EXPECT_EQ(seenIn({.missingFlags = enumCount<FlagType>}).flags, 0);
  const Seen lost = seenIn({.lostPictures = 1});
  EXPECT_EQ(lost.flags + lost.points, 0);
}

}  // namespace
}  // namespace gt
