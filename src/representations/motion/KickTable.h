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

/// What a kick does with a ball that lies at a place of the grid, seen from the robot as it stands
/// before the kick: x ahead, y to the left (mm).
struct KickedPlace {
  double x = 0, y = 0;
  double hits = 0;             ///< Share of the balls that it moves.
  double direction = 0;        ///< degrees, counterclockwise from straight ahead
  double spread = 0;           ///< degrees, standard deviation
  double length = 0;           ///< mm
  double lengthDeviation = 0;  ///< mm, standard deviation

  static KickedPlace of(const std::array<double, 7>& n) {
    return {n[0], n[1], n[2], n[3], n[4], n[5], n[6]};
  }
};

/// What a kick does, as measured in the dynamic fidelity.
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

  /// The place of the grid at which a ball lies; nothing beside the grid.
  std::optional<KickedPlace> at(const Vector2d& ball) const {
    for (const auto& numbers : places)
      if (covers(numbers, ball, 0)) return KickedPlace::of(numbers);
    return {};
  }

  /// How far the ball goes astray at least from the kick's direction (degrees, the root of the mean
  /// square) if it lies so near to a place where the kick reliably moves it; nothing if it lies
  /// near to none. With a margin (mm), the places are so much larger on all sides.
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
        field<&K::made>("names all that the motion did when it was measured"),
        field<&K::x>(Unit::mm, "where the ball is best, ahead"),
        field<&K::y>(Unit::mm, "where the ball is best, to the left"),
        field<&K::direction>(
            Unit::deg, "where the ball goes from there, counterclockwise from straight ahead"),
        field<&K::length>(Unit::mm, "how far it rolls from there"),
        field<&K::seconds>(Unit::s, "from the request until the robot stands again"),
        field<&K::strike>(Unit::s, "from the request until the ball leaves"),
        field<&K::falls>("share of the kicks with which the robot falls"),
        field<&K::step>(Unit::mm, "from one place of the grid to the next"),
        field<&K::places>(
            "x, y (mm); share of hits; direction, its standard deviation (degree); length, its "
            "standard deviation (mm)")};
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

  /// The index of a motion's kick; -1 if it is none.
  int find(std::string_view motion) const {
    for (std::size_t i = 0; i < kicks.size(); ++i)
      if (kicks[i].motion == motion) return static_cast<int>(i);
    return -1;
  }

  /// A motion's kick; null if it is none.
  const KickDescription* kickOf(std::string_view motion) const {
    const int kick = find(motion);
    return kick < 0 ? nullptr : &kicks[static_cast<std::size_t>(kick)];
  }

  static constexpr auto fields() { return Fields{field<&KickTable::kicks>()}; }
};

}  // namespace gt
