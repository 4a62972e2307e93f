#include "modules/perception/processors/GridImageProcessor2.h"

#include "colors/ClassColors.h"
#include "modules/perception/scanning/FlagColors.h"

namespace gt {
namespace {

const DebugKey drawClasses{"ImageProcessor/adaptation/classes"};
const DebugKey drawLearned{"ImageProcessor/adaptation/learned"};
const DebugKey plotGreen{"ImageProcessor/adaptation/greenY"};
const DebugKey plotWhite{"ImageProcessor/adaptation/whiteY"};

/// The point in the image (pixels) at a relative position within a boundary: 0 is left and top, 1
/// right and bottom.
Vector2d within(const CameraImage& picture, const ConditionalBoundary& b, double x, double y) {
  const double azimuth = b.left + x * (b.right - b.left);
  const double elevation = b.top + y * (b.bottom - b.top);
  return picture.pointOf({std::cos(azimuth), std::sin(azimuth), std::tan(elevation)});
}

}  // namespace

void GridImageProcessor2::update(const Image& image, const CameraMatrix& matrix,
                                 const FieldDimensions& field, Percepts found, Debug& debug) {
  const Horizon horizon = horizonOf(matrix);
  const Image& corrected = correction_.correct(image, horizon, colors_.table());
  colors_.observe(corrected, horizon);
  vision_.lookForAll(corrected, matrix, colors_.table(), field, found, debug);
  learned_.clear();
  watched_ = debug.isActive(drawLearned);
  const CameraImage picture{corrected, colors_.table(), matrix, horizon};
  learn(picture, found.ball);
  learn(picture, found.landmarks);
  learn(picture, found.players);
  draw(corrected, debug);
  colors_.refresh();
}

void GridImageProcessor2::learnAt(const CameraImage& picture, const Vector2d& point,
                                  ColorClass color) {
  if (!picture.contains(point) || color == ColorClass::noColor) return;
  colors_.learn(color, picture.image.at(static_cast<int>(point.x()), static_cast<int>(point.y())));
  if (watched_) learned_.emplace_back(point, color);
}

void GridImageProcessor2::learn(const CameraImage& picture, const BallPercept& ball) {
  constexpr double smallest = 3, inside = 0.65;
  constexpr int rays = 8;
  if (!ball.seen || ball.radiusInImage < smallest) return;
  for (int i = 0; i < rays; ++i)
    for (const double part : {0.5, 1.0})
      learnAt(picture,
              ball.centerInImage +
                  inside * part * ball.radiusInImage * direction(2 * pi * (i + part) / rays),
              ColorClass::orange);
}

void GridImageProcessor2::learn(const CameraImage& picture, const LandmarksPercept& landmarks) {
  for (int i = 0; i < landmarks.numberOfFlags; ++i) {
    const FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(i)];
    if (flag.boundary.topOnBorder || flag.boundary.bottomOnBorder) continue;
    // Green on flags is not the carpet's.
    const auto learned = [](ColorClass c) {
      return c == ColorClass::green ? ColorClass::noColor : c;
    };
    const ColorClass upper = learned(colorsOf(flag.type).upper);
    const ColorClass lower = learned(colorsOf(flag.type).lower);
    for (const double x : {0.35, 0.5, 0.65})
      for (const double y : {0.15, 0.3}) {
        learnAt(picture, within(picture, flag.boundary, x, y), upper);
        learnAt(picture, within(picture, flag.boundary, x, 1 - y), lower);
      }
  }
  for (int i = 0; i < landmarks.numberOfGoals; ++i) {
    const GoalPercept& goal = landmarks.goals[static_cast<std::size_t>(i)];
    const ColorClass color =
        goal.color == GoalColor::yellow ? ColorClass::yellow : ColorClass::skyblue;
    for (const double x : {0.2, 0.4, 0.6, 0.8})
      for (const double y : {0.25, 0.5, 0.75})
        learnAt(picture, within(picture, goal.boundary, x, y), color);
  }
}

// The place of a tricot on a robot is known by its color only: all pixels around there that look
// like it are learned.
void GridImageProcessor2::learn(const CameraImage& picture, const PlayersPercept& players) {
  constexpr double height = 100;  // mm
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    const ColorClass color = team == TeamColor::red ? ColorClass::red : ColorClass::blue;
    for (const Vector2d& place : players.players[team]) {
      const Vector3d ray = Vector3d{place.x(), place.y(), height} - picture.matrix.pose.translation;
      if (picture.matrix.pose.rotation.col(0).dot(ray) <= 0) continue;
      const Vector2d middle = picture.pointOf(ray);
      for (int y = -6; y <= 6; y += 2)
        for (int x = -6; x <= 6; x += 2) {
          const Vector2d p = middle + Vector2d{double(x), double(y)};
          if (picture.contains(p) && picture.classAt(p) == color) learnAt(picture, p, color);
        }
    }
  }
}

void GridImageProcessor2::draw(const Image& image, Debug& debug) const {
  debug.plot(plotGreen, colors_.greenY());
  debug.plot(plotWhite, colors_.whiteY());
  if (auto canvas = debug.onImage(drawClasses))
    for (int y = 1; y < image.info.height; y += 3)
      for (int x = 1; x < image.info.width; x += 3) {
        const ColorClass c = colors_.table()[image.at(x, y)];
        if (c != ColorClass::noColor) canvas.point({x + 0.5, y + 0.5}, displayColor(c), 1.2);
      }
  if (auto canvas = debug.onImage(drawLearned))
    for (const auto& [point, color] : learned_) canvas.point(point, displayColor(color), 1);
}

}  // namespace gt
