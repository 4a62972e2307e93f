#include "modules/perception/calibration/CameraCalibrator.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "base/NumericJacobian.h"
#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"

namespace gt {
namespace {

Pose3D cameraPoseFor(const RobotDimensions& robot, const RobotCalibration& body,
                     const JointAngles& joints) {
  return cameraPose(robot, bodyPose(bodyPosture(robot, body, joints)),
                    {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]});
}

}  // namespace

void CameraCalibrator::add(std::span<const Vector2d> corners, const JointAngles& joints) {
  views_.push_back({{corners.begin(), corners.end()}, joints});
}

// First guess of the board's pose, from the first image: at the distance given by its size,
// perpendicular to the view.
CameraCalibrator::Values CameraCalibrator::guess(const CameraInfo& camera,
                                                 const RobotDimensions& robot,
                                                 const RobotCalibration& body) const {
  const View& view = views_.front();
  const auto columns = static_cast<std::size_t>(board_.columns);
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& c : view.corners) middle += c / static_cast<double>(view.corners.size());
  const double height = (view.corners.back() - view.corners[columns - 1]).norm();
  const double distance = camera.focalY * board_.square * (board_.rows - 1) / std::max(height, 1.);
  const Pose3D pose = cameraPoseFor(robot, body, view.joints);
  const Vector3d place = pose * (distance * camera.ray(middle.x(), middle.y()));
  Values values;
  values << camera.focalX, camera.focalY, body.bodyTiltOffset, body.bodyRollOffset, place.x(),
      place.y(), std::atan2(place.y(), place.x());
  return values;
}

/// The position of corner `i` relative to the robot (mm); corners are numbered row by row from top
/// left.
Vector3d CameraCalibrator::corner(const Values& values, std::size_t i) const {
  const int column = static_cast<int>(i) % board_.columns;
  const int row = static_cast<int>(i) / board_.columns;
  const double left = ((board_.columns - 1) / 2.0 - column) * board_.square;
  const Vector2d at =
      Vector2d{values[boardX], values[boardY]} + rotated(Vector2d{0, left}, values[boardTurn]);
  return {at.x(), at.y(), board_.height + (board_.rows - 1 - row) * board_.square};
}

Eigen::VectorXd CameraCalibrator::residuals(const Problem& problem, const Values& values) const {
  std::size_t corners = 0;
  for (const View& view : views_) corners += view.corners.size();
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(2 * corners));
  Eigen::Index next = 0;
  CameraInfo camera = problem.camera;
  camera.focalX = values[focalX];
  camera.focalY = values[focalY];
  const RobotCalibration body{values[bodyTilt], values[bodyRoll]};
  for (const View& view : views_) {
    const Pose3D pose = cameraPoseFor(problem.robot, body, view.joints);
    for (std::size_t i = 0; i < view.corners.size(); ++i) {
      Vector3d inCamera = pose.rotation.transpose() * (corner(values, i) - pose.translation);
      inCamera.x() = std::max(inCamera.x(), 1.0);
      residuals.segment<2>(next) = camera.project(inCamera) - view.corners[i];
      next += 2;
    }
  }
  return residuals;
}

CameraCalibrator::Fit CameraCalibrator::fit(const Problem& problem, const Values& first) const {
  constexpr int iterations = 60;
  constexpr double enough = 1e-9;
  Values steps;
  steps << 0.01, 0.01, 1e-5, 1e-5, 0.01, 0.01, 1e-5;
  const auto off = [&](const Values& values) { return residuals(problem, values); };
  Fit fit;
  fit.values = first;
  fit.residuals = off(fit.values);
  fit.error = fit.residuals.squaredNorm();
  double damping = 1e-3;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const auto derivatives = numericJacobian(off, fit.values, steps);
    fit.normal = derivatives.transpose() * derivatives;
    const Values slope = derivatives.transpose() * fit.residuals;
    const double before = fit.error;
    for (int attempt = 0; attempt < 10; ++attempt) {
      Normal damped = fit.normal;
      damped.diagonal() *= 1 + damping;
      const Values next = fit.values - Values{damped.ldlt().solve(slope)};
      Eigen::VectorXd moved = off(next);
      const double nextError = moved.squaredNorm();
      if (std::isfinite(nextError) && nextError < fit.error) {
        fit.values = next;
        fit.error = nextError;
        fit.residuals = std::move(moved);
        damping /= 10;
        break;
      }
      damping *= 10;
    }
    if (before - fit.error <= enough * before) break;
  }
  return fit;
}

bool CameraCalibrator::calibrate(const CameraInfo& camera, const RobotDimensions& robot,
                                 const RobotCalibration& body, CameraCalibration& result) const {
  if (views_.empty()) return false;
  const auto [values, residuals, error, normal] = fit({camera, robot}, guess(camera, robot, body));
  const double freedom = static_cast<double>(residuals.size()) - unknowns;
  const Normal covariance = normal.inverse() * (error / std::max(freedom, 1.0));
  if (freedom <= 0 || !covariance.allFinite() || !values.allFinite() || values[focalX] <= 1 ||
      values[focalY] <= 1)
    return false;
  CameraInfo found = camera;
  found.focalX = values[focalX];
  found.focalY = values[focalY];
  result.pictures = static_cast<int>(views_.size());
  result.focalX = found.focalX;
  result.focalY = found.focalY;
  result.openingAngleX = found.openingAngleX();
  result.openingAngleY = found.openingAngleY();
  result.body = {values[bodyTilt], values[bodyRoll]};
  result.boardPosition = {values[boardX], values[boardY]};
  result.boardRotation = normalize(values[boardTurn]);
  result.error = std::sqrt(2 * error / static_cast<double>(residuals.size()));
  const double focalError =
      std::sqrt(std::max(covariance(focalX, focalX), covariance(focalY, focalY)));
  result.openingAngleError = focalError * camera.width / (found.focalX * found.focalX);
  result.offsetError =
      std::sqrt(std::max(covariance(bodyTilt, bodyTilt), covariance(bodyRoll, bodyRoll)));
  return true;
}

}  // namespace gt
