#pragma once
#include <Eigen/Core>
#include <algorithm>

namespace gt {

/// State and covariance of a Kalman filter. If the innovation of a measurement is larger than two
/// standard deviations, the variance of its noise is increased to match. Outliers therefore change
/// the state little, and real changes still do.
template <int n>
struct RobustEstimate {
  using Vector = Eigen::Matrix<double, n, 1>;
  using Matrix = Eigen::Matrix<double, n, n>;

  Vector value = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  /// The innovation of a measurement, in standard deviations. The measurement is row * value with
  /// noise of a variance.
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
