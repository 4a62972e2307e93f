#include "modules/perception/specialists/SeenHeights.h"

namespace gt {
namespace {

constexpr double edgeError = 0.5;    // Pixels, of an edge of a landmark,
constexpr double footError = 1.5;    // and of a goal's foot, which robots hide in part.
constexpr double radiusError = 0.3;  // Pixels, of a ball.
constexpr double sizeError = 0.03;   // Of all sizes, as a share: blur and colors.

std::optional<SeenHeight> heightOf(const BallPercept& ball, const CameraMatrix& matrix,
                                   double ballRadius) {
  if (!ball.seen || ball.distanceBySize == 0 || ball.distanceByProjection == 0) return std::nullopt;
  const double lower = matrix.pose.translation.z() - ballRadius;
  const CameraInfo& info = matrix.info;
  const Vector2d& center = ball.centerInImage;
  const double radius = ball.radiusInImage;
  const bool whole = center.x() > radius && center.x() < info.width - radius &&
                     center.y() > radius && center.y() < info.height - radius;
  if (!whole || lower <= 0 || lower >= ball.distanceBySize) return std::nullopt;
  const double down = std::asin(lower / ball.distanceBySize);
  return SeenHeight{ball.angle.x(), down - std::asin(lower / ball.distanceByProjection),
                    ball.distanceBySize * std::cos(down),
                    std::tan(down) * std::hypot(sizeError, radiusError / radius)};
}

/// The SeenHeight of an upright object between two heights (mm). `error` is the error of the
/// elevation of its middle (pixels).
std::optional<SeenHeight> heightOf(const ConditionalBoundary& b, const CameraMatrix& matrix,
                                   double low, double high, double error) {
  const double height = std::tan(b.top) - std::tan(b.bottom);
  if (b.topOnBorder || b.bottomOnBorder || height <= 0) return std::nullopt;
  const double pixel = 1 / matrix.info.focalX;
  const double distance = (high - low) / height;
  const double above = (low + high) / 2 - matrix.pose.translation.z();
  const double middle = (std::tan(b.top) + std::tan(b.bottom)) / 2;
  const double bySize = above / distance * std::hypot(sizeError, edgeError * pixel / height);
  return SeenHeight{(b.left + b.right) / 2, std::atan(middle) - std::atan2(above, distance),
                    distance, std::hypot(error * pixel, bySize)};
}

}  // namespace

std::optional<SeenHeight> heightOf(const FlagPercept& flag, const CameraMatrix& matrix,
                                   const FieldDimensions& field) {
  return heightOf(flag.boundary, matrix, field.flagBottom, field.flagTop, edgeError);
}

void takeHeights(const CameraMatrix& matrix, const BallPercept& ball,
                 const LandmarksPercept& landmarks, const FieldDimensions& field,
                 std::vector<SeenHeight>& heights) {
  heights.clear();
  const auto take = [&](const std::optional<SeenHeight>& height) {
    if (height) heights.push_back(*height);
  };
  take(heightOf(ball, matrix, field.ballRadius));
  for (int i = 0; i < landmarks.numberOfFlags; ++i)
    take(heightOf(landmarks.flags[static_cast<std::size_t>(i)], matrix, field));
  for (int i = 0; i < landmarks.numberOfGoals; ++i)
    take(heightOf(landmarks.goals[static_cast<std::size_t>(i)].boundary, matrix, 0,
                  field.goalHeight, footError));
}

}  // namespace gt
