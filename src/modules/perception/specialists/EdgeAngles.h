#pragma once
#include <array>
#include <cstddef>

namespace gt {

/// The angles at which several scans met the same edge of a landmark (report 3.2.4, 3.2.5).
class EdgeAngles {
 public:
  struct Merged {
    double angle = 0;
    bool onBorder = true;
  };

  void clear() { count_ = 0; }
  void add(double angle, bool onBorder);
  bool empty() const { return count_ == 0; }

  /// The outermost angle, averaged with those close to it, since each has the image's noise in
  /// it; `sign` is 1 where a larger angle lies further out. An edge is straight: where less than
  /// `share` of the scans met it, something hides it, which counts as the image's border does.
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
