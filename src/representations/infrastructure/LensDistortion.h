#pragma once

namespace gt {

/// Radially symmetric distortion of a lens (Brown 1966): a point that an ideal camera images at a
/// distance r from the optical axis appears at r (1 + k2 r^2 + k4 r^4). Distances are in focal
/// lengths. Negative coefficients cause barrel, positive ones pincushion distortion.
struct LensDistortion {
  double k2 = 0, k4 = 0;

  bool none() const { return k2 == 0 && k4 == 0; }
  /// The factor by which the distortion scales a distance from the optical axis, given the square
  /// of the undistorted distance. Beyond the radius at which the polynomial is no longer monotonic,
  /// the factor is constant.
  double factor(double square) const;
  /// The factor that undoes the distortion, given the square of the distorted distance.
  double undoing(double square) const;
  /// The square of the undistorted distance from which on the factor is constant; may be infinite.
  double limit() const;
};

}  // namespace gt
