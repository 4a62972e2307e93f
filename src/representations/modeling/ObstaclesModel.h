#pragma once
#include <algorithm>
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// The obstacles around the robot in 90 sectors, each with its last measurement (report 3.5). All
/// positions are relative to the robot, so that errors of its pose have no influence. Provided by
/// the ObstaclesLocator.
struct ObstaclesModel {
  static constexpr int numberOfSectors = 90;
  static constexpr double farAway = 2000;  ///< Distance (mm) that is assumed to be free where no
                                           ///< obstacle is known.

  struct Sector {
    Vector2d representative = Vector2d::Zero();
    bool obstacle = false;
    Time lastSeen = never();

    static constexpr auto fields() {
      return Fields{
          field<&Sector::representative>(
              Unit::mm,
              "position of an obstacle, or the farthest point up to which the ground was seen "
              "free, relative to the robot"),
          field<&Sector::obstacle>("whether the representative is an obstacle"),
          field<&Sector::lastSeen>(Unit::ms, "time of the measurement")};
    }
  };
  /// The free part of a goal as it was seen last, relative to the robot (report 3.8.2).
  struct SeenGoal {
    Vector2d left = Vector2d::Zero(), right = Vector2d::Zero();
    Time lastSeen = never();

    static constexpr auto fields() {
      return Fields{field<&SeenGoal::left>(
                        Unit::mm, "left end of the goal's free part, relative to the robot"),
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
  /// Direction (rad) of the center of a sector relative to the robot, in [-pi, pi).
  static double middleOf(int sector) { return (sector + 0.5) * sectorWidth - pi; }
  /// Enters a measurement at a place (mm, relative to the robot) in its sector. Of two measurements
  /// in one sector, an obstacle takes precedence over free ground, and a nearer one over a farther
  /// one.
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
        field<&ObstaclesModel::sectors>(
            "sectors of 4 degrees each, counterclockwise from behind the robot"),
        field<&ObstaclesModel::goals>("free part of each goal, in the order of GoalColor")};
  }
};

}  // namespace gt
