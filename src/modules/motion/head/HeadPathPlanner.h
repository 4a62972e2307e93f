#pragma once
#include <array>
#include <initializer_list>

#include "modules/kinematics/HeadKinematics.h"

namespace gt {

/// Moves the head along way points with constant speed, so that it reaches the last one after a
/// given time (report 3.9.3.3).
class HeadPathPlanner {
 public:
  static constexpr int maxPoints = 8;

  /// Plans a path from the head's angles `start` over at most maxPoints way points. `duration` in
  /// ms.
  void plan(const HeadAngles& start, std::initializer_list<HeadAngles> points, double duration);
  /// The target angles for the next frame, 8 ms later.
  HeadAngles next();
  bool finished() const { return way_ >= length_; }

 private:
  std::array<HeadAngles, maxPoints + 1> points_;
  int count_ = 0;
  double length_ = 0;    ///< Length of the whole path, rad.
  double way_ = 0;       ///< Length covered until now, rad.
  double perFrame_ = 0;  ///< Length covered in a frame, rad.
};

}  // namespace gt
