#include "simulation/camera/ShapeDrawer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gt {
namespace {

/// The direction to the light: above, and a little to one side so that faces differ.
const Eigen::Vector3f lightDirection = Eigen::Vector3f{0.25f, 0.15f, 0.95f}.normalized();

/// Corners of polygons around a circle, cosine and sine, for each number of corners; the middle of
/// an edge lies at angle 0.
class Circles {
 public:
  static constexpr int most = 48;

  Circles() {
    for (int n = 3; n <= most; ++n)
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + 0.5) / n;
        points_[index(n)][index(i)] = {static_cast<float>(std::cos(angle)),
                                       static_cast<float>(std::sin(angle))};
        // A polygon of this radius has the area of the circle.
        radii_[index(n)] = static_cast<float>(std::sqrt(2 * pi / n / std::sin(2 * pi / n)));
      }
  }
  const Eigen::Vector2f& point(int corners, int i) const {
    return points_[index(corners)][index(i)];
  }
  float radius(int corners) const { return radii_[index(corners)]; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::array<std::array<Eigen::Vector2f, most>, most + 1> points_;
  std::array<float, most + 1> radii_{};
};
const Circles circles;

}  // namespace

void ShapeDrawer::draw(const CameraShape& shape, const mjtNum* position, const mjtNum* axes) {
  center_ = projection_.toCamera(Eigen::Map<const Eigen::Vector3<mjtNum>>{position}.cast<float>());
  const auto visibility = projection_.visibility(center_, shape.reach);
  if (visibility == Projection::Visibility::hidden) return;
  clipped_ = visibility == Projection::Visibility::partly;
  shape_ = &shape;
  bent_ = projection_.bends() && pixelsOf(shape.reach) > 16;

  const Eigen::Matrix3f toWorld =
      Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>{axes}.cast<float>();
  axes_.noalias() = projection_.rotation() * toWorld;
  eye_.noalias() = -(axes_.transpose() * center_);
  light_.noalias() = toWorld.transpose() * lightDirection;
  up_ = toWorld.row(2);
  rasterizer_.setSurface(shape.geom, !shape.decal);
  switch (shape.form) {
    case CameraForm::plane:
      return plane();
    case CameraForm::box:
      return box();
    case CameraForm::ellipsoid:
      return ellipsoid(shape.size, 0);
    case CameraForm::cylinder:
      return cylinder();
    case CameraForm::capsule:
      return capsule();
    case CameraForm::mesh:
      return mesh();
  }
}

float ShapeDrawer::pixelsOf(float length) const {
  return projection_.focal() * (center_.x() > length ? length / center_.x() : 1);
}

PackedColor ShapeDrawer::shade(const Vector& normal) const {
  constexpr float half = 0.5f * (CameraShape::shadeCount - 1);
  const int level = static_cast<int>(half * light_.dot(normal) + half + 0.5f);
  return shape_
      ->shades[static_cast<std::size_t>(std::clamp(level, 0, CameraShape::shadeCount - 1))];
}

void ShapeDrawer::plane() {
  if (eye_.z() <= 0) return;
  const float x = shape_->size.x(), y = shape_->size.y();
  points_[0] = place({-x, -y, 0});
  points_[1] = place({x, -y, 0});
  points_[2] = place({x, y, 0});
  points_[3] = place({-x, y, 0});
  polygon(4, shade(Vector::UnitZ()));
}

void ShapeDrawer::box() {
  // Of what lies flat on the floor, only the upper side matters.
  for (int i = shape_->decal ? 2 : 0; i < 3; ++i) {
    if (std::abs(eye_[i]) <= shape_->size[i]) continue;
    const float side = eye_[i] > 0 ? 1.0f : -1.0f;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Vector middle = center_ + side * shape_->size[i] * axes_.col(i);
    const Vector a = shape_->size[j] * axes_.col(j), b = shape_->size[k] * axes_.col(k);
    points_[0] = middle - a - b;
    points_[1] = middle + a - b;
    points_[2] = middle + a + b;
    points_[3] = middle - a + b;
    polygon(4, shade(side * Vector::Unit(i)));
  }
}

void ShapeDrawer::mesh() {
  for (int i = 0; i < shape_->faceCount; ++i) {
    const CameraScene::Face& face = scene_.faces()[static_cast<std::size_t>(shape_->firstFace + i)];
    if (face.normal.dot(eye_ - face.points[0]) <= 0) continue;
    for (int k = 0; k < 3; ++k) points_[k] = place(face.points[static_cast<std::size_t>(k)]);
    polygon(3, shade(face.normal));
  }
}

void ShapeDrawer::cylinder() {
  const float radius = shape_->size.x(), halfLength = shape_->size.y();
  if (!shape_->decal) mantle(radius, halfLength);
  if (eye_.z() > halfLength) lid(radius, halfLength);
  if (eye_.z() < -halfLength && !shape_->decal) lid(radius, -halfLength);
}

void ShapeDrawer::capsule() {
  const float radius = shape_->size.x(), halfLength = shape_->size.y();
  const Vector radii = Vector::Constant(radius);
  mantle(radius, halfLength);
  if (pixelsOf(radius) < 0.7f) return;  // The ends would hardly be seen.
  ellipsoid(radii, halfLength);
  ellipsoid(radii, -halfLength);
}

void ShapeDrawer::mantle(float radius, float halfLength) {
  const float distance = std::hypot(eye_.x(), eye_.y());
  if (distance <= radius * 1.001f) return;
  const Vector ahead{eye_.x() / distance, eye_.y() / distance, 0}, aside{-ahead.y(), ahead.x(), 0};
  const float cosine = radius / distance, widest = std::sqrt(1 - cosine * cosine);
  const int facets = std::clamp(static_cast<int>(0.8f * pixelsOf(radius)), 1, 10);
  // The corners lie at equal distances across the line of sight, from outline to outline.
  const auto normalAt = [&](float across) -> Vector {
    const float s = widest * across;
    return std::sqrt(1 - s * s) * ahead + s * aside;
  };
  const Vector half = halfLength * axes_.col(2);
  Vector right = center_ + radius * (axes_ * normalAt(-1));
  for (int i = 0; i < facets; ++i) {
    const auto part = [&](float k) { return 2 * k / static_cast<float>(facets) - 1; };
    const Vector left = center_ + radius * (axes_ * normalAt(part(static_cast<float>(i + 1))));
    points_[0] = right - half;
    points_[1] = left - half;
    points_[2] = left + half;
    points_[3] = right + half;
    polygon(4, shade(normalAt(part(static_cast<float>(i) + 0.5f))));
    right = left;
  }
}

void ShapeDrawer::lid(float radius, float height) {
  const int corners = std::clamp(static_cast<int>(pixelsOf(radius)) + 4, 6, Circles::most);
  const float outer = radius * circles.radius(corners);
  for (int i = 0; i < corners; ++i) {
    const Eigen::Vector2f& p = circles.point(corners, i);
    points_[i] = place({outer * p.x(), outer * p.y(), height});
  }
  polygon(corners, shade(height > 0 ? Vector{0, 0, 1} : Vector{0, 0, -1}));
}

void ShapeDrawer::ellipsoid(const Vector& radii, float offset) {
  // Where the ellipsoid is a unit sphere, the camera sees it up to a circle across the line to the
  // center; cut into strips by height, for the shade.
  const Vector eye = (eye_ - Vector{0, 0, offset}).cwiseQuotient(radii);
  const float square = eye.squaredNorm();
  if (square < 1.001f) return;
  const Vector toEye = eye / std::sqrt(square);
  Vector aside = toEye.cross(up_);
  if (aside.squaredNorm() < 1e-6f) aside = toEye.unitOrthogonal();
  aside.normalize();
  const Vector above = aside.cross(toEye);

  const float pixels = pixelsOf(radii.maxCoeff());
  // Far away there is room for one shade only.
  const int strips =
      pixels < 3 ? 3 : std::clamp(static_cast<int>(pixels / 2) + 3, 4, Circles::most / 2);
  const float radius = std::sqrt(1 - 1 / square) * circles.radius(2 * strips);
  const Vector center = place(Vector{0, 0, offset} + radii.cwiseProduct(eye / square));
  const Vector x = axes_ * radii.cwiseProduct(radius * aside);
  const Vector y = axes_ * radii.cwiseProduct(radius * above);
  if (pixels < 3) {
    for (int i = 0; i < 2 * strips; ++i) {
      const Eigen::Vector2f& p = circles.point(2 * strips, i);
      points_[i] = center - p.x() * y + p.y() * x;
    }
    return polygon(2 * strips, shade(toEye));
  }
  for (int i = 0; i + 1 < strips; ++i) {
    const Eigen::Vector2f& low = circles.point(2 * strips, i);
    const Eigen::Vector2f& high = circles.point(2 * strips, i + 1);
    // From the lowest edge, up on both sides.
    points_[0] = center - low.x() * y - low.y() * x;
    points_[1] = center - low.x() * y + low.y() * x;
    points_[2] = center - high.x() * y + high.y() * x;
    points_[3] = center - high.x() * y - high.y() * x;
    const float height = -0.5f * (low.x() + high.x());
    const Vector normal = height * above + std::sqrt(std::max(0.0f, 1 - height * height)) * toEye;
    polygon(4, shade(normal.cwiseQuotient(radii).normalized()));
  }
}

void ShapeDrawer::polygon(int count, PackedColor color) {
  ScreenPlane plane;
  if (!projection_.planeOf(points_, count, plane)) return;
  if (clipped_) count = projection_.clip(points_, count);
  if (count == 0) return;
  projection_.project(points_, count, screen_);
  if (bent_) count = bend(count);
  rasterizer_.fill(screen_, count, plane, color);
}

int ShapeDrawer::bend(int count) {
  // While the camera turns, straight edges are seen curved: long ones get points between.
  constexpr float longest = 24;
  int made = 0;
  for (int i = 0; i < count; ++i) {
    const int next = i + 1 == count ? 0 : i + 1;
    const Vector &a = points_[i], &b = points_[next];
    const ScreenPoint &from = screen_[i], &to = screen_[next];
    const float length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const int parts = std::clamp(static_cast<int>(length / longest), 1, 16);
    if (made + parts + count - i > maxScreenPoints) break;
    bentPoints_[made++] = a;
    for (int k = 1; k < parts; ++k) {
      // Halfway in the image is not halfway in space.
      const float u = static_cast<float>(k) / static_cast<float>(parts);
      const float t = u * a.x() / (u * a.x() + (1 - u) * b.x());
      bentPoints_[made++] = a + t * (b - a);
    }
  }
  if (made > count) projection_.project(bentPoints_, made, screen_);
  return made;
}

}  // namespace gt
