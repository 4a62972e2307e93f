#include "simulation/camera/MotionBlur.h"

#include <gtest/gtest.h>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

/// How many pixels of the middle row are neither as bright as the first nor as dark as the last.
int rampOf(const Image& image) {
  const int row = image.info.height / 2;
  const int bright = image.at(0, row).y, dark = image.at(image.info.width - 1, row).y;
  int between = 0;
  for (int x = 0; x < image.info.width; ++x) {
    const int y = image.at(x, row).y;
    between += y > dark + 1 && y < bright - 1 ? 1 : 0;
  }
  return between;
}

TEST(MotionBlur, SmearsAnEdgeByTheWayThatItGoesWhileARowIsExposed) {
  const TestWorld world =
      TestWorld::fromBodies(R"(<geom type="box" size="0.1 1 2" pos="2 1 0" rgba="1 1 1 1"/>)");
  constexpr double speed = 2;  // rad/s
  CameraView view = viewFrom({0, 0, 0});
  CameraEffects effects = CameraEffects::none();
  effects.exposure = 10;
  const Image standing = world.picture(view, effects);
  EXPECT_EQ(rampOf(standing), 0);
  const double duration = (view.info.height - 1) * view.info.rowTime / 1000;
  view.first.rotation = rotationZ(-speed * duration / 2);
  view.last.rotation = rotationZ(speed * duration / 2);
  EXPECT_EQ(rampOf(world.picture(view, CameraEffects::none())), 0);
  for (const double exposure : {5.0, 10.0, 20.0, 40.0}) {
    effects.exposure = exposure;
    ImageTruth truth, sharp;
    const Image image = world.picture(view, effects, &truth);
    EXPECT_NEAR(rampOf(image), view.info.focalX * speed * exposure / 1000, 1.6) << exposure;
    world.picture(view, CameraEffects::none(), &sharp);
    EXPECT_EQ(truth.geoms, sharp.geoms) << "the truth stays sharp";
  }
}

}  // namespace
}  // namespace gt
