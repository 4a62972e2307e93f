#include "measure/real/MatrixFit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "modules/perception/scanning/CameraImage.h"

namespace gt {
namespace {

constexpr double outlier = 15;          // pixels: no point costs more than this distance
constexpr double precision = 1;         // pixels: standard deviation of a point; at least
constexpr double worstFit = 3;          // pixels: a root mean square distance above is none
constexpr double usual = 3 * pi / 180;  // rad: standard deviation of a correction, known before
constexpr double beyondEnd = 150;       // mm: points of a line lie no further beyond its end

double robust(double distance) {
  return std::min(distance * distance, outlier * outlier);
}

/// How the camera turns by a correction.
Matrix3d turned(const Vector2d& heading, double tilt, double roll) {
  const Vector3d vector{roll * heading.x() + tilt * heading.y(),
                        roll * heading.y() - tilt * heading.x(), 0};
  const double angle = vector.norm();
  return angle == 0 ? Matrix3d::Identity().eval()
                    : Eigen::AngleAxisd{angle, vector / angle}.toRotationMatrix();
}

}  // namespace

/// What is known of an image, in the robot's system.
struct MatrixFit::Problem {
  Vector3d camera;                          ///< mm
  Vector2d heading;                         ///< of the optical axis, a unit vector
  double focal;                             ///< pixels
  std::vector<std::vector<Vector3d>> rays;  ///< unit vectors
};

struct MatrixFit::Solution {
  Values values = Values::Zero();
  std::vector<std::size_t> features{};  ///< of each line: index of `lines_`; its size: the circle
  double cost = 0;                      ///< pixel^2
  Normal normal = Normal::Zero();       ///< of the points alone, pixel^2
};

MatrixFit::MatrixFit(const FieldDimensions& f)
    : circleRadius_{f.centerCircleRadius}, half_{f.xGroundline + 300, f.ySideline + 300} {
  const auto add = [&](const Vector2d& from, const Vector2d& to) { lines_.push_back({from, to}); };
  // Walls bound a field instead of lines: then only the goal's mouth has one.
  const bool walls = f.wallHeight > 0;
  const double endLine = walls ? f.yGoal : f.ySideline;
  add({0, -f.ySideline}, {0, f.ySideline});
  for (const double side : {-1., 1.}) {
    add({side * f.xGroundline, -endLine}, {side * f.xGroundline, endLine});
    add({side * f.xPenaltyArea, -f.yPenaltyArea}, {side * f.xPenaltyArea, f.yPenaltyArea});
    for (const double y : {-f.yPenaltyArea, f.yPenaltyArea})
      add({side * f.xPenaltyArea, y}, {side * f.xGroundline, y});
    if (!walls) add({-f.xGroundline, side * f.ySideline}, {f.xGroundline, side * f.ySideline});
  }
  constexpr double step = 20;  // mm
  for (const Line& line : lines_) {
    const int n = static_cast<int>((line.to - line.from).norm() / step);
    std::vector<Vector2d>& points = linePoints_.emplace_back();
    for (int i = 0; i <= n; ++i) points.push_back(line.from + (line.to - line.from) * i / n);
  }
  const int n = static_cast<int>(2 * pi * circleRadius_ / step);
  std::vector<Vector2d>& circle = linePoints_.emplace_back();
  for (int i = 0; i < n; ++i) circle.push_back(circleRadius_ * direction(2 * pi * i / n));
}

/// The field's lines as a camera sees them whose matrix is corrected, from a pose.
class MatrixFit::View {
 public:
  View(const MatrixFit& fit, const Problem& problem, const Values& values)
      : fit_{&fit},
        problem_{&problem},
        pose_{values[4], values[2], values[3]},
        turn_{turned(problem.heading, values[0], values[1])} {
    for (const Line& line : fit.lines_) planes_.push_back(plane(line.from, line.to));
  }

  /// The distance of a ray from a line of the field with a sign, in pixels of the image's middle:
  /// from the plane through camera and line; of the circle, its tangent where it is nearest.
  double distance(const Vector3d& ray, std::size_t feature) const {
    const Vector3d real = turn_ * ray;
    if (feature < planes_.size()) return problem_->focal * real.dot(planes_[feature]);
    const auto at = onField(real);
    return at ? fromCircle(real, *at) : outlier;
  }

  /// What it costs that rays are those of each of the field's lines, the circle last.
  void costs(std::span<const Vector3d> rays, std::vector<double>& costs) const {
    costs.assign(planes_.size() + 1, 0);
    for (const Vector3d& ray : rays) {
      const Vector3d real = turn_ * ray;
      const auto at = onField(real);
      for (std::size_t i = 0; i < planes_.size(); ++i)
        costs[i] += robust(
            at && fit_->lines_[i].contains(*at) ? problem_->focal * real.dot(planes_[i]) : outlier);
      costs.back() += robust(at ? fromCircle(real, *at) : outlier);
    }
  }

 private:
  /// The normal of the plane through the camera and two points of the field.
  Vector3d plane(const Vector2d& a, const Vector2d& b) const {
    const auto seen = [&](const Vector2d& point) {
      const Vector2d p = relative(pose_, point);
      return Vector3d{Vector3d{p.x(), p.y(), 0} - problem_->camera};
    };
    return seen(a).cross(seen(b)).normalized();
  }
  std::optional<Vector2d> onField(const Vector3d& ray) const {
    constexpr double horizon = -1e-3;
    if (ray.z() >= horizon) return {};
    const Vector3d& camera = problem_->camera;
    return pose_ * Vector2d{(camera - camera.z() / ray.z() * ray).head<2>()};
  }
  double fromCircle(const Vector3d& ray, const Vector2d& at) const {
    const Vector2d outward = at.normalized(), touches = fit_->circleRadius_ * outward;
    const Vector2d along = 100 * Vector2d{-outward.y(), outward.x()};
    return problem_->focal * ray.dot(plane(touches, touches + along));
  }

  const MatrixFit* fit_;
  const Problem* problem_;
  Pose2D pose_;
  Matrix3d turn_;
  std::vector<Vector3d> planes_;
};

bool MatrixFit::Line::contains(const Vector2d& point) const {
  const double length = (to - from).norm(), along = (point - from).dot(to - from) / length;
  return along > -beyondEnd && along < length + beyondEnd;
}

/// Makes each line of the image that of the field which costs least. Returns what all cost.
double MatrixFit::assign(const Problem& problem, Solution& s) const {
  const View view{*this, problem, s.values};
  s.features.clear();
  std::vector<double> costs;
  s.cost = (s.values.head<2>() / usual).squaredNorm() * precision * precision;
  for (const auto& rays : problem.rays) {
    view.costs(rays, costs);
    const auto least = std::ranges::min_element(costs);
    s.features.push_back(static_cast<std::size_t>(least - costs.begin()));
    s.cost += *least;
  }
  return s.cost;
}

/// Gauss and Newton with damping (Levenberg and Marquardt), the lines assigned anew each time.
void MatrixFit::refine(const Problem& problem, Solution& s) const {
  constexpr double prior = precision * precision / (usual * usual);
  double damping = 1e-3;
  assign(problem, s);
  for (int iteration = 0; iteration < 40 && damping < 1e6; ++iteration) {
    Values slope = normalEquations(problem, s);
    Normal damped = s.normal;
    damped.diagonal().head<2>().array() += prior;
    slope.head<2>() += prior * s.values.head<2>();
    damped.diagonal() *= 1 + damping;
    Solution next = s;
    next.values -= Values{damped.ldlt().solve(slope)};
    if (!next.values.allFinite()) return;
    if (assign(problem, next) < s.cost) {
      const bool enough = s.cost - next.cost <= 1e-4 * s.cost;
      s = std::move(next);
      damping /= 10;
      if (enough) return;
    } else {
      damping *= 10;
    }
  }
}

/// Fills in the normal matrix and returns half of the cost's gradient.
MatrixFit::Values MatrixFit::normalEquations(const Problem& problem, Solution& s) const {
  constexpr std::array<double, unknowns> steps{1e-5, 1e-5, 0.1, 0.1, 1e-5};
  const View view{*this, problem, s.values};
  std::vector<View> moved;
  for (int k = 0; k < unknowns; ++k) {
    Values values = s.values;
    values[k] += steps[static_cast<std::size_t>(k)];
    moved.emplace_back(*this, problem, values);
  }
  s.normal.setZero();
  Values slope = Values::Zero(), gradient;
  for (std::size_t line = 0; line < problem.rays.size(); ++line)
    for (const Vector3d& ray : problem.rays[line]) {
      const double r = view.distance(ray, s.features[line]);
      if (std::abs(r) >= outlier) continue;
      for (std::size_t k = 0; k < unknowns; ++k)
        gradient[static_cast<Eigen::Index>(k)] =
            (moved[k].distance(ray, s.features[line]) - r) / steps[k];
      s.normal += gradient * gradient.transpose();
      slope += r * gradient;
    }
  return slope;
}

/// The poses that fit best as the matrix is, from all over the field, refined: best first.
std::vector<MatrixFit::Solution> MatrixFit::search(const Problem& problem) const {
  constexpr double step = 300, turn = pi / 12;
  constexpr std::size_t kept = 30;
  // Few points of each line do to begin with.
  constexpr std::size_t few = 4;
  Problem sparse = problem;
  for (auto& line : sparse.rays) {
    const std::vector<Vector3d> all = line;
    if (all.size() <= few) continue;
    line.clear();
    for (std::size_t i = 0; i < few; ++i) line.push_back(all[i * (all.size() - 1) / (few - 1)]);
  }
  std::vector<Solution> solutions;
  // The field looks the same from the opposite side.
  for (double rotation = 0; rotation < pi - turn / 2; rotation += turn)
    for (double x = -half_.x(); x <= half_.x(); x += step)
      for (double y = -half_.y(); y <= half_.y(); y += step) {
        Solution& s = solutions.emplace_back();
        s.values << 0, 0, x, y, rotation;
        assign(sparse, s);
      }
  const std::size_t n = std::min(kept, solutions.size());
  const auto cheaper = [](const Solution& a, const Solution& b) { return a.cost < b.cost; };
  std::partial_sort(solutions.begin(), solutions.begin() + static_cast<std::ptrdiff_t>(n),
                    solutions.end(), cheaper);
  solutions.resize(n);
  for (Solution& s : solutions) refine(problem, s);
  std::sort(solutions.begin(), solutions.end(), cheaper);
  return solutions;
}

std::optional<MatrixCorrection> MatrixFit::fit(const CameraMatrix& matrix,
                                               std::span<const std::vector<Vector2d>> lines) const {
  const Vector2d heading{matrix.pose.rotation.col(0).head<2>().normalized()};
  Problem problem{matrix.pose.translation, heading, matrix.info.focalX, {}};
  std::size_t points = 0;
  for (const auto& line : lines) {
    std::vector<Vector3d>& rays = problem.rays.emplace_back();
    for (const Vector2d& p : line) rays.push_back(matrix.ray(p.x(), p.y()).normalized());
    points += rays.size();
  }
  if (lines.size() < 2 || points <= unknowns) return {};
  const std::vector<Solution> solutions = search(problem);
  const Solution& best = solutions.front();
  const double n = static_cast<double>(points);
  MatrixCorrection found{
      .tilt = best.values[0], .roll = best.values[1], .distance = std::sqrt(best.cost / n)};
  // A correction that nobody would expect comes from lines taken for others.
  if (found.distance > worstFit || best.values.head<2>().cwiseAbs().maxCoeff() > 2 * usual)
    return {};
  const double variance = std::max(best.cost / n, precision * precision);
  const Eigen::FullPivLU<Normal> normal{best.normal};
  if (!normal.isInvertible()) return {};
  const Normal covariance = variance * normal.inverse();
  found.tiltError = std::sqrt(covariance(0, 0));
  found.rollError = std::sqrt(covariance(1, 1));
  if (!(found.tiltError <= largestError && found.rollError <= largestError)) return {};
  // Chi-squared of 2 degrees of freedom exceeds 9.2 in 1 of 100 cases.
  constexpr double clearly = 9.2;
  for (const Solution& s : solutions) {
    const bool differs = (s.values - best.values).head<2>().norm() > 2 * largestError;
    if (differs && s.cost - best.cost < clearly * variance) return {};
  }
  return found;
}

std::vector<std::vector<Vector2d>> linesInImage(const std::vector<std::vector<Vector2d>>& lines,
                                                const CameraMatrix& matrix, const Pose2D& robot,
                                                double spacing) {
  std::vector<std::vector<Vector2d>> seen;
  for (const auto& line : lines) {
    std::vector<Vector2d> points;
    for (const Vector2d& onField : line) {
      const Vector2d p = relative(robot, onField);
      const Vector3d ray = Vector3d{p.x(), p.y(), 0} - matrix.pose.translation;
      constexpr double nearest = 50;  // mm along the optical axis
      if (ray.dot(matrix.pose.rotation.col(0)) < nearest) continue;
      const Vector2d at = pointIn(matrix, ray);
      if (!matrix.info.contains(at.x(), at.y())) continue;
      if (std::ranges::any_of(points, [&](const auto& q) { return (q - at).norm() < spacing; }))
        continue;
      points.push_back(at);
    }
    if (points.size() > 1) seen.push_back(std::move(points));
  }
  return seen;
}

}  // namespace gt
