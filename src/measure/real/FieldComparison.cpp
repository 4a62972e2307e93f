#include "measure/real/FieldComparison.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/Statistics.h"
#include "modules/perception/scanning/CameraImage.h"

namespace gt {
namespace {

constexpr double onLine = 3;    ///< Pixels: a point that near belongs to a label.
constexpr double spacing = 15;  ///< Pixels: scan lines are not further apart near the horizon.

/// Where the points on lines were found in the image.
std::vector<Vector2d> inImage(const LinesPercept& lines, const CameraMatrix& matrix) {
  std::vector<Vector2d> points;
  for (const Vector2d& p : lines.points[EdgeType::line]) {
    const Vector3d ray = Vector3d{p.x(), p.y(), 0} - matrix.pose.translation;
    points.push_back(pointIn(matrix, ray));
  }
  return points;
}

std::vector<double> absolute(std::vector<double> values) {
  for (double& v : values) v = std::abs(v);
  return values;
}

}  // namespace

void FieldComparison::add(const LinesPercept& lines, const LandmarksPercept& landmarks,
                          const CameraMatrix& matrix, const FieldLabel& label) {
  if (label.time != matrix.time.ms) return;
  ++pictures_;
  addLines(lines, matrix, label);
  addGoal(landmarks, matrix, label);
}

void FieldComparison::addLines(const LinesPercept& lines, const CameraMatrix& matrix,
                               const FieldLabel& label) {
  const std::vector<Vector2d> points = inImage(lines, matrix);
  for (const auto& line : label.lines)
    for (const Vector2d& at : line) {
      // A point of the same line, as far away as the next scan line may be.
      const bool found = std::ranges::any_of(points, [&](const Vector2d& p) {
        return (p - at).norm() <= spacing && label.distance(p) <= onLine;
      });
      labelsFound_.push_back(found ? 100 : 0);
    }
  for (const Vector2d& p : points) {
    const double distance = label.distance(p);
    pointsOnLabels_.push_back(distance <= onLine ? 100 : 0);
    if (distance <= onLine) lineErrors_.push_back(distance);
  }
}

void FieldComparison::addGoal(const LandmarksPercept& landmarks, const CameraMatrix& matrix,
                              const FieldLabel& label) {
  const GoalPercept* goal = nullptr;
  for (int i = 0; i < landmarks.numberOfGoals; ++i)
    if (landmarks.goals[static_cast<std::size_t>(i)].color == GoalColor::skyblue)
      goal = &landmarks.goals[static_cast<std::size_t>(i)];
  if (!label.leftPost && !label.rightPost) {
    goalsFalse_.push_back(landmarks.numberOfGoals > 0 ? 100 : 0);
    return;
  }
  goalsFound_.push_back(goal ? 100 : 0);
  if (!goal) return;
  const auto compare = [&](const std::optional<Vector2d>& post, double angle, bool onBorder) {
    if (!post || onBorder) return;
    const double seen = azimuth(matrix.ray(post->x(), post->y()));
    postErrors_.push_back(toDegrees(std::abs(normalize(angle - seen))));
  };
  compare(label.leftPost, goal->boundary.left, goal->boundary.leftOnBorder);
  compare(label.rightPost, goal->boundary.right, goal->boundary.rightOnBorder);
}

void FieldComparison::add(const std::optional<MatrixCorrection>& correction) {
  matrixKnown_.push_back(correction ? 100 : 0);
  if (!correction) return;
  tilts_.push_back(toDegrees(correction->tilt));
  rolls_.push_back(toDegrees(correction->roll));
}

std::string FieldComparison::text() const {
  const auto percent = [](const std::vector<double>& list) {
    return list.empty() ? std::string{"-"} : fmt::format("{:.1f} %", mean(list));
  };
  return fmt::format(
      "lines and goals labeled in {} images: {} of {} labeled points of lines found, {} of {} "
      "points found lie on labels, {:.2f} pixels from their middle; goal found in {} of {} "
      "images, false in {} of {}\n"
      "camera matrices checked by labeled lines in {} of {} images: tilt off by {:.2f} degrees on "
      "average, 95 % below {:.2f}, mean {:+.2f}; roll {:.2f}, {:.2f}, {:+.2f}\n",
      pictures_, percent(labelsFound_), labelsFound_.size(), percent(pointsOnLabels_),
      pointsOnLabels_.size(), lineErrors_.empty() ? 0 : mean(lineErrors_), percent(goalsFound_),
      goalsFound_.size(), percent(goalsFalse_), goalsFalse_.size(), tilts_.size(),
      matrixKnown_.size(), mean(absolute(tilts_)), quantile(absolute(tilts_), 0.95), mean(tilts_),
      mean(absolute(rolls_)), quantile(absolute(rolls_), 0.95), mean(rolls_));
}

void FieldComparison::addTo(Figures& figures) const {
  figures.add("vision.real.lines.found", "%", labelsFound_);
  figures.add("vision.real.lines.onLabel", "%", pointsOnLabels_);
  figures.add("vision.real.lines.error", "pixel", lineErrors_);
  figures.add("vision.real.goal.found", "%", goalsFound_);
  figures.add("vision.real.goal.false", "%", goalsFalse_);
  figures.add("vision.real.goal.post.error", "deg", postErrors_);
  figures.add("vision.real.matrix.checked", "%", matrixKnown_);
  figures.add("vision.real.matrix.tilt", "deg", absolute(tilts_));
  figures.add("vision.real.matrix.roll", "deg", absolute(rolls_));
}

}  // namespace gt
