#include "modules/perception/specialists/BallSpecialist.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr int maxGap = 3;              // Pixels within the ball that may have another color.
constexpr int traceRays = 24;          // Ways from within the ball to its boundary.
constexpr std::size_t minForCone = 8;  // Boundary points, a third of the circle.
constexpr double pointError = 0.3;     // Pixels: standard deviation of a boundary point,
constexpr double radiusError = 0.15;   // and of the radius, as all of them are shifted alike,
constexpr double radiusLoss = 0.12;    // which is by so much, as the rim is blurred.
constexpr double hiddenError = 0.7;    // Standard deviation of the radius, as a share, of a ball
                                       // that may be hidden by a robot all around.
constexpr ColorSet robotColors{ColorClass::red, ColorClass::blue, ColorClass::black,
                               ColorClass::gray};

/// Returns whether fewer than half of the segments' opposite ends lie on the wrong side of a point.
template <typename Wrong>
bool isOutlier(std::span<const BallSegment> segments, std::span<const std::size_t> members,
               Wrong wrong) {
  std::size_t count = 0;
  for (const std::size_t i : members) count += wrong(segments[i]) ? 1 : 0;
  return 2 * count > members.size();
}

/// The center of the circle through three points, where two middle perpendiculars intersect;
/// false if the points lie on a line.
bool intersectPerpendiculars(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                             Vector2d& center) {
  const Vector2d ab = b - a, ac = c - a;
  const double cross = ab.x() * ac.y() - ab.y() * ac.x();
  if (std::abs(cross) < 0.02 * ab.norm() * ac.norm() || cross == 0) return false;
  const double b2 = ab.squaredNorm(), c2 = ac.squaredNorm();
  center = a + Vector2d{ac.y() * b2 - ab.y() * c2, ab.x() * c2 - ac.x() * b2} / (2 * cross);
  return true;
}

// Far enough from an edge that its blur does not reach there, in pixels.
constexpr double away = 2.5;

/// The standard deviation of the angle of a cone that was fitted to points; `points` is the sum of
/// ray * ray' over them. The fewer and the closer together they are, the larger it is.
double angleError(const BallCone& cone, const Matrix3d& points, double focal) {
  // The normal's length (see fitCone) has the variance (tan(angle) * pointError)^2 * n' a^-1 n.
  const double spread = cone.axis.dot(points.ldlt().solve(cone.axis));
  return std::hypot(radiusError,
                    pointError * std::cos(cone.angle) * std::sqrt(std::max(spread, 0.))) /
         focal;
}

ColorClass classBeyond(const CameraImage& picture, const Vector2d& edge, const Vector2d& way) {
  const Vector2d beyond = edge + way * away;
  return picture.contains(beyond) ? picture.classAt(beyond) : ColorClass::noColor;
}

}  // namespace

void BallSpecialist::find(const CameraImage& picture, std::span<const BallSegment> segments,
                          double ballRadius, BallPercept& percept) {
  percept = {};
  cluster(segments);
  // The largest cluster first; what the check by projection back refuses gives way to the next.
  for (int attempt = 0; attempt < 4; ++attempt) {
    Cluster* best = nullptr;
    for (std::size_t i = 0; i < used_; ++i)
      if (clusters_[i].orange > (best ? best->orange : 2)) best = &clusters_[i];
    if (!best) return;
    if (look(picture, segments, *best, ballRadius, percept)) return;
    percept = {};
    best->orange = 0;
  }
}

void BallSpecialist::cluster(std::span<const BallSegment> segments) {
  constexpr double margin = 3, widestGap = 12;
  used_ = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const BallSegment& s = segments[i];
    const Vector2d low = s.upper.cwiseMin(s.lower), high = s.upper.cwiseMax(s.lower);
    Cluster* home = nullptr;
    for (std::size_t k = 0; k < used_ && !home; ++k) {
      Cluster& c = clusters_[k];
      const BallSegment& newest = segments[c.segments.back()];
      const bool meets =
          (low.array() <= c.high.array() + margin + Vector2d{widestGap, 0}.array()).all() &&
          (high.array() >= c.low.array() - margin).all();
      if (meets && s.u - newest.u <= widestGap) home = &c;
    }
    if (!home) {
      if (used_ == clusters_.size()) clusters_.emplace_back();
      home = &clusters_[used_++];
      home->low = low;
      home->high = high;
      home->orange = 0;
      home->segments.clear();
    }
    home->low = home->low.cwiseMin(low);
    home->high = home->high.cwiseMax(high);
    home->orange += s.orange;
    home->segments.push_back(i);
  }
}

// Upper points below many lower points and lower points above many upper ones are outliers
// (report 3.2.3).
void BallSpecialist::collectPoints(std::span<const BallSegment> segments, const Cluster& cluster) {
  points_.clear();
  for (const std::size_t i : cluster.segments) {
    const BallSegment& s = segments[i];
    if (s.upperKnown && !isOutlier(segments, cluster.segments, [&](const BallSegment& other) {
          return other.lowerKnown && other.lower.y() < s.upper.y();
        }))
      points_.push_back({s.upper, s.above, true});
    if (s.lowerKnown && !isOutlier(segments, cluster.segments, [&](const BallSegment& other) {
          return other.upperKnown && other.upper.y() > s.lower.y();
        }))
      points_.push_back({s.lower, s.below, false});
  }
}

// Computes the mean chroma of the ball: first of its orange pixels, which in a blurred or badly
// classified ball lie mainly on its rim, then of all similar pixels. Unclassified pixels with this
// chroma also count as ball.
void BallSpecialist::learnColor(const CameraImage& picture, const Cluster& cluster) {
  constexpr int samples = 12;
  constexpr double similar = 20;
  for (int pass = 0; pass < 2; ++pass) {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < samples * samples; ++i) {
      const Vector2d part{(i % samples + 0.5) / samples, (i / samples + 0.5) / samples};
      const Vector2d p = cluster.low + part.cwiseProduct(cluster.high - cluster.low);
      if (!picture.contains(p)) continue;
      const Pixel& pixel = picture.image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
      const ColorClass c = picture.colors[pixel];
      const bool like = pass > 0 && c == ColorClass::noColor &&
                        std::abs(pixel.cb - cb_) < similar && std::abs(pixel.cr - cr_) < similar;
      if (c == ColorClass::orange || like) sum += Vector3d(1, pixel.cb, pixel.cr);
    }
    if (sum[0] == 0) continue;
    cb_ = sum[1] / sum[0];
    cr_ = sum[2] / sum[0];
  }
}

bool BallSpecialist::isBall(const Pixel& pixel, ColorClass color) const {
  constexpr double similar = 14;
  return color == ColorClass::orange || color == ColorClass::red ||
         (color == ColorClass::noColor && std::abs(pixel.cb - cb_) < similar &&
          std::abs(pixel.cr - cr_) < similar);
}

// Returns whether an edge is the ball's boundary. The edge of an orange highlight on a red object
// is not: it is followed by at least as much red.
bool BallSpecialist::isBoundary(const CameraImage& picture, const Vector2d& edge,
                                const Vector2d& way) {
  constexpr double lessRed = 12;
  const Vector2d beyond = edge + way * away;
  return !picture.contains(beyond) ||
         picture.colorAt(beyond).z() < picture.colorAt(edge - way * away).z() - lessRed;
}

// Follows paths from within the ball to all sides. Finds points with subpixel accuracy, also left
// and right, where scan lines are tangential.
void BallSpecialist::traceBoundary(const CameraImage& picture, const Vector2d& inside) {
  points_.clear();
  traced_ = 0;
  for (int i = 0; i < traceRays; ++i) {
    const Vector2d way = direction(2 * pi * i / traceRays);
    const ColorEdge edge = picture.findEdgeOf(
        inside, way, maxGap, [this](const Pixel& pixel, ColorClass c) { return isBall(pixel, c); });
    if (edge.onBorder) continue;
    ++traced_;
    if (isBoundary(picture, edge.point, way))
      points_.push_back({edge.point, classBeyond(picture, edge.point, way), false});
  }
}

// The rays that touch a sphere form a cone: all of them have the same angle to its axis, so ray . n
// = 1 with n = axis / cos(angle), which is linear in n. The first fit uses the points next to green
// if they are enough, because others may lie on an object that hides the ball. Then all points
// close to the cone count.
bool BallSpecialist::fitCone(const CameraImage& picture, BallCone& cone) const {
  const std::size_t n = std::min<std::size_t>(points_.size(), traceRays);
  if (n < minForCone) return false;
  const double focal = focalLength(picture.matrix.info);
  std::array<Vector3d, traceRays> rays;
  std::array<bool, traceRays> used{};
  std::size_t inliers = 0;
  for (std::size_t i = 0; i < n; ++i) {
    rays[i] = picture.ray(points_[i].position);
    used[i] = points_[i].beyond == ColorClass::green;
    inliers += used[i] ? 1 : 0;
  }
  if (inliers < minForCone - 2) used.fill(true);
  for (int iteration = 0; iteration < 5; ++iteration) {
    Matrix3d a = Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    double hidden = 0, sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!used[i]) continue;
      const double weight = points_[i].beyond == ColorClass::green ? 1 : 0.4;
      hidden += robotColors.contains(points_[i].beyond) ? weight : 0;
      sum += weight;
      a += weight * rays[i] * rays[i].transpose();
      b += weight * rays[i];
    }
    const Vector3d normal = a.ldlt().solve(b);
    const double length = normal.norm();
    if (!(length > 1)) return false;
    cone.axis = normal / length;
    cone.angle = std::acos(1 / length);
    cone.error = angleError(cone, a, focal);
    cone.error = std::hypot(cone.error, hiddenError * hidden / sum * cone.angle);
    const double limit = std::max(1.0, (0.4 - 0.08 * iteration) * cone.angle * focal);
    inliers = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = std::acos(std::clamp(rays[i].dot(cone.axis), -1.0, 1.0));
      used[i] = std::abs(angle - cone.angle) * focal <= limit;
      inliers += used[i] ? 1 : 0;
    }
    if (inliers < minForCone || 2 * inliers < static_cast<std::size_t>(traced_)) return false;
  }
  return true;
}

bool BallSpecialist::look(const CameraImage& picture, std::span<const BallSegment> segments,
                          const Cluster& cluster, double ballRadius, BallPercept& percept) {
  BallCone cone;
  if (!locate(picture, segments, cluster, ballRadius, cone)) return false;
  if (!describeBall(picture, cone, ballRadius, percept)) return false;
  percept.seen = isOnGround(picture, percept, cone.axis, ballRadius) &&
                 isOnGreen(picture, percept) && isOrange(picture, percept);
  return percept.seen;
}

// The report's cases: three points of the boundary define a circle, a single one is the highest or
// lowest point, and without any the ball fills the image. If the boundary can be traced, all of its
// points replace the circle's three.
bool BallSpecialist::locate(const CameraImage& picture, std::span<const BallSegment> segments,
                            const Cluster& cluster, double ballRadius, BallCone& cone) {
  Vector2d inside = Vector2d::Zero();
  double total = 0;
  for (const std::size_t i : cluster.segments) {
    inside += (segments[i].upper + segments[i].lower) / 2 * segments[i].orange;
    total += segments[i].orange;
  }
  inside /= total;
  collectPoints(segments, cluster);
  const bool circle = circleCone(picture, cone);
  const bool point = !circle && pointCone(picture, ballRadius, cone);
  if (!circle && !point) {
    if (!points_.empty()) return false;
    cone = {picture.ray(inside)};
  }
  const BallCone first = cone;
  learnColor(picture, cluster);
  traceBoundary(picture, inside);
  if (!fitCone(picture, cone)) cone = first;
  if (cone.angle > 0) cone.angle += radiusLoss / focalLength(picture.matrix.info);
  return true;
}

// Uses the two points with the largest distance from each other, and the one farthest from both. A
// point next to green is preferred: its distance counts double.
bool BallSpecialist::circleCone(const CameraImage& picture, BallCone& cone) const {
  if (points_.size() < 3) return false;
  const auto trust = [](const BoundaryPoint& p) { return p.beyond == ColorClass::green ? 2 : 1; };
  const BoundaryPoint *a = nullptr, *b = nullptr, *c = nullptr;
  double best = 0;
  for (const BoundaryPoint& p : points_)
    for (const BoundaryPoint& q : points_) {
      const double value = (p.position - q.position).norm() * trust(p) * trust(q);
      if (value <= best) continue;
      best = value;
      a = &p;
      b = &q;
    }
  if (!a) return false;
  best = 0;
  for (const BoundaryPoint& p : points_) {
    const double value =
        std::min((p.position - a->position).norm(), (p.position - b->position).norm()) * trust(p);
    if (value <= best) continue;
    best = value;
    c = &p;
  }
  Vector2d center;
  if (!c || !intersectPerpendiculars(a->position, b->position, c->position, center)) return false;
  const double radius = (a->position - center).norm();
  cone.axis = picture.ray(center);
  const Vector3d side = picture.ray(center + picture.horizon.along * radius);
  cone.angle = std::acos(std::clamp(cone.axis.dot(side), -1.0, 1.0));
  Matrix3d points = Matrix3d::Zero();
  for (const BoundaryPoint* p : {a, b, c}) {
    const Vector3d ray = picture.ray(p->position);
    points += ray * ray.transpose();
  }
  cone.error = angleError(cone, points, focalLength(picture.matrix.info));
  return cone.angle > 0;
}

// A highest point lies on the plane through the ball's top, a lowest one on the ground.
bool BallSpecialist::pointCone(const CameraImage& picture, double ballRadius,
                               BallCone& cone) const {
  if (points_.empty()) return false;
  const BoundaryPoint& point = points_.front();
  const Vector3d camera = picture.matrix.pose.translation;
  const Vector3d ray = picture.ray(point.position);
  const double down = camera.z() - (point.upper ? 2 * ballRadius : 0);
  if (ray.z() >= 0 || down <= 0) return false;
  Vector3d center = camera - ray * (down / ray.z());
  center.z() = ballRadius;
  cone = {(center - camera).normalized()};
  return true;
}

// Any small orange object looks like a ball far away, but a ball lies on the field. Without a
// camera matrix, as during kicks, this test is the only one that rejects a shirt.
bool BallSpecialist::isOnGreen(const CameraImage& picture, const BallPercept& percept) const {
  constexpr double small = 4;  // Pixels.
  if (picture.matrix.valid && percept.radiusInImage > small) return true;
  const auto green = std::ranges::count(points_, ColorClass::green, &BoundaryPoint::beyond);
  return 8 * static_cast<std::size_t>(green) >= points_.size();
}

// A disk around the place where the ball should be must be orange, and what is around it must not
// (report 3.2.3).
bool BallSpecialist::isOrange(const CameraImage& picture, const BallPercept& percept) const {
  constexpr int directions = 12;
  const auto countOn = [&](double part, int& pixels, int& orange, int& red, int& ball) {
    for (int i = 0; i < directions; ++i) {
      const Vector2d p = percept.centerInImage +
                         direction(2 * pi * i / directions) * (percept.radiusInImage * part);
      if (!picture.contains(p)) continue;
      const Pixel& pixel = picture.image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
      const ColorClass c = picture.colors[pixel];
      ++pixels;
      orange += c == ColorClass::orange ? 1 : 0;
      red += c == ColorClass::red ? 1 : 0;
      ball += isBall(pixel, c) ? 1 : 0;
    }
  };
  int pixels = 0, orange = 0, red = 0, ball = 0;
  for (const double part : {0.15, 0.5, 0.8}) countOn(part, pixels, orange, red, ball);
  if (2 * ball < pixels || 6 * orange < ball || 2 * red > orange) return false;
  // What is not known to be round must at least be well visible.
  const int enough = percept.distanceBySize > 0 ? 3 : directions;
  if (pixels < enough) return false;
  int around = 0, orangeAround = 0, redAround = 0, ballAround = 0;
  countOn(1.4, around, orangeAround, redAround, ballAround);
  return 2 * ballAround <= around;
}

}  // namespace gt
