#pragma once
#include "streams/Reflection.h"

namespace gt {

/// How balls roll and bounce. Element `physics`.
struct BallParameters {
  double deceleration = 250;
  double bounceWall = 0.5;
  double bounceRobot = 0.3;
  double friction = 0.1;
  double maxSpeed = 3000;
  double dents = 0;
  double dentSize = 150;

  static constexpr auto fields() {
    return Fields{
        field<&BallParameters::deceleration>(Unit::mmPerS2, "rolling on the carpet", {0, 1e5}),
        field<&BallParameters::bounceWall>("coefficient of restitution", {0, 1}),
        field<&BallParameters::bounceRobot>("coefficient of restitution", {0, 1}),
        field<&BallParameters::friction>("share of the sliding speed that a touch takes", {0, 1}),
        field<&BallParameters::maxSpeed>(Unit::mmPerS, {1, 4000}),
        field<&BallParameters::dents>(
            Unit::mmPerS2,
            "at most, by which the carpet's unevenness pulls a rolling ball in each direction",
            {0, 1e4}),
        field<&BallParameters::dentSize>(Unit::mm, "from one dent to the next", {10, 5000})};
  }
};

}  // namespace gt
