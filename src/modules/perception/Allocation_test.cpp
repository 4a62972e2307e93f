#include <gtest/gtest.h>

#include <vector>

#include "base/Random.h"
#include "base/TestAllocations.h"
#include "modules/perception/GT2003ImageProcessor.h"

namespace gt {
namespace {

// Pictures full of colours make the lists as long as they get; then they keep their memory.
TEST(GT2003ImageProcessor, AllocatesNothingOnceItsListsHaveGrown) {
  Random random{1};
  ColorTable64 colors;
  for (ColorClass& c : colors.classes)
    c = static_cast<ColorClass>(random.index(enumCount<ColorClass>));
  Image image;
  image.allocate();
  std::vector<Pixel> patches(16);
  for (Pixel& p : patches)
    p = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
         static_cast<std::uint8_t>(random()), 0};
  CameraMatrix matrix;
  matrix.pose.translation.z() = 170;
  matrix.valid = true;
  const FieldDimensions field;
  GT2003ImageProcessor processor;
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  ObstaclesPercept obstacles;
  Debug debug;
  const auto look = [&](std::uint64_t seed) {
    Random own{seed};
    Pixel pixel;
    for (Pixel& p : image.pixels) {
      if (own.chance(0.2)) pixel = patches[own.index(patches.size())];
      p = pixel;
    }
    matrix.pose.rotation = rotationY(own.uniform(-0.5, 0.5)) * rotationX(own.uniform(-0.3, 0.3));
    processor.update(image, matrix, colors, field, ball, landmarks, lines, players, obstacles,
                     debug);
  };
  for (std::uint64_t seed = 0; seed < 50; ++seed) look(seed);
  const long before = allocations();
  for (std::uint64_t seed = 0; seed < 50; ++seed) look(seed);
  EXPECT_EQ(allocations(), before);
  patches.push_back({});
  EXPECT_GT(allocations(), before) << "the counter does not count";
}

}  // namespace
}  // namespace gt
