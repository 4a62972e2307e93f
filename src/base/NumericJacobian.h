#pragma once
#include <Eigen/Core>
#include <type_traits>

namespace gt {

/// Differentiates a function from vectors to vectors by central differences: column i is the
/// derivative of its value with respect to argument i, which is changed by `steps[i]` to both sides.
template <class Function, class Arguments>
auto numericJacobian(const Function& function, const Arguments& at, const Arguments& steps) {
  using Values = std::decay_t<std::invoke_result_t<const Function&, const Arguments&>>;
  Eigen::Matrix<double, Values::RowsAtCompileTime, Arguments::RowsAtCompileTime> jacobian;
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    Arguments below = at, above = at;
    below[i] -= steps[i];
    above[i] += steps[i];
    const Values change = function(above) - function(below);
    if (i == 0) jacobian.resize(change.size(), at.size());
    jacobian.col(i) = change / (2 * steps[i]);
  }
  return jacobian;
}

}  // namespace gt
