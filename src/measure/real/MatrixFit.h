#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/Geometry.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// The error of a camera matrix, estimated from lines on the ground.
struct MatrixCorrection {
  double tilt = 0, roll = 0;  ///< rad, to be added to the camera's rotation: + axis up, + right
                              ///< side down.
  /// Standard errors of both (rad), if the points' errors are independent.
  double tiltError = 0, rollError = 0;
  double distance = 0;  ///< Root mean square distance of the points from the field's lines, pixels.
};

/// Estimates the errors of camera matrices from points on field lines. Searches the pose on the
/// field and the tilt and roll of the camera for which the field's lines are nearest to those in
/// the image, by least squares with a robust loss. The camera's height is that of the matrix. Since
/// straight lines remain straight for any tilt of the camera, right angles, known distances or the
/// center circle must be visible.
class MatrixFit {
 public:
  explicit MatrixFit(const FieldDimensions& field);

  /// The correction of a matrix. `lines` are points of the image (pixels) along the centers of some
  /// of the field's lines; each list belongs to one line. Empty if the image is insufficient: if
  /// the standard errors exceed `largestError`, a clearly different correction fits nearly as well,
  /// or no correction fits.
  std::optional<MatrixCorrection> fit(const CameraMatrix& matrix,
                                      std::span<const std::vector<Vector2d>> lines) const;

  /// Points along the field's lines (mm, on the field); each list belongs to one line.
  const std::vector<std::vector<Vector2d>>& linePoints() const { return linePoints_; }

  static constexpr double largestError = 0.5 * pi / 180;  ///< rad

 private:
  struct Line {
    Vector2d from, to;
    /// Whether a point, projected onto the line, lies between its ends (with a margin).
    bool contains(const Vector2d& point) const;
  };
  class View;
  struct Problem;
  struct Solution;
  static constexpr int unknowns = 5;  // tilt, roll, x, y, rotation
  using Values = Eigen::Matrix<double, unknowns, 1>;
  using Normal = Eigen::Matrix<double, unknowns, unknowns>;

  double assign(const Problem& problem, Solution& s) const;
  Values normalEquations(const Problem& problem, Solution& s) const;
  void refine(const Problem& problem, Solution& s) const;
  std::vector<Solution> search(const Problem& problem) const;

  std::vector<Line> lines_;
  double circleRadius_;
  Vector2d half_;  ///< Greatest distances (mm) of robots from the field's center, along x and y.
  std::vector<std::vector<Vector2d>> linePoints_;
};

/// The visible part of some lines on the ground, for a camera of a robot at a pose: points of the
/// image, at least `spacing` pixels apart. Lines with fewer than two points are left out.
std::vector<std::vector<Vector2d>> linesInImage(const std::vector<std::vector<Vector2d>>& lines,
                                                const CameraMatrix& matrix, const Pose2D& robot,
                                                double spacing);

}  // namespace gt
