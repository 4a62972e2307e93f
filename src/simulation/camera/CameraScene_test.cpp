#include "simulation/camera/CameraScene.h"

#include <gtest/gtest.h>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

/// Report 5.1.2: parts of the scene can be hidden.
TEST(CameraScene, ViewsLeaveOutWhatIsAboveTheirDetailLevel) {
  TestWorld world = TestWorld::fromBodies(
      R"(<geom name="house" size="1"/><geom name="door" size="0.2" user="3"/>
         <geom name="handle" size="0.01" user="7"/>)");
  const auto shapes = [&](int detail) {
    return CameraScene{world.model(), {0.5f, 0.5f, 0.5f}, detail}.shapes().size();
  };
  EXPECT_EQ(shapes(0), 1u);
  EXPECT_EQ(shapes(3), 2u);
  EXPECT_EQ(shapes(6), 2u);
  EXPECT_EQ(shapes(CameraScene::mostDetail), 3u);
}

TEST(CameraScene, ColorsHaveTheClassesThatPeopleGiveThem) {
  EXPECT_EQ(classOfRgb({1, 0.5f, 0}), ColorClass::orange);
  EXPECT_EQ(classOfRgb({0.98f, 0.36f, 0.03f}), ColorClass::orange);
  EXPECT_EQ(classOfRgb({0.93f, 0.82f, 0.06f}), ColorClass::yellow);
  EXPECT_EQ(classOfRgb({0.16f, 0.62f, 0.92f}), ColorClass::skyblue);
  EXPECT_EQ(classOfRgb({0.96f, 0.32f, 0.62f}), ColorClass::pink);
  EXPECT_EQ(classOfRgb({0.72f, 0.05f, 0.1f}), ColorClass::red);
  EXPECT_EQ(classOfRgb({0.07f, 0.11f, 0.48f}), ColorClass::blue);
  EXPECT_EQ(classOfRgb({0.05f, 0.45f, 0.2f}), ColorClass::green);
  EXPECT_EQ(classOfRgb({0.47f, 0.47f, 0.49f}), ColorClass::gray);
  EXPECT_EQ(classOfRgb({0.9f, 0.9f, 0.9f}), ColorClass::white);
  EXPECT_EQ(classOfRgb({0.06f, 0.06f, 0.07f}), ColorClass::black);
}

TEST(CameraScene, ColorsAreFullRangeYcbcr) {
  const auto expect = [](const Eigen::Vector3f& rgb, int y, int cb, int cr) {
    const PackedColor color = packColor(rgb, ColorClass::pink);
    EXPECT_NEAR(color & 255, y, 1);
    EXPECT_NEAR(color >> 8 & 255, cb, 1);
    EXPECT_NEAR(color >> 16 & 255, cr, 1);
    EXPECT_EQ(color >> 24, static_cast<PackedColor>(ColorClass::pink));
  };
  expect({1, 1, 1}, 255, 128, 128);
  expect({0, 0, 0}, 0, 128, 128);
  expect({1, 0, 0}, 76, 85, 255);
  expect({0, 0, 1}, 29, 255, 107);
}

TEST(CameraScene, MaterialsAreNamedByTheirClass) {
  TestWorld world = TestWorld::fromBodies(R"(
      <geom name="a" size="1" material="red1/blue.dark"/>
      <geom name="b" size="1" material="paint"/>
      <geom name="c" size="1" rgba="0 1 0 1"/>
      <geom name="d" size="1" rgba="0 1 0 0.2"/>
      <geom name="e" size="1" group="5"/>)",
                                          R"(<material name="red1/blue.dark" rgba="1 1 1 1"/>
                                             <material name="paint" rgba="1 1 1 1"/>)");
  const CameraScene& scene = world.scene();
  EXPECT_EQ(scene.classOf(world.geom("a")), ColorClass::blue);
  EXPECT_EQ(scene.classOf(world.geom("b")), ColorClass::white);
  EXPECT_EQ(scene.classOf(world.geom("c")), ColorClass::green);
  EXPECT_EQ(scene.classOf(world.geom("d")), ColorClass::noColor);
  EXPECT_EQ(scene.classOf(world.geom("e")), ColorClass::noColor);
  EXPECT_EQ(scene.shapes().size(), 3u);
}

TEST(CameraScene, AClusterReachesAsFarAsItsRobot) {
  TestWorld world = TestWorld::fromFile("models/ers210.xml");
  ASSERT_EQ(world.scene().clusters().size(), 1u);
  const CameraCluster& robot = world.scene().clusters().front();
  EXPECT_LT(robot.reach, 0.5);
  Random random{4};
  for (int i = 0; i < 200; ++i) {
    for (int q = 7; q < world.model().nq; ++q) world.data().qpos[q] = random.uniform(-2, 2);
    mj_forward(&world.model(), &world.data());
    const Eigen::Vector3d root{world.data().xpos + 3 * robot.body};
    for (const CameraShape& shape : world.scene().shapes()) {
      const Eigen::Vector3d at{world.data().geom_xpos + 3 * shape.geom};
      EXPECT_LE((at - root).norm() + static_cast<double>(shape.reach),
                static_cast<double>(robot.reach) + 1e-5);
    }
  }
}

}  // namespace
}  // namespace gt
