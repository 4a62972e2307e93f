#pragma once
#include <array>
#include <cstddef>

namespace gt {

/// The angles (rad) at which several scans met the same edge of a landmark (report 3.2.4, 3.2.5).
class EdgeAngles {
 public:
  struct Merged {
    double angle = 0;
    bool onBorder = true;
  };

  void clear() { count_ = 0; }
  void add(double angle, bool onBorder);
  bool empty() const { return count_ == 0; }

  /// The outermost angle, averaged with those within `tolerance` (rad) to reduce the image's noise.
  /// `sign` is 1 if a larger angle lies farther out, otherwise -1. An edge is straight: if less
  /// than `share` of the scans met it, it is hidden, and `onBorder` is set as at the image's
  /// border.
  Merged merge(double sign, double tolerance, double share) const;

 private:
  struct Scan {
    double angle;
    bool onBorder;
  };
  std::array<Scan, 16> scans_{};
  std::size_t count_ = 0;
};

}  // namespace gt
