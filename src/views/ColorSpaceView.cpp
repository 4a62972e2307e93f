#include <algorithm>
#include <array>
#include <cmath>

#include "views/Views.h"

namespace gt {
namespace {

/// The share of pixels at each pair of a channel's values (64 each): a height map from above.
RgbImage heightMap(const Image& image, int xChannel, int yChannel) {
  constexpr int size = 64;
  std::array<int, size * size> counts{};
  const auto channel = [](const Pixel& p, int i) { return i == 0 ? p.y : i == 1 ? p.cb : p.cr; };
  for (const Pixel& p : image.pixels)
    ++counts[static_cast<std::size_t>((size - 1 - channel(p, yChannel) / 4) * size +
                                      channel(p, xChannel) / 4)];
  const double most = std::log1p(*std::ranges::max_element(counts));
  RgbImage map{size, size, {}};
  for (const int count : counts) {
    const double height = most > 0 ? std::log1p(count) / most : 0;
    map.pixels.push_back(static_cast<std::uint8_t>(255 * std::min(1.0, 2 * height)));
    map.pixels.push_back(static_cast<std::uint8_t>(255 * std::max(0.0, 2 * height - 1)));
    map.pixels.push_back(static_cast<std::uint8_t>(80 * height));
  }
  return map;
}

class ColorSpaceView : public View {
 public:
  ColorSpaceView() : View{"colorSpace", "how the image uses the color space"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto image = (*robot)->value<Image>();
    if (!image) return image.error();
    constexpr double size = 256, gap = 40;
    Sheet sheet{static_cast<int>(3 * size + 4 * gap), static_cast<int>(size + 2 * gap)};
    constexpr std::array names{"y", "u", "v"};
    constexpr std::array<std::pair<int, int>, 3> planes{{{1, 2}, {1, 0}, {2, 0}}};
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const auto [x, y] = planes[i];
      const Vector2d corner{gap + static_cast<double>(i) * (size + gap), gap};
      sheet.paint(heightMap(**image, x, y), corner, size / 64);
      sheet.text(corner + Vector2d{size / 2, size + 18}, names[static_cast<std::size_t>(x)]);
      sheet.text(corner + Vector2d{-18, size / 2}, names[static_cast<std::size_t>(y)]);
    }
    sheet.text({gap, 24},
               (*robot)->name() + ": pixels by their values, brighter where there are more");
    return sheet;
  }
};

}  // namespace

std::unique_ptr<View> makeColorSpaceView() {
  return std::make_unique<ColorSpaceView>();
}

}  // namespace gt
