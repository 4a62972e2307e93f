#include "modules/modeling/obstacles/DefaultObstaclesLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/OracledLocators.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

/// The free distance in the sector of a direction, in mm.
double freeDistance(const ObstaclesModel& model, double degrees) {
  const auto sector = static_cast<std::size_t>(ObstaclesModel::sectorOf(fromDegrees(degrees)));
  const auto& [place, obstacle, seen] = model.sectors[sector];
  return obstacle ? std::min(place.norm(), ObstaclesModel::farAway) : ObstaclesModel::farAway;
}

struct Radar {
  /// An image: free from the near to the far point of each line.
  void see(std::vector<FreeGround> lines) {
    percept.lines = std::move(lines);
    percept.time = frame.time = frame.time + 40;
    update();
  }
  void walk(const Pose2D& step) {
    frame.time = frame.time + 40;
    odometry.pose = odometry.pose * step;
    update();
  }
  void update() {
    locator.update(percept, psd, landmarks, ball, camera, odometry, frame, model, debug);
  }
  double at(double degrees) const { return freeDistance(model, degrees); }

  DefaultObstaclesLocator locator;
  ObstaclesPercept percept;
  PsdPercept psd;
  LandmarksPercept landmarks;
  BallModel ball;
  CameraMatrix camera;
  OdometryData odometry;
  FrameInfo frame;
  ObstaclesModel model;
  Debug debug{1024};
};

constexpr double nothing = ObstaclesModel::farAway;

TEST(DefaultObstaclesLocator, KeepsTheMeasurementOfEachSector) {
  Radar radar;
  radar.see({{{200, 1}, {700, 1}, false}, {{0, 200}, {0, 900}, true}});
  EXPECT_NEAR(radar.at(0), 700, 1);
  EXPECT_EQ(radar.at(90), nothing) << "the image's border is no obstacle";
  const auto& left =
      radar.model.sectors[static_cast<std::size_t>(ObstaclesModel::sectorOf(pi / 2))];
  EXPECT_EQ(left.representative, Vector2d(0, 900));
  EXPECT_EQ(left.lastSeen, radar.percept.time);
  EXPECT_EQ(radar.at(180), nothing);
}

TEST(DefaultObstaclesLocator, IsTheMoreCautiousTheFartherAway) {
  Radar radar;
  radar.camera.pose.translation.z() = 200;
  for (const double distance : {500., 1000., 1500.}) {
    radar.see({{{200, 1}, {distance, 1}, false}});
    const double pixels = distance * distance / 200 * radar.locator.parameters.caution;
    EXPECT_NEAR(radar.at(0), distance - pixels, 0.1 * distance * distance / 1e4);
  }
  radar.see({{{600, 1}, {600, 1}, false}});
  EXPECT_NEAR(radar.at(0), 600, 1) << "nothing is seen to be free there";
}

// Figure 3.13: what is nearer than the image's lower border stays; what lies where the ground is
// seen to be free, or behind the obstacle that is seen, gives way to it.
TEST(DefaultObstaclesLocator, NewMeasurementsReplaceAllButWhatIsTooNearToBeSeen) {
  for (const auto& [stored, expected] :
       {std::pair{150., 150.}, std::pair{400., 700.}, std::pair{1200., 700.}}) {
    Radar radar;
    radar.see({{{100, 1}, {stored, 1}, false}});
    ASSERT_NEAR(radar.at(0), stored, 1);
    radar.see({{{300, 1}, {700, 1}, false}});
    EXPECT_NEAR(radar.at(0), expected, 1) << stored;
  }
}

TEST(DefaultObstaclesLocator, FreeGroundTakesObstaclesAway) {
  Radar radar;
  radar.see({{{100, 1}, {500, 1}, false}});
  radar.see({{{300, 1}, {900, 1}, true}});
  EXPECT_EQ(radar.at(0), nothing);
  radar.see({{{100, 1}, {1500, 1}, false}});
  radar.see({{{300, 1}, {900, 1}, true}});
  EXPECT_NEAR(radar.at(0), 1500, 1) << "further away than was seen";
}

TEST(DefaultObstaclesLocator, TheNearestLineOfASectorCounts) {
  Radar radar;
  radar.see(
      {{{100, 5}, {900, 5}, false}, {{100, 10}, {600, 10}, false}, {{100, 7}, {800, 7}, true}});
  EXPECT_NEAR(radar.at(1), 600, 1);
}

TEST(DefaultObstaclesLocator, OdometryMovesTheRepresentatives) {
  Radar radar;
  radar.see({{{100, 1}, {1000, 1}, false}});
  for (int i = 0; i < 20; ++i) radar.walk({0, 10, 0});
  EXPECT_NEAR(radar.at(0), 800, 1);
  radar.walk({pi / 2, 0, 0});
  EXPECT_NEAR(radar.at(-90), 800, 1);
  EXPECT_EQ(radar.at(0), nothing);
}

// Report 3.5.2: the nearer one is used, the other is discarded, and there is one less.
TEST(DefaultObstaclesLocator, TwoRepresentativesInOneSectorBecomeTheNearer) {
  Radar radar;
  radar.see({{{100, 30}, {800, 30}, false}, {{100, -30}, {1000, -50}, false}});
  ASSERT_NEAR(radar.at(2), 800, 1);
  ASSERT_NEAR(radar.at(-2), 1001, 1);
  radar.walk({fromDegrees(-0.1), -600, 0});
  int obstacles = 0;
  for (const auto& sector : radar.model.sectors) obstacles += sector.obstacle;
  EXPECT_LE(obstacles, 2);
  radar.walk({0, -6000, 0});  // So far away that both lie straight ahead.
  radar.walk({fromDegrees(-1.5), 0, 0});
  obstacles = 0;
  for (const auto& sector : radar.model.sectors) obstacles += sector.obstacle;
  EXPECT_EQ(obstacles, 1);
}

TEST(DefaultObstaclesLocator, ForgetsWhatItDoesNotSeeAnyMore) {
  Radar radar;
  radar.see({{{100, 1}, {1000, 1}, false}});
  for (int i = 0; i < radar.locator.parameters.forgetAfter / 40; ++i) radar.walk({});
  EXPECT_NEAR(radar.at(0), 1000, 1);
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing);
}

TEST(DefaultObstaclesLocator, TheBallIsNoObstacle) {
  Radar radar;
  radar.ball.position = {600, 0};
  radar.ball.lastSeen = radar.frame.time + 40;
  radar.see({{{200, 1}, {560, 1}, false}, {{200, 100}, {560, 300}, false}});
  EXPECT_EQ(radar.at(0), nothing);
  EXPECT_LT(radar.at(29), 700) << "what stands beside it is";
}

TEST(DefaultObstaclesLocator, TheDistanceSensorCountsIfItShall) {
  Radar radar;
  radar.camera.valid = true;
  radar.camera.pose.translation = {150, 0, 200};
  radar.psd = {Time{40}, {600, 0, 150}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing);
  radar.locator.parameters.usePsd = true;
  radar.psd.time = Time{80};
  radar.walk({});
  EXPECT_NEAR(radar.at(0), 600, 1);
  // It looks over what is low, so it does not take obstacles away that are nearer...
  radar.psd = {Time{120}, {900, 0, 150}, false};
  radar.walk({});
  EXPECT_NEAR(radar.at(0), 600, 1);
  // ... but where its ray is low it does; the ground is no obstacle.
  radar.psd = {Time{160}, {900, 0, 0}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing);
  radar.psd = {Time{200}, {700, 0, 500}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing) << "above all robots";
}

TEST(DefaultObstaclesLocator, AReflectionOfTheDistanceSensorIsNoObstacle) {
  Radar radar;
  radar.camera.valid = true;
  radar.camera.pose.translation = {150, 0, 200};
  radar.psd = {Time{40}, {600, 0, 150}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing);
  radar.locator.parameters.usePsd = true;
  radar.locator.parameters.psdAgreement = 150;
  radar.psd = {Time{80}, {600, 0, 150}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing) << "one reading";
  radar.psd = {Time{120}, {300, 0, 150}, false};
  radar.walk({});
  EXPECT_EQ(radar.at(0), nothing) << "and another one";
  radar.psd = {Time{160}, {310, 0, 150}, false};
  radar.walk({});
  EXPECT_NEAR(radar.at(0), 310, 1);
}

TEST(DefaultObstaclesLocator, RemembersTheFreePartOfTheGoal) {
  Radar radar;
  radar.landmarks.time = Time{40};
  radar.landmarks.numberOfGoals = 1;
  GoalPercept& goal = radar.landmarks.goals[0];
  goal.color = GoalColor::skyblue;
  goal.distance = 1000;
  goal.boundary.left = 0.3;
  goal.boundary.right = 0.1;
  radar.walk({});
  const auto& seen = radar.model.goals[GoalColor::skyblue];
  EXPECT_NEAR(angleOf(seen.left), 0.3, 1e-9);
  EXPECT_NEAR(angleOf(seen.right), 0.1, 1e-9);
  // The camera turns on: the left edge leaves the image, but is where it was.
  radar.landmarks.time = Time{80};
  goal.boundary = {0.2, -0.1, 0, 0, true, false, false, false};
  radar.walk({});
  EXPECT_NEAR(angleOf(seen.left), 0.3, 1e-9);
  EXPECT_NEAR(angleOf(seen.right), -0.1, 1e-9);
  radar.walk({0.3, 0, 0});
  EXPECT_NEAR(angleOf(seen.left), 0, 1e-9);
  EXPECT_EQ(radar.model.goals[GoalColor::yellow].lastSeen, never());
}

TEST(DefaultObstaclesLocator, AllocatesNothing) {
  Radar radar;
  radar.see({{{200, 1}, {700, 1}, false}, {{0, 200}, {0, 900}, true}});
  const auto before = allocations();
  for (int i = 0; i < 10; ++i) {
    radar.percept.time = radar.percept.time + 40;
    radar.walk({0.1, 10, 0});
  }
  EXPECT_EQ(allocations(), before);
}

TEST(OracledObstaclesLocator, MeasuresRobotsAndWalls) {
  OracledWorldState oracle;
  oracle.robotPose = {pi / 2, 0, 0};
  oracle.others = {{TeamColor::blue, 1, {0, 0, 600}}};
  ObstaclesModel model;
  OracledObstaclesLocator{}.update(oracle, {}, {}, model);
  const auto at = [&](double degrees) { return freeDistance(model, degrees + 1); };
  EXPECT_NEAR(at(0), 540, 15) << "where its two discs meet";
  EXPECT_NEAR(at(180), 1350, 5);
  EXPECT_EQ(at(90), nothing) << "the goal is farther away";
}

}  // namespace
}  // namespace gt
