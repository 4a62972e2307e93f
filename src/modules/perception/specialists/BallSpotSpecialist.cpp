#include "modules/perception/specialists/BallSpotSpecialist.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "modules/perception/specialists/BallView.h"

namespace gt {
namespace {

constexpr double smallest = 2, largest = 28;  // Pixels: radii.
constexpr ColorSet background{ColorClass::green, ColorClass::yellow, ColorClass::skyblue};

bool isColorless(const Pixel& pixel, ColorClass c) {
  constexpr ColorSet colored{ColorClass::green,  ColorClass::yellow, ColorClass::skyblue,
                             ColorClass::orange, ColorClass::pink,   ColorClass::red,
                             ColorClass::blue};
  constexpr int mostColor = 30;
  return !colored.contains(c) && std::abs(pixel.cb - 128) < mostColor &&
         std::abs(pixel.cr - 128) < mostColor;
}

/// Points on circles around a center, for a radius of 1.
template <std::size_t circles, std::size_t points>
std::array<Vector2d, circles * points> onCircles(const std::array<double, circles>& radii) {
  std::array<Vector2d, circles * points> found;
  for (std::size_t i = 0; i < circles; ++i)
    for (std::size_t k = 0; k < points; ++k)
      found[i * points + k] =
          radii[i] * direction(2 * pi * (static_cast<double>(k) + 0.5 * (i % 2)) / points);
  return found;
}
/// Returns whether there is black next to white. This alone rejects most places.
bool hasContrast(const CameraImage& picture, const Vector2d& center, double radius) {
  constexpr double near = 0.45, far = 1.3;  // of the radius
  constexpr double least = 0.6;
  int darkest = 255, brightest = 0;
  for (const Vector2d& offset : {Vector2d{0, 0},
                                 {near, 0},
                                 {-near, 0},
                                 {0, near},
                                 {0, -near},
                                 {far, 0},
                                 {-far, 0},
                                 {0, -far}}) {
    const Vector2d p = center + radius * offset;
    if (!picture.contains(p)) continue;
    const int y = picture.image.at(static_cast<int>(p.x()), static_cast<int>(p.y())).y;
    darkest = std::min(darkest, y);
    brightest = std::max(brightest, y);
  }
  return darkest < least * brightest;
}

const auto inside = onCircles<3, 8>({0.25, 0.55, 0.8});
const auto around = onCircles<2, 12>({1.3, 1.6});

}  // namespace

void BallSpotSpecialist::find(const CameraImage& picture, double ballRadius,
                              BallPercept& percept) const {
  constexpr double leastHeight = 20;  // mm
  constexpr double radiusError = 1;   // Pixels.
  percept = {};
  if (!picture.matrix.valid) return;
  const double height = picture.matrix.pose.translation.z() - ballRadius;
  const Spot spot = fitted(picture, best(picture, ballRadius / std::max(height, leastHeight)));
  if (spot.score <= 0) return;
  const Vector3d axis = picture.ray(spot.center);
  const Vector3d side = picture.ray(spot.center + picture.horizon.along * spot.radius);
  const double angle = std::acos(std::clamp(axis.dot(side), -1.0, 1.0));
  const double error = radiusError / focalLength(picture.matrix.info);
  percept.seen = describeBall(picture, {axis, angle, error}, ballRadius, percept) &&
                 isOnGround(picture, percept, axis, ballRadius);
  if (!percept.seen) percept = {};
}

BallSpotSpecialist::Spot BallSpotSpecialist::best(const CameraImage& picture, double growth) {
  constexpr double step = 0.4, leastStep = 1;  // of the radius, pixels
  constexpr double farthest = 1e4;             // pixels; a camera matrix may overflow
  const CameraInfo& info = picture.image.info;
  const Horizon& horizon = picture.horizon;
  const Vector2d middle{info.width / 2., info.height / 2.};
  const Vector2d at = horizon.fromImage(middle);
  const double across = middle.norm(), last = std::min(largest / growth, at.y() + across);
  Spot found;
  if (!(at.norm() < farthest)) return found;
  double below = std::max(smallest / growth, at.y() - across);
  while (below < last) {
    const double radius = below * growth, stride = std::max(step * radius, leastStep);
    for (double u = at.x() - across; u < at.x() + across; u += stride) {
      const Vector2d center = horizon.toPicture(u, below);
      if (!picture.contains(center) || background.contains(picture.classAt(center)) ||
          !hasContrast(picture, center, radius))
        continue;
      const auto spot = spotAt(picture, center, radius);
      if (spot && spot->score > found.score) found = *spot;
    }
    below += stride;
  }
  return found;
}

BallSpotSpecialist::Spot BallSpotSpecialist::fitted(const CameraImage& picture, Spot spot) {
  if (spot.score <= 0) return spot;
  constexpr int most = 8;
  constexpr double step = 0.7, larger = 1.1;
  for (int i = 0; i < most; ++i) {
    const Spot before = spot;
    const auto take = [&](double dx, double dy, double factor) {
      const auto next = spotAt(picture, before.center + Vector2d{dx, dy}, before.radius * factor);
      if (next && next->score > spot.score) spot = *next;
    };
    take(step, 0, 1);
    take(-step, 0, 1);
    take(0, step, 1);
    take(0, -step, 1);
    take(0, 0, larger);
    take(0, 0, 1 / larger);
    if (spot.score == before.score) break;
  }
  return spot;
}

std::optional<BallSpotSpecialist::Spot> BallSpotSpecialist::spotAt(const CameraImage& picture,
                                                                   const Vector2d& center,
                                                                   double radius) {
  constexpr double blackest = 0.55, whitest = 0.7;  // of the brightest
  constexpr double darker = 0.85, brighter = 1.5;   // than the ground: black and white
  constexpr double leastBlack = 0.15, mostBlack = 0.75, leastWhite = 0.08;  // of the ball
  constexpr double mostColored = 0.25, leastVisible = 0.6;                  // of it
  constexpr double leastKnown = 0.88;  // around it: ground, lines, walls, goals
  constexpr double before = 0.5;       // of the radius, nearer than the ball's center
  struct Sample {
    int y = 0;
    ColorClass color{};
    bool colorless = false;
  };
  const auto sample = [&](const Vector2d& offset) -> std::optional<Sample> {
    const Vector2d p = center + radius * offset;
    if (!picture.contains(p)) return std::nullopt;
    const Pixel& pixel = picture.image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
    const ColorClass c = picture.colors[pixel];
    return Sample{pixel.y, c, isColorless(pixel, c)};
  };

  std::array<Sample, inside.size()> samples;
  std::size_t visible = 0;
  double colored = 0;
  int brightest = 0;
  for (const Vector2d& offset : inside) {
    const auto seen = sample(offset);
    if (!seen) continue;
    samples[visible++] = *seen;
    if (seen->colorless)
      brightest = std::max(brightest, seen->y);
    else if (++colored > mostColored * inside.size())
      return std::nullopt;
  }
  const std::span in{samples.data(), visible};
  if (in.size() < leastVisible * inside.size()) return std::nullopt;
  std::array<std::optional<Sample>, around.size()> out;
  double ring = 0, green = 0, sumOfGreen = 0, nearer = 0, nearerGreen = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = sample(around[i]);
    if (!out[i]) continue;
    ++ring;
    const bool isGround = out[i]->color == ColorClass::green;
    if (isGround) ++green, sumOfGreen += out[i]->y;
    if (around[i].dot(picture.horizon.down) > before) ++nearer, nearerGreen += isGround;
    if (out[i]->colorless) brightest = std::max(brightest, out[i]->y);
  }
  if (3 * ring < out.size() || green == 0 || 2 * nearerGreen < nearer) return std::nullopt;
  const double ground = sumOfGreen / green;
  const auto isBlack = [&](const Sample& s) {
    return s.colorless && s.y < std::min(blackest * brightest, darker * ground);
  };
  const auto isWhite = [&](const Sample& s) {
    return s.colorless && s.y > std::max(whitest * brightest, brighter * ground);
  };
  const auto n = static_cast<double>(in.size());
  const double black = static_cast<double>(std::ranges::count_if(in, isBlack)) / n;
  const double white = static_cast<double>(std::ranges::count_if(in, isWhite)) / n;
  if (black < leastBlack || black > mostBlack || white < leastWhite) return std::nullopt;
  double known = 0;
  for (const auto& seen : out)
    if (seen) known += background.contains(seen->color) || isWhite(*seen);
  if (known < leastKnown * ring) return std::nullopt;
  return Spot{center, radius, black - colored / n + 2 * known / ring - 1};
}

}  // namespace gt
