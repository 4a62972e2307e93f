#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The effect of a kick on a ball at one place of the grid. The place is relative to the robot as
/// it stands before the kick: x ahead, y to the left (mm).
struct KickedPlace {
  double x = 0, y = 0;
  double hits = 0;             ///< Share of the balls that are moved.
  double direction = 0;        ///< degrees, counterclockwise from straight ahead
  double spread = 0;           ///< degrees, standard deviation of the direction
  double length = 0;           ///< mm, distance that the ball rolls
  double lengthDeviation = 0;  ///< mm, standard deviation of the length

  static KickedPlace of(const std::array<double, 7>& n) {
    return {n[0], n[1], n[2], n[3], n[4], n[5], n[6]};
  }
};

/// The effects of a kick, measured in the dynamic fidelity of the simulator.
struct KickDescription {
  std::string motion;
  std::string made{};
  double x = 0, y = 0;
  double direction = 0;
  double length = 0;
  double seconds = 0;
  double strike = 0;
  double falls = 0;
  double step = 0;
  std::vector<std::array<double, 7>> places;

  /// The place of the grid at which a ball (mm, relative to the robot) lies; empty outside the
  /// grid.
  std::optional<KickedPlace> at(const Vector2d& ball) const {
    for (const auto& numbers : places)
      if (covers(numbers, ball, 0)) return KickedPlace::of(numbers);
    return {};
  }

  /// The least angular deviation (degrees, root mean square) of the ball from the kick's direction,
  /// over all places that the ball (mm, relative to the robot) lies at and from which the kick
  /// reliably moves it; empty if there is none. The places are enlarged by `margin` (mm) on all
  /// sides.
  std::optional<double> spreadAt(const Vector2d& ball, double margin) const {
    constexpr double reliably = 0.9;
    std::optional<double> least;
    for (const auto& numbers : places) {
      if (!covers(numbers, ball, margin)) continue;
      const KickedPlace place = KickedPlace::of(numbers);
      const double off = toDegrees(normalize(fromDegrees(place.direction - direction)));
      const double astray = std::hypot(off, place.spread);
      if (place.hits >= reliably && (!least || astray < *least)) least = astray;
    }
    return least;
  }

  static constexpr auto fields() {
    using K = KickDescription;
    return Fields{
        field<&K::motion>("name of the motion description"),
        field<&K::made>("fingerprint of the motion when it was measured"),
        field<&K::x>(Unit::mm, "best position of the ball relative to the robot, ahead"),
        field<&K::y>(Unit::mm, "best position of the ball relative to the robot, to the left"),
        field<&K::direction>(
            Unit::deg,
            "direction of the ball when kicked from the best position, counterclockwise from "
            "straight ahead"),
        field<&K::length>(Unit::mm,
                          "distance that the ball rolls when kicked from the best position"),
        field<&K::seconds>(Unit::s, "duration from the request until the robot stands again"),
        field<&K::strike>(Unit::s, "duration from the request until the ball leaves"),
        field<&K::falls>("share of the kicks during which the robot falls"),
        field<&K::step>(Unit::mm, "distance between neighboring places of the grid"),
        field<&K::places>(
            "for each place: x, y (mm); share of hits; direction, its standard deviation "
            "(degrees); length, its standard deviation (mm)")};
  }

 private:
  bool covers(const std::array<double, 7>& place, const Vector2d& ball, double margin) const {
    const double most = step / 2 + margin;
    return std::abs(ball.x() - place[0]) <= most && std::abs(ball.y() - place[1]) <= most;
  }
};

/// All kicks: config/kicks.cfg, made by `experiment calibrate-kicks`.
struct KickTable {
  std::vector<KickDescription> kicks;

  /// The index of a motion's kick; -1 if the motion is not a kick.
  int find(std::string_view motion) const {
    for (std::size_t i = 0; i < kicks.size(); ++i)
      if (kicks[i].motion == motion) return static_cast<int>(i);
    return -1;
  }

  /// A motion's kick; null if the motion is not a kick.
  const KickDescription* kickOf(std::string_view motion) const {
    const int kick = find(motion);
    return kick < 0 ? nullptr : &kicks[static_cast<std::size_t>(kick)];
  }

  static constexpr auto fields() { return Fields{field<&KickTable::kicks>()}; }
};

}  // namespace gt
