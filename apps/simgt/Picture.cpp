#include "Picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "streams/Jpeg.h"

namespace gt {
namespace {

/// A pixel of the picture is the mean of so many pixels of the camera's in each direction: smooth
/// edges.
constexpr int fineness = 3;

int fail(const Error& error) {
  fmt::print(stderr, "simgt: {}\n", error.text());
  return 2;
}

CameraView viewOf(const PictureOptions& options) {
  const Vector3d from{options.from[0], options.from[1], options.from[2]};
  const Vector3d ahead = Vector3d{options.at[0], options.at[1], options.at[2]} - from;
  Pose3D pose;
  pose.translation = from;
  pose.rotation = rotationZ(std::atan2(ahead.y(), ahead.x())) *
                  rotationY(-std::atan2(ahead.z(), ahead.head<2>().norm()));
  CameraView view;
  view.first = view.last = pose;
  view.info.width = options.width * fineness;
  view.info.height = options.height * fineness;
  view.info.focalX = view.info.focalY =
      view.info.width / (2 * std::tan(fromDegrees(options.openingAngle) / 2));
  view.info.centerX = view.info.width / 2.0;
  view.info.centerY = view.info.height / 2.0;
  return view;
}

/// Full-range YCbCr (JFIF) as RGB, the mean of a square of pixels.
std::array<std::uint8_t, 3> meanColor(const Image& image, int left, int top) {
  double y = 0, cb = 0, cr = 0;
  for (int row = top; row < top + fineness; ++row)
    for (int column = left; column < left + fineness; ++column) {
      const Pixel& pixel = image.at(column, row);
      y += pixel.y;
      cb += pixel.cb - 128.0;
      cr += pixel.cr - 128.0;
    }
  const auto byte = [](double sum) {
    return static_cast<std::uint8_t>(
        std::lround(std::clamp(sum / (fineness * fineness), 0.0, 255.0)));
  };
  return {byte(y + 1.402 * cr), byte(y - 0.344136 * cb - 0.714136 * cr), byte(y + 1.772 * cb)};
}

std::vector<std::uint8_t> reduced(const Image& image) {
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < image.info.height; y += fineness)
    for (int x = 0; x < image.info.width; x += fineness) {
      const auto color = meanColor(image, x, y);
      rgb.insert(rgb.end(), color.begin(), color.end());
    }
  return rgb;
}

}  // namespace

int takePicture(const PictureOptions& options) {
  auto match = Match::make(options.match);
  if (!match) return fail(match.error());
  while (static_cast<double>((*match)->time().ms) < options.time * 1000 && !(*match)->finished())
    (*match)->step();

  const World& world = (*match)->simulation().world();
  const CameraScene scene{world.model()};
  Image image;
  CameraRenderer{scene}.render(world.data(), viewOf(options), CameraEffects::none(), 0, image);

  std::error_code ignored;  // then writing the file tells what is wrong
  std::filesystem::create_directories(std::filesystem::path{options.out}.parent_path(), ignored);
  if (const auto done = writePng(options.out, options.width, options.height, reduced(image)); !done)
    return fail(done.error());
  fmt::print("Picture: {}\n", options.out);
  return 0;
}

}  // namespace gt
