#pragma once
#include <span>
#include <vector>

#include "modules/perception/calibration/CheckerboardFinder.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// The calibration of a robot's camera and body by images of a checkerboard, provided by the
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
        field<&CameraCalibration::pictures>("number of images used for the calibration"),
        field<&CameraCalibration::focalX>(Unit::pixel),
        field<&CameraCalibration::focalY>(Unit::pixel),
        field<&CameraCalibration::openingAngleX>(Unit::rad),
        field<&CameraCalibration::openingAngleY>(Unit::rad),
        field<&CameraCalibration::body>("corrections of the body and the head, as in robot.cfg"),
        field<&CameraCalibration::boardPosition>(
            Unit::mm, "position of the board's middle on the ground, relative to the robot"),
        field<&CameraCalibration::boardRotation>(
            Unit::rad, "rotation of the board; 0 if it is perpendicular to the robot's x axis"),
        field<&CameraCalibration::error>(
            Unit::pixel, "root mean square of the distances between seen and expected corners"),
        field<&CameraCalibration::openingAngleError>(
            Unit::rad, "standard deviation of the opening angles, from the scatter of the corners"),
        field<&CameraCalibration::offsetError>(
            Unit::rad,
            "standard deviation of the body's tilt and roll, from the scatter of the corners")};
  }
};

/// Calibrates camera and body from images of a checkerboard that stands in front of a robot, which
/// stands still and looks around. Estimates opening angles, the corrections in robot.cfg (report
/// B.4.5), and the pose of the board by minimizing the squared distances between seen and expected
/// corners (Levenberg-Marquardt).
class CameraCalibrator {
 public:
  explicit CameraCalibrator(const Checkerboard& board) : board_{board} {}

  /// Adds an image: the board's corners (pixels) as found by CheckerboardFinder, and the joint
  /// angles at the image's exposure.
  void add(std::span<const Vector2d> corners, const JointAngles& joints);
  std::size_t pictures() const { return views_.size(); }
  void clear() { views_.clear(); }

  /// Calibrates, starting from the given camera and body. Returns false if the images do not
  /// determine the result.
  bool calibrate(const CameraInfo& camera, const RobotDimensions& robot,
                 const RobotCalibration& body, CameraCalibration& result) const;

 private:
  struct View {
    std::vector<Vector2d> corners;
    JointAngles joints;
  };
  /// The unknowns, in the order of the enumeration.
  static constexpr int unknowns = 7;
  using Values = Eigen::Matrix<double, unknowns, 1>;
  using Normal = Eigen::Matrix<double, unknowns, unknowns>;
  enum { focalX, focalY, bodyTilt, bodyRoll, boardX, boardY, boardTurn };
  struct Problem {
    const CameraInfo& camera;
    const RobotDimensions& robot;
  };
  /// The values with the least squared error found so far.
  struct Fit {
    Values values;
    Eigen::VectorXd residuals;           ///< Differences of the corners' places, pixels.
    double error = 0;                    ///< Sum of the squared residuals.
    Normal normal = Normal::Identity();  ///< J^T J of the last step.
  };

  Values guess(const CameraInfo& camera, const RobotDimensions& robot,
               const RobotCalibration& body) const;
  Vector3d corner(const Values& values, std::size_t i) const;
  Eigen::VectorXd residuals(const Problem& problem, const Values& values) const;
  Fit fit(const Problem& problem, const Values& first) const;

  Checkerboard board_;
  std::vector<View> views_;
};

}  // namespace gt
