#pragma once
#include <Eigen/Core>
#include <algorithm>

namespace gt {

/// What is known of some numbers, and how well: a Kalman filter's state. A measurement that is
/// further off than two standard deviations counts as if its noise explained that, so that errors
/// move it little and what is really far off still moves it.
template <int n>
struct RobustEstimate {
  using Vector = Eigen::Matrix<double, n, 1>;
  using Matrix = Eigen::Matrix<double, n, n>;

  Vector value = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  /// By how many standard deviations a measurement, row * value with noise of a variance, is off.
  double surprise(const Vector& row, double measured, double variance) const {
    return std::abs(measured - row.dot(value)) / std::sqrt(row.dot(covariance * row) + variance);
  }
  void add(const Vector& row, double measured, double variance) {
    constexpr double usual = 2;  // standard deviations
    const Vector shared = covariance * row;
    const double off = measured - row.dot(value);
    const double spread = std::max(row.dot(shared) + variance, off * off / (usual * usual));
    value += shared * (off / spread);
    covariance -= shared * shared.transpose() / spread;
  }
};

}  // namespace gt
