#include "labels/LabelErrors.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "base/File.h"
#include "base/Geometry.h"

namespace gt {
namespace {

constexpr const char *ballFile = "-labels.csv", *fieldFile = "-field.csv";
/// Points that vision found so far from a labeled line belong to another one, in pixels.
constexpr double onSameLine = 10;

double azimuthOf(const Vector3d& ray) {
  return std::atan2(ray.y(), ray.x());
}

/// Where a direction from the camera meets the ground, in the robot's system.
std::optional<Vector2d> onGround(const CameraMatrix& matrix, const Vector2d& inImage) {
  const Vector3d ray = matrix.ray(inImage.x(), inImage.y());
  if (ray.z() >= 0) return std::nullopt;
  const double length = matrix.pose.translation.z() / -ray.z();
  return Vector2d{matrix.pose.translation.head<2>() + length * ray.head<2>()};
}

/// Compares one image.
class ImageComparison {
 public:
  ImageComparison(int picture, const SeenInImage& seen) : picture_{picture}, seen_{seen} {}

  void addBall(const BallLabel& label, double ballRadius) {
    const CameraInfo& info = seen_.matrix.info;
    LabelError error{picture_, seen_.time, "ball", label.view != BallView::none, seen_.ball.seen};
    if (error.labeled && label.radius > 0)
      error.distance = ballRadius / std::sin(std::atan(label.radius / info.focalX));
    if (error.labeled && error.found) {
      const Vector2d& found = seen_.ball.centerInImage;
      error.degrees = toDegrees(angleBetween(info.ray(label.center.x(), label.center.y()),
                                             info.ray(found.x(), found.y())));
    }
    if (error.labeled || error.found) errors_.push_back(error);
  }

  void addField(const FieldLabel& label) {
    addLines(label);
    for (const auto& post : {label.leftPost, label.rightPost})
      if (post) addPost(*post);
    for (const auto& [name, box] : label.boxes) {
      if (name.kind == BoxName::Kind::player)
        addPlayer(name, box);
      else
        addLandmark(name, box);
    }
  }

  std::vector<LabelError> take() { return std::move(errors_); }

 private:
  static double angleBetween(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }
  double azimuthAt(const Vector2d& inImage) const {
    return azimuthOf(seen_.matrix.ray(inImage.x(), inImage.y()));
  }
  LabelError labeled(const std::string& what, const Vector2d& foot) const {
    LabelError error{picture_, seen_.time, what, true};
    if (const auto place = onGround(seen_.matrix, foot)) error.distance = place->norm();
    return error;
  }

  void addLines(const FieldLabel& label) {
    if (label.lines.empty() || label.lines.front().empty()) return;
    LabelError error = labeled("lines", label.lines.front().front());
    double sum = 0;
    int count = 0;
    for (const Vector2d& point : seen_.lines.points[EdgeType::line]) {
      const Vector3d ray = Vector3d{point.x(), point.y(), 0} - seen_.matrix.pose.translation;
      const Vector3d inCamera = seen_.matrix.pose.rotation.transpose() * ray;
      if (inCamera.x() <= 0) continue;
      const double distance = label.distance(seen_.matrix.info.project(inCamera));
      if (distance > onSameLine) continue;
      sum += distance;
      ++count;
    }
    error.found = count > 0;
    if (error.found) error.degrees = toDegrees(std::atan(sum / count / seen_.matrix.info.focalX));
    errors_.push_back(error);
  }

  /// Of all goals' sides that were seen, the nearest.
  void addPost(const Vector2d& post) {
    LabelError error = labeled("post", post);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen_.landmarks.numberOfGoals); ++i) {
      const ConditionalBoundary& seen = seen_.landmarks.goals[i].boundary;
      const auto compare = [&](double angle, bool onBorder) {
        if (!onBorder) least = std::min(least, std::abs(normalize(angle - azimuthAt(post))));
      };
      compare(seen.left, seen.leftOnBorder);
      compare(seen.right, seen.rightOnBorder);
    }
    error.found = std::isfinite(least);
    if (error.found) error.degrees = toDegrees(least);
    errors_.push_back(error);
  }

  const ConditionalBoundary* boundaryOf(const BoxName& name) const {
    const LandmarksPercept& all = seen_.landmarks;
    if (name.kind == BoxName::Kind::flag) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(all.numberOfFlags); ++i)
        if (static_cast<int>(all.flags[i].type) == name.which) return &all.flags[i].boundary;
    } else {
      for (std::size_t i = 0; i < static_cast<std::size_t>(all.numberOfGoals); ++i)
        if (static_cast<int>(all.goals[i].color) == name.which) return &all.goals[i].boundary;
    }
    return nullptr;
  }

  /// By its left and right edges: their mean.
  void addLandmark(const BoxName& name, const BoxLabel& box) {
    const Vector2d foot{(box.left() + box.right()) / 2, box.bottom()};
    LabelError error = labeled(name.text(), foot);
    const ConditionalBoundary* seen = boundaryOf(name);
    const double y = (box.top() + box.bottom()) / 2;
    double sum = 0;
    int count = 0;
    const auto compare = [&](double angle, bool onBorder, double x) {
      if (onBorder) return;
      sum += std::abs(normalize(angle - azimuthAt({x, y})));
      ++count;
    };
    if (seen) {
      compare(seen->left, seen->leftOnBorder, box.left());
      compare(seen->right, seen->rightOnBorder, box.right());
    }
    error.found = seen;
    if (count > 0) error.degrees = toDegrees(sum / count);
    errors_.push_back(error);
  }

  /// The percept of its color in the nearest direction.
  void addPlayer(const BoxName& name, const BoxLabel& box) {
    const Vector2d foot{(box.left() + box.right()) / 2, box.bottom()};
    LabelError error = labeled(name.text(), foot);
    const auto place = onGround(seen_.matrix, foot);
    const double direction = place ? std::atan2(place->y(), place->x()) : azimuthAt(foot);
    double least = std::numeric_limits<double>::infinity();
    for (const Vector2d& found : seen_.players.players[static_cast<TeamColor>(name.which)])
      least = std::min(least, std::abs(normalize(std::atan2(found.y(), found.x()) - direction)));
    error.found = std::isfinite(least);
    if (error.found) error.degrees = toDegrees(least);
    errors_.push_back(error);
  }

  const int picture_;
  const SeenInImage& seen_;
  std::vector<LabelError> errors_;
};

/// Writes a table, or removes it if there is nothing in it.
Result<void> writeTable(const std::string& file, const std::string& text, bool empty) {
  std::error_code failed;
  if (!empty) return writeFile(file, text);
  std::filesystem::remove(file, failed);
  return failed ? Error{.file = file, .what = failed.message()} : Result<void>{};
}

}  // namespace

Result<ImageLabels> readImageLabels(const std::string& base) {
  ImageLabels labels;
  const std::string balls = base + ballFile, fields = base + fieldFile;
  const bool hasBalls = std::filesystem::exists(balls), hasFields = std::filesystem::exists(fields);
  if (!hasBalls && !hasFields)
    return Error{.file = balls, .what = "there is neither this file nor " + fields};
  if (hasBalls) {
    const auto read = readLabels(balls);
    if (!read) return read.error();
    for (const BallLabel& label : *read) labels.balls[label.picture] = label;
  }
  if (hasFields) {
    auto read = readFieldLabels(fields);
    if (!read) return read.error();
    labels.fields = std::move(*read);
  }
  return labels;
}

Result<void> writeImageLabels(const std::string& base, const ImageLabels& labels) {
  std::vector<BallLabel> balls;
  for (const auto& [picture, label] : labels.balls) balls.push_back(label);
  if (auto done = writeTable(base + ballFile, labelTable(balls), balls.empty()); !done) return done;
  return writeTable(base + fieldFile, fieldLabelTable(labels.fields), labels.fields.empty());
}

std::vector<LabelError> errorsIn(const ImageLabels& labels, int picture, const SeenInImage& seen,
                                 double ballRadius) {
  ImageComparison comparison{picture, seen};
  const auto ball = labels.balls.find(picture);
  if (ball != labels.balls.end() && ball->second.time == seen.time.ms)
    comparison.addBall(ball->second, ballRadius);
  const auto field = labels.fields.find(picture);
  if (field != labels.fields.end() && field->second.time == seen.time.ms)
    comparison.addField(field->second);
  return comparison.take();
}

}  // namespace gt
