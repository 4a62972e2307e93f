#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/Random.h"
#include "simulation/Simulation.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr int scale = 3;

/// An image of depths in mm, row by row.
struct DepthImage {
  int width = 0, height = 0;
  std::vector<float> depths;

  float at(int x, int y) const { return depths[static_cast<std::size_t>(y * width + x)]; }
};

/// The depths in the image of a robot's camera without errors.
DepthImage depthImage(const Simulation& simulation, std::size_t robot) {
  const CameraScene scene{simulation.world().model()};
  const CameraInfo& optics = simulation.scene().optics;
  Image image;
  ImageTruth truth;
  truth.withDepths = true;
  CameraRenderer{scene}.render(simulation.world().data(),
                               cameraView(simulation.world(), robot, optics), CameraEffects::none(),
                               0, image, &truth);
  return {optics.width, optics.height, std::move(truth.depths)};
}

Pixel gray(double share) {
  return {static_cast<std::uint8_t>(std::clamp(std::lround(255 * share), 0l, 255l))};
}

Image blank(int width, int height) {
  Image image;
  image.info.width = width;
  image.info.height = height;
  image.allocate();
  return image;
}

/// The inverse depths as brightness: the nearest point is white, twice its depth is half as bright.
Image brightness(const DepthImage& depth) {
  const float nearest = *std::ranges::min_element(depth.depths);
  Image image = blank(depth.width, depth.height);
  for (std::size_t i = 0; i < depth.depths.size(); ++i)
    image.pixels[i] = gray(nearest / depth.depths[i]);
  return image;
}

/// A single image random dot stereogram: dots that both eyes see at one point of the scene are the
/// same (Thimbleby, Inglis and Witten 1994, without hidden surfaces).
Image stereogram(const DepthImage& depth) {
  constexpr int apart = 60;          // pixels between the dots of what is farthest
  constexpr double strongest = 0.4;  // share of that by which what is nearest lies closer together
  const float nearest = *std::ranges::min_element(depth.depths);
  const int width = depth.width * scale, height = depth.height * scale;
  Image image = blank(width, height);
  Random random{1};
  std::vector<int> same(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    std::iota(same.begin(), same.end(), 0);
    for (int x = 0; x < width; ++x) {
      const double inverseDepth = nearest / depth.at(x / scale, y / scale);
      const int distance = static_cast<int>(std::lround(apart * (1 - strongest * inverseDepth)));
      const int left = x - distance / 2, right = left + distance;
      if (left >= 0 && right < width) same[static_cast<std::size_t>(right)] = left;
    }
    for (int x = 0; x < width; ++x) {
      const int from = same[static_cast<std::size_t>(x)];
      image.at(x, y) = from == x ? gray(random.chance(0.5)) : image.at(from, y);
    }
  }
  return image;
}

class DepthView : public View {
 public:
  DepthView()
      : View{"depth",
             "how far away is what the robot's camera sees: near is bright; with 1 as a "
             "stereogram of random dots"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    if (!subject.simulation) return Error{.field = name(), .what = "there is no simulated scene"};
    if (numbers.size() > 1)
      return Error{.field = name(), .what = "expected no number, or 1 for a stereogram"};
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto index = subject.sceneRobot((*robot)->name());
    if (!index) return index.error();
    const DepthImage depth = depthImage(*subject.simulation, *index);
    if (!numbers.empty() && numbers[0] != 0) return imageSheet(stereogram(depth), 1);
    return imageSheet(brightness(depth), scale);
  }
};

}  // namespace

std::unique_ptr<View> makeDepthView() {
  return std::make_unique<DepthView>();
}

}  // namespace gt
