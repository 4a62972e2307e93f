#pragma once
#include <array>
#include <cstddef>

namespace gt {

constexpr double farthestLandmark = 5500;  ///< mm; nothing on a field is farther away.

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
  /// `sign` is 1 if a larger angle lies farther out, otherwise -1. With a `share`, the edge is
  /// straight: it is the outermost one that a scan met, although others ended at the border farther
  /// out. If less than that share of all scans met it, it is hidden: then, as without any that met
  /// it, the angle is the outermost of all, and `onBorder` is set.
  Merged merge(double sign, double tolerance, double share) const;

 private:
  struct Scan {
    double angle;
    bool onBorder;
  };
  const Scan* outermost(double sign, bool met) const;

  std::array<Scan, 16> scans_{};
  std::size_t count_ = 0;
};

}  // namespace gt
