#pragma once
#include <algorithm>
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// The surroundings as a radar shows them: 90 sectors around the robot, with what was measured last
/// in each of them (report 3.5). All is relative to the robot, so that no error of its pose counts.
/// Provided by the ObstaclesLocator.
struct ObstaclesModel {
  static constexpr int numberOfSectors = 90;
  static constexpr double farAway = 2000;  ///< mm: what is free where no obstacle is known.

  struct Sector {
    Vector2d representative = Vector2d::Zero();
    bool obstacle = false;
    Time lastSeen = never();

    static constexpr auto fields() {
      return Fields{
          field<&Sector::representative>(
              Unit::mm,
              "the measurement: an obstacle, or as far as the ground was seen to be free"),
          field<&Sector::obstacle>("whether the representative is one"),
          field<&Sector::lastSeen>(Unit::ms, "when it was measured")};
    }
  };
  /// The free part of a goal as it was seen (report 3.8.2).
  struct SeenGoal {
    Vector2d left = Vector2d::Zero(), right = Vector2d::Zero();
    Time lastSeen = never();

    static constexpr auto fields() {
      return Fields{field<&SeenGoal::left>(Unit::mm, "the goal's left end on the ground line"),
                    field<&SeenGoal::right>(Unit::mm), field<&SeenGoal::lastSeen>(Unit::ms)};
    }
  };

  Time time;
  std::array<Sector, numberOfSectors> sectors;
  EnumArray<GoalColor, SeenGoal> goals;

  static constexpr double sectorWidth = 2 * pi / numberOfSectors;
  static int sectorOf(double angle) {
    return std::clamp(static_cast<int>((normalize(angle) + pi) / sectorWidth), 0,
                      numberOfSectors - 1);
  }
  static int sectorOf(const Vector2d& point) { return sectorOf(angleOf(point)); }
  /// The middle of a sector in rad, in [-pi, pi).
  static double middleOf(int sector) { return (sector + 0.5) * sectorWidth - pi; }
  /// Enters a measurement in its sector. Of two in one sector, obstacles count more than free
  /// ground, near ones more than far ones.
  void enter(const Vector2d& place, bool obstacle, Time seen) {
    Sector& known = sectors[static_cast<std::size_t>(sectorOf(place))];
    const bool yields =
        known.obstacle != obstacle
            ? obstacle || known.lastSeen == never()
            : known.lastSeen == never() || place.squaredNorm() < known.representative.squaredNorm();
    if (yields) known = {place, obstacle, seen};
  }

  static constexpr auto fields() {
    return Fields{
        field<&ObstaclesModel::time>(Unit::ms),
        field<&ObstaclesModel::sectors>("of 4 degrees each, counterclockwise from behind"),
        field<&ObstaclesModel::goals>("in the order of GoalColor")};
  }
};

}  // namespace gt
