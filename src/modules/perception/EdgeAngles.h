#pragma once
#include <array>
#include <cstddef>

#include "modules/perception/Picture.h"

namespace gt {

/// The angles at which several scans met the same edge of a landmark (report 3.2.4, 3.2.5).
class EdgeAngles {
 public:
  struct Merged {
    double angle = 0;
    bool onBorder = true;
  };

  void clear() { inside_ = border_ = 0; }
  void add(double angle, bool onBorder);
  /// The outermost angle, averaged with those close to it, since each has the picture's noise in
  /// it; `sign` is 1 where a larger angle lies further out. Scans that met the picture's border
  /// count only if no other did.
  Merged merge(double sign, double tolerance) const;
  bool empty() const { return inside_ + border_ == 0; }

 private:
  static constexpr std::size_t capacity = 16;
  std::array<double, capacity> insideAngles_{}, borderAngles_{};
  std::size_t inside_ = 0, border_ = 0;
};

}  // namespace gt
