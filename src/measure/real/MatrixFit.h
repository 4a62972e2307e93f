#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/Geometry.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// By how much a camera matrix is off, as far as lines on the ground show.
struct MatrixCorrection {
  double tilt = 0, roll = 0;  ///< rad, of the camera: what to add, + axis up, + right side down.
  /// Standard errors of both (rad), if the points' errors are independent.
  double tiltError = 0, rollError = 0;
  double distance = 0;  ///< Root mean square distance of the points from the field's lines, pixels.
};

/// Estimates the errors of camera matrices from points on field lines: of all poses on the field
/// and all tilts and rolls of the camera the one whose lines are nearest to those in the image, by
/// least squares with a robust loss. The camera's height is that of the matrix. Straight lines stay
/// straight however the camera is tilted, so it takes right angles, known distances or the center
/// circle.
class MatrixFit {
 public:
  explicit MatrixFit(const FieldDimensions& field);

  /// The correction of a matrix; `lines` are points of the image along the middles of some of the
  /// field's lines, each list of one line. Empty if the image does not carry enough: the standard
  /// errors exceed `largestError`, a clearly different correction fits nearly as well, or none
  /// fits.
  std::optional<MatrixCorrection> fit(const CameraMatrix& matrix,
                                      std::span<const std::vector<Vector2d>> lines) const;

  /// Points along the field's lines (mm), each list of one line.
  const std::vector<std::vector<Vector2d>>& linePoints() const { return linePoints_; }

  static constexpr double largestError = 0.5 * pi / 180;  ///< rad

 private:
  struct Line {
    Vector2d from, to;
    /// Whether a point lies beside the line and not beyond its ends.
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
  Vector2d half_;  ///< Robots stand within this distance of the middle.
  std::vector<std::vector<Vector2d>> linePoints_;
};

/// What a camera sees of some lines on the ground that a robot at a pose sees: points of the image,
/// no nearer to each other than `spacing` pixels. Lines with fewer than two points are left out.
std::vector<std::vector<Vector2d>> linesInImage(const std::vector<std::vector<Vector2d>>& lines,
                                                const CameraMatrix& matrix, const Pose2D& robot,
                                                double spacing);

}  // namespace gt
