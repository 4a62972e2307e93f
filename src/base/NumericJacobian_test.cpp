#include "base/NumericJacobian.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gt {
namespace {

TEST(NumericJacobian, IsExactUpToSquares) {
  const auto squares = [](const Eigen::Vector2d& x) {
    return Eigen::Vector3d{x[0] * x[0], x[0] * x[1], 3 * x[1]};
  };
  Eigen::Matrix<double, 3, 2> expected;
  expected << 4, 0, 5, 2, 0, 3;
  const auto found = numericJacobian(squares, Eigen::Vector2d{2, 5}, Eigen::Vector2d{0.1, 1});
  static_assert(decltype(found)::RowsAtCompileTime == 3);
  EXPECT_LT((found - expected).norm(), 1e-12);
}

TEST(NumericJacobian, TakesFunctionsWhoseSizeIsKnownLater) {
  const auto sines = [](const Eigen::VectorXd& x) -> Eigen::VectorXd { return x.array().sin(); };
  const Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(4, 0, 3);
  const Eigen::VectorXd steps = Eigen::VectorXd::Constant(4, 1e-4);
  const Eigen::MatrixXd expected = at.array().cos().matrix().asDiagonal();
  EXPECT_LT((numericJacobian(sines, at, steps) - expected).norm(), 1e-8);
}

}  // namespace
}  // namespace gt
