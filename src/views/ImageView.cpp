#include <algorithm>
#include <array>
#include <cmath>

#include "views/ScenePicture.h"
#include "console/Views.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/ColorTable64.h"
#include "simulation/camera/Lighting.h"
#include "views/painting/ColorClassViews.h"

namespace gt {
namespace {

constexpr int enlarged = 4;  // pixels of the page for one of the camera

/// The picture that the robot has, or an error if it has none yet.
Result<const Image*> pictureOf(ConsoleRobot& robot) {
  const Image& picture = robot.memory().picture();
  if (picture.pixels.empty() || picture.info.width <= 0 || picture.info.height <= 0)
    return Error{"", 0, robot.name(), "has no picture yet"};
  return &picture;
}

void paintImageDrawings(Sheet& sheet, ConsoleRobot& robot) {
  for (const auto& [key, drawing] : robot.memory().drawings())
    if (drawing.space == DrawingSpace::image)
      sheet.paint(drawing, {Vector2d::Zero(), enlarged, false});
}

Sheet enlargedSheet(const RgbPicture& picture) {
  Sheet sheet{picture.width * enlarged, picture.height * enlarged};
  sheet.paint(picture, {0, 0}, enlarged);
  return sheet;
}

/// The share of pixels at each pair of a channel's values (64 each): a height map from above.
RgbPicture heightMap(const Image& image, int xChannel, int yChannel) {
  constexpr int size = 64;
  std::array<int, size * size> counts{};
  const auto channel = [](const Pixel& p, int i) { return i == 0 ? p.y : i == 1 ? p.cb : p.cr; };
  for (const Pixel& p : image.pixels)
    ++counts[static_cast<std::size_t>((size - 1 - channel(p, yChannel) / 4) * size +
                                      channel(p, xChannel) / 4)];
  const double most = std::log1p(*std::ranges::max_element(counts));
  RgbPicture map{size, size, {}};
  for (const int count : counts) {
    const double height = most > 0 ? std::log1p(count) / most : 0;
    map.pixels.push_back(static_cast<std::uint8_t>(255 * std::min(1.0, 2 * height)));
    map.pixels.push_back(static_cast<std::uint8_t>(255 * std::max(0.0, 2 * height - 1)));
    map.pixels.push_back(static_cast<std::uint8_t>(80 * height));
  }
  return map;
}

}  // namespace

Result<Sheet> sceneView(Console& console, const std::vector<double>& numbers) {
  SceneCamera camera;
  camera.width = 960;
  camera.height = 540;
  if (numbers.size() != 0 && numbers.size() != 3 && numbers.size() != 6)
    return Error{"", 0, "scene", "expected no numbers, X Y Z from where, or also X Y Z of what"};
  if (numbers.size() >= 3) camera.from = {numbers[0], numbers[1], numbers[2]};
  if (numbers.size() == 6) camera.at = {numbers[3], numbers[4], numbers[5]};
  if ((camera.at - camera.from).norm() < 1)
    return Error{"", 0, "scene", "both points are the same"};
  Sheet sheet{camera.width, camera.height};
  sheet.paint(scenePicture(console.session().simulation().world(), camera), {0, 0});
  return sheet;
}

Result<Sheet> robotView(Console& console, const std::vector<double>& numbers) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  if (!(*robot)->index()) return Error{"", 0, (*robot)->name(), "is no robot of the scene"};
  if (numbers.size() > 1)
    return Error{"", 0, "robot", "expected no number, or the direction from which in degrees"};
  const RobotBody& body = console.session().simulation().world().robot(*(*robot)->index());
  const double from = body.pose.rotation + fromDegrees(numbers.empty() ? 35 : numbers[0]);
  SceneCamera camera;
  camera.width = 640;
  camera.height = 480;
  camera.openingAngle = 32;
  camera.at = {body.pose.translation.x(), body.pose.translation.y(), 0.8 * body.height};
  camera.from = camera.at + Vector3d{800 * std::cos(from), 800 * std::sin(from), 400};
  Sheet sheet{camera.width, camera.height};
  sheet.paint(scenePicture(console.session().simulation().world(), camera), {0, 0});
  sheet.text({12, 24}, (*robot)->name(), colors::white, 16);
  const LedValue& leds = console.session().simulation().output(*(*robot)->index()).leds;
  for (std::size_t i = 0; i < enumCount<Led>; ++i) {
    const Vector2d at{16, 44 + 16 * static_cast<double>(i)};
    const bool lit = leds.lit.values[i];
    sheet.box(at, {10, 10}, lit ? colors::orange : Color{60, 60, 60});
    sheet.text(at + Vector2d{16, 9}, std::string{enumNames<Led>[i]}, colors::white, 11);
  }
  return sheet;
}

Result<Sheet> facetteView(Console& console, const std::vector<double>& numbers) {
  if (numbers.size() != 0 && numbers.size() != 3)
    return Error{"", 0, "facette", "expected no numbers, or X Y Z from where"};
  const World& world = console.session().simulation().world();
  Pose3D pose;
  int hidden = -1;
  if (numbers.size() == 3) {
    pose.translation = {numbers[0], numbers[1], numbers[2]};
  } else {
    const auto robot = console.firstRobot();
    if (!robot) return robot.error();
    if (!(*robot)->index()) return Error{"", 0, (*robot)->name(), "is no robot of the scene"};
    pose = world.camera(*(*robot)->index());
    hidden = world.parts(*(*robot)->index()).headBody;
  }
  Image image;
  Facette{360, 180}.take(Lighting{world.model()}, CameraScene{world.model()}, world.data(), pose,
                         hidden, false, image);
  const RgbPicture picture = rgbOf(image);
  constexpr int scale = 2;
  Sheet sheet{picture.width * scale, picture.height * scale};
  sheet.paint(picture, {0, 0}, scale);
  return sheet;
}

Result<Sheet> imageView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const auto picture = pictureOf(**robot);
  if (!picture) return picture.error();
  Sheet sheet = enlargedSheet(rgbOf(**picture));
  paintImageDrawings(sheet, **robot);
  return sheet;
}

Result<Sheet> colorClassImageView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const auto picture = pictureOf(**robot);
  if (!picture) return picture.error();
  const ColorTable64& table = *console.session().match().configuration().colorTable;
  Sheet sheet = enlargedSheet(classesOf(**picture, table));
  paintImageDrawings(sheet, **robot);
  return sheet;
}

Result<Sheet> colorSpaceView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const auto picture = pictureOf(**robot);
  if (!picture) return picture.error();
  constexpr double size = 256, gap = 40;
  Sheet sheet{static_cast<int>(3 * size + 4 * gap), static_cast<int>(size + 2 * gap)};
  constexpr std::array names{"y", "u", "v"};
  constexpr std::array<std::pair<int, int>, 3> planes{{{1, 2}, {1, 0}, {2, 0}}};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto [x, y] = planes[i];
    const Vector2d corner{gap + static_cast<double>(i) * (size + gap), gap};
    sheet.paint(heightMap(**picture, x, y), corner, size / 64);
    sheet.text(corner + Vector2d{size / 2, size + 18}, names[static_cast<std::size_t>(x)]);
    sheet.text(corner + Vector2d{-18, size / 2}, names[static_cast<std::size_t>(y)]);
  }
  sheet.text({gap, 24},
             (*robot)->name() + ": pixels by their values, brighter where there are more");
  return sheet;
}

}  // namespace gt
