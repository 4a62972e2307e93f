#pragma once
#include <array>
#include <initializer_list>

#include "modules/kinematics/HeadKinematics.h"

namespace gt {

/// Moves the head along way points with one speed, so that it is at the last one after the time
/// given, from wherever it starts (report 3.9.3.3).
class HeadPathPlanner {
 public:
  static constexpr int maxPoints = 8;

  /// Plans a path from where the head is over at most maxPoints way points, in ms.
  void plan(const HeadAngles& start, std::initializer_list<HeadAngles> points, double duration);
  /// Where the head shall be one frame of 8 ms later.
  HeadAngles next();
  bool finished() const { return way_ >= length_; }

 private:
  std::array<HeadAngles, maxPoints + 1> points_;
  int count_ = 0;
  double length_ = 0;    ///< rad, of the whole path
  double way_ = 0;       ///< rad, covered
  double perFrame_ = 0;  ///< rad
};

}  // namespace gt
