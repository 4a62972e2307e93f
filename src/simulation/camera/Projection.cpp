#include "simulation/camera/Projection.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gt {
namespace {

/// Factor by which the lens widens the view beyond what follows from its focal length, at most: in
/// one of the corners.
double widestFactor(const CameraInfo& info) {
  double widest = 1;
  for (const double x : {info.centerX, info.width - info.centerX})
    for (const double y : {info.centerY, info.height - info.centerY}) {
      const double a = x / info.focalX, b = y / info.focalY;
      widest = std::max(widest, info.distortion().undoing(a * a + b * b));
    }
  return widest;
}

}  // namespace

void Projection::set(const CameraView& view, bool rollingShutter) {
  constexpr double meters = 0.001;
  const CameraInfo& info = view.info;
  const Eigen::AngleAxisd turn{view.first.rotation.transpose() * view.last.rotation};
  const Matrix3d middle =
      view.first.rotation * Eigen::AngleAxisd{turn.angle() / 2, turn.axis()}.toRotationMatrix();
  rotation_ = middle.transpose().cast<float>();
  position_ = (meters * (view.first.translation + view.last.translation) / 2).cast<float>();
  focalX_ = static_cast<float>(info.focalX);
  focalY_ = static_cast<float>(info.focalY);
  centerX_ = static_cast<float>(info.centerX);
  centerY_ = static_cast<float>(info.centerY);

  const bool rows = rollingShutter && info.height > 1;
  turning_.setZero();
  moving_.setZero();
  if (rows) {
    // The axis is the same before and after turning about it.
    turning_ = (turn.angle() * turn.axis()).cast<float>();
    moving_ = (meters * (middle.transpose() * (view.last.translation - view.first.translation)))
                  .cast<float>();
  }
  moves_ = turning_.norm() > 1e-4f || moving_.norm() > 1e-5f;
  rowOffset_ = static_cast<float>(info.height / 2.0 - info.centerY);
  middleRow_ = static_cast<float>(info.height) / 2;
  rowShare_ = rows ? 1 / static_cast<float>(info.height - 1) : 0;

  const LensDistortion lens = info.distortion();
  distorts_ = !lens.none();
  distortion2_ = static_cast<float>(lens.k2);
  distortion4_ = static_cast<float>(lens.k4);
  distortionLimit_ = static_cast<float>(lens.limit());

  // What turns into the image during the exposure lies outside its borders at half time.
  const double margin = 0.02 + std::min(1.0, 1.0 * static_cast<double>(turning_.norm()) +
                                                 static_cast<double>(moving_.norm()) / 0.1);
  const double widest = distorts_ ? widestFactor(info) : 1;
  const auto border = [&](double pixels, double focal) {
    return static_cast<float>(widest * pixels / focal + margin);
  };
  normals_ = {Eigen::Vector3f{1, 0, 0},
              Eigen::Vector3f{border(info.centerX, info.focalX), -1, 0}.normalized(),
              Eigen::Vector3f{border(info.width - info.centerX, info.focalX), 1, 0}.normalized(),
              Eigen::Vector3f{border(info.centerY, info.focalY), 0, -1}.normalized(),
              Eigen::Vector3f{border(info.height - info.centerY, info.focalY), 0, 1}.normalized()};
  offsets_ = {nearest, 0, 0, 0, 0};
}

void Projection::project(const Eigen::Vector3f* points, int count, ScreenPoint* seen) const {
  const auto bounded = [](Floats v, float limit) {
    return least(all(limit), most(all(-limit), v));
  };
  for (int i = 0; i < count; i += lanes) {
    const auto coordinates = [&](int axis) {
      Floats values;
      for (int k = 0; k < lanes; ++k) values[k] = points[std::min(i + k, count - 1)][axis];
      return values;
    };
    const Floats x = coordinates(0), y = coordinates(1), z = coordinates(2);
    // A point moves by -s * motion in the camera's system, s = -0.5 at row 0 and 0.5 at the last
    // row. It is exposed when s * (rows - 1) = row(s) - middle; times x this is a square equation
    // in s, nearly a linear one: one step of refinement is exact to a thousandth of a pixel.
    Floats movedX = x, movedY = y, movedZ = z;
    if (moves_) {
      const Floats changeX = -(turning_.y() * z - turning_.z() * y + moving_.x()),
                   changeY = -(turning_.z() * x - turning_.x() * z + moving_.y()),
                   changeZ = -(turning_.x() * y - turning_.y() * x + moving_.z());
      const Floats linear = x + rowShare_ * (rowOffset_ * changeX + focalY_ * changeZ);
      const Floats constant = rowShare_ * (rowOffset_ * x + focalY_ * z);
      const Floats first = -constant / linear;
      const Floats s = bounded(-constant / (linear + changeX * first), 0.75f);
      movedX += s * changeX;
      movedY += s * changeY;
      movedZ += s * changeZ;
    }
    if (distorts_) {
      for (int k = 0; k < lanes; ++k)
        seen[i + k] = projectByLens({x[k], y[k], z[k]}, {movedX[k], movedY[k], movedZ[k]});
      continue;
    }
    constexpr float limit = 1e5f;
    const Floats inverseDepth = 1 / most(movedX, all(nearest / 4));
    const Floats column = bounded(centerX_ - focalX_ * movedY * inverseDepth, limit),
                 row = bounded(centerY_ - focalY_ * movedZ * inverseDepth, limit);
    for (int k = 0; k < lanes; ++k) seen[i + k] = {column[k], row[k]};
  }
}

// Straight edges get points between, so that it is enough to distort points; a plane's inverse
// depth is that of where the point should be, which is off by as little as the lens bends.
ScreenPoint Projection::projectByLens(const Eigen::Vector3f& point,
                                      const Eigen::Vector3f& moved) const {
  constexpr float limit = 1e5f;
  const auto bounded = [=](float v) { return std::min(limit, std::max(-limit, v)); };
  const auto project = [&](const Eigen::Vector3f& p) -> ScreenPoint {
    const float inverseDepth = 1 / std::max(p.x(), nearest / 4);
    const float y = p.y() * inverseDepth, z = p.z() * inverseDepth;
    const float square = std::min(y * y + z * z, distortionLimit_);
    const float factor = 1 + square * (distortion2_ + square * distortion4_);
    return {bounded(centerX_ - focalX_ * y * factor), bounded(centerY_ - focalY_ * z * factor)};
  };
  const ScreenPoint seen = project(moved);
  if (!moves_) return seen;
  // The lens moves it into another row, which is exposed at another moment.
  const float s = std::clamp(rowShare_ * (seen.y - middleRow_), -0.75f, 0.75f);
  return project(point - s * (turning_.cross(point) + moving_));
}

bool Projection::planeOf(const Eigen::Vector3f* points, int count, ScreenPlane& plane) const {
  const int quarter = count / 4, half = count / 2;
  const Eigen::Vector3f normal =
      count == 3 ? (points[1] - points[0]).cross(points[2] - points[0])
                 : (points[half] - points[0]).cross(points[half + quarter] - points[quarter]);
  const float distance = normal.dot(points[0]);
  constexpr float thinnest = 1e-5f;
  if (!(distance * distance > thinnest * thinnest * normal.squaredNorm())) return false;

  // At the moment s the plane has the normal n + s * (n x turning); s is linear in the row.
  const Eigen::Vector3f perRow = rowShare_ * normal.cross(turning_);
  const Eigen::Vector3f first = normal - middleRow_ * perRow;
  const float x = centerX_ / focalX_, y = centerY_ / focalY_;
  plane.first0 = first.x() + first.y() * x + first.z() * y;
  plane.first1 = perRow.x() + perRow.y() * x + perRow.z() * y - first.z() / focalY_;
  plane.first2 = -perRow.z() / focalY_;
  plane.column0 = -first.y() / focalX_;
  plane.column1 = -perRow.y() / focalX_;
  plane.distance1 = -rowShare_ * normal.dot(moving_);
  plane.distance0 = distance - middleRow_ * plane.distance1;
  plane.clockwise = distance > 0;
  return true;
}

int Projection::clip(Eigen::Vector3f* points, int count) const {
  assert(count + planeCount <= maxPoints);
  std::array<Eigen::Vector3f, maxPoints> buffer;
  for (std::size_t plane = 0; plane < planeCount && count >= 3; ++plane) {
    std::array<float, maxPoints> distance;
    bool cut = false;
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      distance[at] = normals_[plane].dot(points[i]) - offsets_[plane];
      cut |= distance[at] < 0;
    }
    if (!cut) continue;
    int kept = 0;
    for (int i = 0; i < count && kept + 2 <= maxPoints; ++i) {
      const int j = i + 1 == count ? 0 : i + 1;
      const float a = distance[static_cast<std::size_t>(i)];
      const float b = distance[static_cast<std::size_t>(j)];
      if (a >= 0) buffer[static_cast<std::size_t>(kept++)] = points[i];
      // From the inner to the outer end, so that neighbors are cut at the same point.
      if ((a >= 0) != (b >= 0))
        buffer[static_cast<std::size_t>(kept++)] =
            a >= 0 ? Eigen::Vector3f{points[i] + a / (a - b) * (points[j] - points[i])}
                   : Eigen::Vector3f{points[j] + b / (b - a) * (points[i] - points[j])};
    }
    count = kept;
    std::copy_n(buffer.begin(), count, points);
  }
  return count >= 3 ? count : 0;
}

}  // namespace gt
