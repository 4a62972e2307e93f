#include "modules/behavior/control/ObstacleAvoiderOnGreenField.h"

#include <algorithm>

namespace gt {
namespace {

const DebugKey drawGreen{"SensorBehaviorControl/green"};
constexpr int columns = 22;

}  // namespace

double ObstacleAvoiderOnGreenField::greenIn(const Image& image, const ColorTable64& colors,
                                            int x) const {
  int top = image.info.height;
  for (int y = image.info.height - 1; y >= 0 && top - y <= parameters.gap; --y)
    if (colors[image.at(x, y)] == ColorClass::green) top = y;
  return 1 - static_cast<double>(top) / image.info.height;
}

void ObstacleAvoiderOnGreenField::update(const Image& image, const ColorTable64& colors,
                                         const FrameInfo& frame, MotionRequest& motion,
                                         HeadMotionRequest& head, LedRequest& leds,
                                         SoundRequest& sound, Debug& debug) {
  motion = {};
  motion.time = frame.time;
  head = {.tilt = fromDegrees(parameters.headTilt)};
  leds = {};
  sound = {};
  if (image.pixels.empty()) return;

  // The image's left and right half, and the way ahead between its quarters.
  double left = 0, right = 0, ahead = 1;
  auto canvas = debug.onImage(drawGreen);
  for (int column = 0; column < columns; ++column) {
    const int x = (2 * column + 1) * image.info.width / (2 * columns);
    const double green = greenIn(image, colors, x);
    (column < columns / 2 ? left : right) += green / (columns / 2.);
    if (column >= columns / 4 && column < columns - columns / 4) ahead = std::min(ahead, green);
    const double height = image.info.height;
    if (canvas)
      canvas.line({static_cast<double>(x), height}, {static_cast<double>(x), height * (1 - green)},
                  {255, 255, 255});
  }

  motion.type = MotionType::walk;
  if (ahead < parameters.blocked) {
    if (!blocked_) turnsLeft_ = left > right;
    blocked_ = true;
    motion.walk.rotation = fromDegrees(turnsLeft_ ? parameters.turn : -parameters.turn);
  } else {
    blocked_ = false;
    const double share = std::clamp(
        (ahead - parameters.blocked) / std::max(parameters.free - parameters.blocked, 0.01), 0.,
        1.);
    const double most = fromDegrees(parameters.turn);
    motion.walk = {std::clamp(parameters.steer * (left - right), -most, most),
                   parameters.forward * share, 0};
  }
  const LedMode green = blocked_ ? LedMode::off : LedMode::on;
  leds.modes[Led::middleLeft] = leds.modes[Led::middleRight] = green;
}

}  // namespace gt
