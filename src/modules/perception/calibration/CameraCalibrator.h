#pragma once
#include <span>
#include <vector>

#include "modules/perception/calibration/CheckerboardFinder.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// What a robot learns of its camera and its body by looking at a checkerboard. Provided by the
/// CheckerboardDetector.
struct CameraCalibration {
  int pictures = 0;
  double focalX = 0, focalY = 0;
  double openingAngleX = 0, openingAngleY = 0;
  RobotCalibration body;
  Vector2d boardPosition = Vector2d::Zero();
  double boardRotation = 0;
  double error = 0;
  double openingAngleError = 0, offsetError = 0;

  static constexpr auto fields() {
    return Fields{
        field<&CameraCalibration::pictures>("that it was made from"),
        field<&CameraCalibration::focalX>(Unit::pixel),
        field<&CameraCalibration::focalY>(Unit::pixel),
        field<&CameraCalibration::openingAngleX>(Unit::rad),
        field<&CameraCalibration::openingAngleY>(Unit::rad),
        field<&CameraCalibration::body>("what belongs into robot.cfg"),
        field<&CameraCalibration::boardPosition>(
            Unit::mm, "the board's middle on the ground, relative to the robot"),
        field<&CameraCalibration::boardRotation>(Unit::rad,
                                                 "0 if it stands across the robot's x axis"),
        field<&CameraCalibration::error>(
            Unit::pixel, "root mean square of how far corners lie from where they should be seen"),
        field<&CameraCalibration::openingAngleError>(Unit::rad,
                                                     "standard deviation, by the corners' scatter"),
        field<&CameraCalibration::offsetError>(
            Unit::rad, "standard deviation of the body's tilt and roll, by the corners' scatter")};
  }
};

/// Calibrates camera and body from images of a checkerboard that stands before a robot, which
/// stands still and looks around: opening angles, the corrections of robot.cfg (report B.4.5), and
/// where the board is, such that all corners are seen where they are, as far as can be (least
/// squares by Levenberg and Marquardt).
class CameraCalibrator {
 public:
  explicit CameraCalibrator(const Checkerboard& board) : board_{board} {}

  /// An image with the board's corners, as CheckerboardFinder finds them, and the joints when it
  /// was taken.
  void add(std::span<const Vector2d> corners, const JointAngles& joints);
  std::size_t pictures() const { return views_.size(); }
  void clear() { views_.clear(); }

  /// Begins with what is known of the camera and the body. False if the images do not tell
  /// enough.
  bool calibrate(const CameraInfo& camera, const RobotDimensions& robot,
                 const RobotCalibration& body, CameraCalibration& result) const;

 private:
  struct View {
    std::vector<Vector2d> corners;
    JointAngles joints;
  };
  /// What is unknown.
  static constexpr int unknowns = 7;
  using Values = Eigen::Matrix<double, unknowns, 1>;
  using Normal = Eigen::Matrix<double, unknowns, unknowns>;
  enum { focalX, focalY, bodyTilt, bodyRoll, boardX, boardY, boardTurn };
  struct Problem {
    const CameraInfo& camera;
    const RobotDimensions& robot;
  };
  /// The values with the least squared error that were found.
  struct Fit {
    Values values;
    std::vector<double> residuals;
    double error = 0;                    ///< Sum of their squares.
    Normal normal = Normal::Identity();  ///< Of the last step: J^T J.
  };

  Values guess(const CameraInfo& camera, const RobotDimensions& robot,
               const RobotCalibration& body) const;
  Vector3d corner(const Values& values, std::size_t i) const;
  void residuals(const Problem& problem, const Values& values, std::vector<double>& out) const;
  double squaredError(const Problem& problem, const Values& values, std::vector<double>& out) const;
  /// The derivatives of the residuals with respect to the values.
  Eigen::MatrixXd jacobian(const Problem& problem, const Fit& fit) const;
  Fit fit(const Problem& problem, const Values& first) const;

  Checkerboard board_;
  std::vector<View> views_;
};

}  // namespace gt
