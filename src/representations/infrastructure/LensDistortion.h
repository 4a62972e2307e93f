#pragma once

namespace gt {

/// How a lens bends what an ideal camera would see, the same all round (Brown 1966): what should be
/// seen at a distance r from the optical axis is seen at r (1 + k2 r^2 + k4 r^4). Distances are in
/// focal lengths. Negative numbers make a barrel, positive ones a cushion.
struct LensDistortion {
  double k2 = 0, k4 = 0;

  bool none() const { return k2 == 0 && k4 == 0; }
  /// By how much a distance grows, of the square of the true one. Where the formula would turn back
  /// the lens is taken as an even one.
  double factor(double square) const;
  /// By how much a distance grows if the distortion is undone, of the square of what is seen.
  double undoing(double square) const;
  /// The square of the distance from which on the lens is taken as an even one; may be infinite.
  double limit() const;
};

}  // namespace gt
