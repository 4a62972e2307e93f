#include "simulation/camera/Lighting.h"

#include <gtest/gtest.h>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

constexpr const char* floorAndBall = R"(
  <geom name="floor" type="plane" size="5 5 1" rgba="0.5 0.5 0.5 1"/>
  <geom name="ball" type="sphere" size="0.1" pos="1 0 0.3" group="4" rgba="1 1 1 1"/>)";

TestWorld litBy(const std::string& light) {
  TestWorld world = TestWorld::fromBodies(floorAndBall + light);
  for (float& ambient : world.model().vis.headlight.ambient) ambient = 0.2f;
  return world;
}

int brightness(const TestWorld& world, const Lighting& lighting, const mjData& data,
               const Vector3d& at, bool shadows = true) {
  const Vector3d from = at + Vector3d{0.01, 0, 0.05};
  const RayHit hit = lighting.cast(data, from, (at - from).normalized(), -1);
  EXPECT_EQ(hit.geom, world.geom("floor"));
  return static_cast<int>(lighting.color(data, hit, ColorClass::gray, shadows) & 0xff);
}

TEST(Lighting, RaysMeetTheNearestSurface) {
  auto world = litBy("");
  const Lighting lighting{world.model()};
  const RayHit hit = lighting.cast(world.data(), {0, 0, 0.3}, {1, 0, 0}, -1);
  EXPECT_EQ(hit.geom, world.geom("ball"));
  EXPECT_NEAR(hit.distance, 0.9, 1e-9);
  EXPECT_NEAR(hit.normal.x(), -1, 1e-9);
  EXPECT_EQ(lighting.cast(world.data(), {0, 0, 0.3}, {0, 0, 1}, -1).geom, -1);
}

TEST(Lighting, NormalsPointOutOfEveryForm) {
  auto world = TestWorld::fromBodies(R"(
    <geom name="box" type="box" size="0.1 0.2 0.3" pos="0 0 1"/>
    <geom name="cylinder" type="cylinder" size="0.1 0.2" pos="0 2 1"/>
    <geom name="capsule" type="capsule" size="0.1 0.2" pos="0 4 1"/>
    <geom name="ellipsoid" type="ellipsoid" size="0.1 0.2 0.3" pos="0 6 1"/>)");
  const Lighting lighting{world.model()};
  for (int i = 0; i < 4; ++i) {
    const Vector3d center{0, 2. * i, 1};
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d to = Vector3d::Unit(axis);
      const RayHit hit = lighting.cast(world.data(), center + 0.9 * to, -to, -1);
      ASSERT_EQ(hit.geom, i);
      EXPECT_NEAR(hit.normal.dot(to), 1, 1e-6) << i << ' ' << axis;
    }
  }
}

TEST(Lighting, AmbientRadiationReachesAll) {
  auto world = litBy("");
  const Lighting lighting{world.model()};
  EXPECT_NEAR(brightness(world, lighting, world.data(), {1, 0, 0}), 0.2 * 0.5 * 255, 1);
  EXPECT_NEAR(brightness(world, lighting, world.data(), {-2, 1, 0}), 0.2 * 0.5 * 255, 1);
}

TEST(Lighting, RadialEmittersFadeWithTheAngleAndTheDistance) {
  auto world = litBy(R"(<light pos="0 0 1" dir="0 0 -1" cutoff="180" attenuation="0 0 1"
                                diffuse="0.8 0.8 0.8"/>)");
  const Lighting lighting{world.model()};
  for (const double x : {0., 0.5, 2., -1.5}) {
    const double squared = 1 + x * x;
    const double expected = 0.2 + 0.8 / squared / std::sqrt(squared);
    EXPECT_NEAR(brightness(world, lighting, world.data(), {x, 0, 0}, false), expected * 127.5, 1.5)
        << x;
  }
}

TEST(Lighting, SpotEmittersHaveACone) {
  auto world = litBy(R"(<light pos="0 0 1" dir="0 0 -1" cutoff="30" exponent="2"
                                diffuse="0.8 0.8 0.8" attenuation="1 0 0"/>)");
  const Lighting lighting{world.model()};
  const double x = std::tan(fromDegrees(25)), cosine = std::cos(fromDegrees(25));
  EXPECT_NEAR(brightness(world, lighting, world.data(), {x, 0, 0}),
              (0.2 + 0.8 * cosine * cosine * cosine) * 127.5, 1.5);
  EXPECT_NEAR(brightness(world, lighting, world.data(), {std::tan(fromDegrees(31)), 0, 0}), 25.5,
              1);
}

TEST(Lighting, ShadowsLieBehindThings) {
  auto world = litBy(R"(<light pos="1 0 2" dir="0 0 -1" directional="true"
                                diffuse="0.6 0.6 0.6"/>)");
  const Lighting lighting{world.model()};
  EXPECT_NEAR(brightness(world, lighting, world.data(), {1, 0, 0}), 25.5, 1);
  EXPECT_NEAR(brightness(world, lighting, world.data(), {1, 0, 0}, false), 102, 1);
  EXPECT_NEAR(brightness(world, lighting, world.data(), {1.12, 0, 0}), 102, 1);
}

TEST(Lighting, ImagesAreShadedPixelByPixel) {
  auto world = litBy(R"(<light pos="1 0 2" dir="0 0 -1" directional="true"
                                diffuse="0.6 0.6 0.6"/>)");
  CameraEffects effects = CameraEffects::none();
  effects.pixelShading = effects.shadows = true;
  const CameraView view = viewFrom({-500, 0, 700}, 0, -0.45);
  ImageTruth truth;
  const Image image = world.picture(view, effects, &truth);
  const Vector2d shadow = seenAt(view, {1000, 0, 0}), light = seenAt(view, {600, 0, 0});
  const auto at = [&](const Vector2d& p) {
    return image.at(static_cast<int>(p.x()), static_cast<int>(p.y())).y;
  };
  EXPECT_NEAR(at(shadow), 25.5, 2);
  EXPECT_NEAR(at(light), 102, 2);
  // The ball is bright on top, dark below.
  EXPECT_GT(at(seenAt(view, {960, 0, 390})), at(seenAt(view, {905, 0, 280})) + 60);
  const Image flat = world.picture(view);
  EXPECT_EQ(flat.at(20, 140).y, flat.at(150, 140).y);
  EXPECT_NE(flat.at(20, 140).y, image.at(20, 140).y);
}

TEST(Facette, AllAnglesBetweenPixelsAreTheSame) {
  auto world = litBy("");
  const Lighting lighting{world.model()};
  Facette facette{360, 180, 2 * pi, pi};
  Image image;
  facette.take(lighting, world.scene(), world.data(), {Matrix3d::Identity(), {0, 0, 300}}, -1,
               false, image);
  ASSERT_EQ(image.pixels.size(), 360u * 180u);
  // The ball, seen under 11.5 degrees straight ahead.
  int wide = 0, high = 0;
  const int ball = image.at(180, 90).y;
  for (int x = 0; x < 360; ++x) wide += image.at(x, 90).y == ball;
  for (int y = 0; y < 180; ++y) high += image.at(180, y).y == ball;
  EXPECT_NEAR(wide, 2 * toDegrees(std::asin(0.1)), 1.1);
  EXPECT_NEAR(high, 2 * toDegrees(std::asin(0.1)), 1.1);
  EXPECT_NEAR(image.at(10, 179).y, 25.5, 1);  // the floor below
  EXPECT_NE(image.at(10, 2).y, image.at(10, 177).y);
}

}  // namespace
}  // namespace gt
