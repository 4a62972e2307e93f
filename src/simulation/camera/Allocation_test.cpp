#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "simulation/camera/TestWorld.h"

namespace {
std::atomic<int> allocations{0};
}

// Counts what the whole program takes from the heap.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  std::abort();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
// Not inlined: gcc would take free() for the wrong match of an operator new that it did not inline.
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace gt {
namespace {

TEST(CameraRenderer, AllocatesNothingFromTheSecondPictureOn) {
  TestWorld world = TestWorld::fromFile("models/field2003.xml");
  CameraRenderer renderer{world.scene()};
  Image image;
  PictureTruth truth;
  Random random{11};
  const auto take = [&] {
    CameraView view = viewFrom({random.uniform(-2000, 2000), random.uniform(-1300, 1300), 200},
                               random.uniform(-pi, pi), -0.2);
    view.first.rotation = view.first.rotation * rotationZ(0.05);
    renderer.render(world.data(), view, {}, 1, image, &truth);
  };
  take();
  const int before = allocations;
  for (int i = 0; i < 50; ++i) take();
  EXPECT_EQ(allocations, before);
  image.pixels.push_back({});
  image.pixels.shrink_to_fit();
  EXPECT_GT(allocations, before) << "the counter does not count";
}

}  // namespace
}  // namespace gt
