#pragma once
#include <array>
#include <optional>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A range of directions.
struct AngleRange {
  double middle = 0, width = 0;  ///< rad
};

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
          field("representative", &Sector::representative, "mm",
                "the measurement: an obstacle, or as far as the ground was seen to be free"),
          field("obstacle", &Sector::obstacle, "", "whether the representative is one"),
          field("lastSeen", &Sector::lastSeen, "ms", "when it was measured")};
    }
  };
  /// The free part of a goal as it was seen (report 3.8.2).
  struct SeenGoal {
    Vector2d left = Vector2d::Zero(), right = Vector2d::Zero();
    Time lastSeen = never();

    static constexpr auto fields() {
      return Fields{field("left", &SeenGoal::left, "mm", "its left end on the ground line"),
                    field("right", &SeenGoal::right, "mm"),
                    field("lastSeen", &SeenGoal::lastSeen, "ms")};
    }
  };

  Time time;
  std::array<Sector, numberOfSectors> sectors;
  EnumArray<GoalColor, SeenGoal> goals;

  static int sectorOf(double angle);
  static int sectorOf(const Vector2d& point) { return sectorOf(angleOf(point)); }
  static double middleOf(int sector);  ///< rad, in [-pi, pi).
  /// Lays a measurement down in its sector. Of two in one sector, obstacles count more than free
  /// ground, near ones more than far ones.
  void enter(const Vector2d& place, bool obstacle, Time seen);

  /// The free distance in one sector, in mm.
  double distance(int sector) const {
    const Sector& s = sectors[static_cast<std::size_t>(sector)];
    return s.obstacle ? std::fmin(s.representative.norm(), farAway) : farAway;
  }

  /// The nearest obstacle within a range of directions; none nearer than farAway.
  std::optional<Vector2d> nearest(AngleRange range = {0, 2 * pi}) const;
  /// How far a body of a width (mm) can move in a direction (rad) until it meets an obstacle: the
  /// free distance in a corridor, at most farAway. It begins at `from`, mm relative to the robot;
  /// obstacles beside or behind that are not met.
  double corridor(double direction, double width, const Vector2d& from = {0, 0}) const;
  /// The direction nearest to a wanted one in which a corridor is free as far as `length` (mm), not
  /// further off it than `most` (rad); none if there is none.
  std::optional<double> freeDirection(double wanted, double width, double length, double most = pi,
                                      const Vector2d& from = {0, 0}) const;
  /// The widest range of directions between the posts of a goal in which nothing blocks the way of
  /// a ball from a point to the goal line; none if all of it is blocked or seen from behind. `gap`
  /// is what a ball needs, its diameter (mm); all points relative to the robot.
  std::optional<AngleRange> freeGoalPart(const Vector2d& from, const Vector2d& leftPost,
                                         const Vector2d& rightPost, double gap) const;
  /// The direction in which to kick a ball that lies at `from`: to the middle of the free part of
  /// the goal, if there is one that was wide enough, else the one nearest to the goal's middle that
  /// is free as far as `length` (mm); that of the middle if there is none, too.
  double kickAngle(const Vector2d& from, const Vector2d& leftPost, const Vector2d& rightPost,
                   double gap, double length) const;

  static constexpr auto fields() {
    return Fields{field("time", &ObstaclesModel::time, "ms"),
                  field("sectors", &ObstaclesModel::sectors, "",
                        "of 4 degrees each, counterclockwise from behind"),
                  field("goals", &ObstaclesModel::goals, "", "in the order of GoalColor")};
  }
};

}  // namespace gt
