#include <gtest/gtest.h>

#include "simulation/camera/TestWorld.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

TEST(CameraRenderer, AllocatesNothingFromTheSecondImageOn) {
  TestWorld world = TestWorld::fromFile("models/field2003.xml");
  CameraRenderer renderer{world.scene()};
  Image image;
  ImageTruth truth;
  Random random{11};
  const auto take = [&] {
    CameraView view = viewFrom({random.uniform(-2000, 2000), random.uniform(-1300, 1300), 200},
                               random.uniform(-pi, pi), -0.2);
    view.first.rotation = view.first.rotation * rotationZ(0.05);
    renderer.render(world.data(), view, {}, 1, image, &truth);
  };
  take();
  const long before = allocations();
  for (int i = 0; i < 50; ++i) take();
  EXPECT_EQ(allocations(), before);
  image.pixels.push_back({});
  image.pixels.shrink_to_fit();
  EXPECT_GT(allocations(), before) << "the counter does not count";
}

}  // namespace
}  // namespace gt
