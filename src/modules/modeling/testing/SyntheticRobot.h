#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/Geometry.h"
#include "base/Random.h"
#include "base/Time.h"
#include "modules/modeling/selflocator/FieldEdges.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

/// Errors and events in the world of the SyntheticRobot.
struct SyntheticWorld {
  double walkingSpeed = 200;         ///< greatest speed in any direction, mm/s
  double slip = 0.06;                ///< greatest slip of each component of a walk, as a share
  double stepNoise = 0.15;           ///< noise of each component, from image to image, as a share
  double commonNoise = 0.010;        ///< rad, on all bearings of an image
  double edgeNoise = 0.007;          ///< rad, on each edge
  double sway = 0.010;               ///< rad, amplitude of a yaw in the rhythm of the steps
  double outliers = 0.01;            ///< share of landmarks with a wrong name or at a wrong place
  double hiddenPosts = 0.10;         ///< share of time during which a robot hides a goal's edge
  double range = 4500;               ///< mm, farthest distance of a seen landmark
  double secondsBetweenBlocks = 30;  ///< after which the robot walks against an obstacle
  double secondsBlocked = 3;
  double tiltNoise = 0.010;   ///< rad, of the camera, common to an image
  double pointNoise = 0.004;  ///< rad, vertically, on each point on an edge
  /// mm, greatest distance of seen lines, which are too thin farther away
  double lineRange = 1300;
  double edgeRange = 3200;         ///< mm, greatest distance of seen edges of border and goals
  bool flags = true;               ///< false: there are no beacons on the field
  std::uint64_t missingFlags = 0;  ///< number of the six beacons that are removed
  double misplacedFlags = 0;       ///< mm, displacement of each beacon
  double lostPictures = 0;         ///< share of images in which nothing is found
  double hidden = 0;               ///< share of the surroundings hidden by other robots
  bool turnsHeadAlways = false;    ///< false: it looks at a ball for half of the time
  bool walks = true;
};

/// A simulated robot that walks about the field, turns its head and sees landmarks and edges. Its
/// true pose is known. It is a test bench for self-locators that needs neither images nor physics.
/// One step is one image.
class SyntheticRobot {
 public:
  explicit SyntheticRobot(std::uint64_t seed, const SyntheticWorld& world = {});

  void step();
  /// A step in which it walks with a speed in the robot's system (mm/s, rad/s).
  void step(const Pose2D& speed);
  /// The referee puts the robot somewhere else; the odometry does not measure it.
  void kidnap();

  static constexpr int imagePeriod = 40;  ///< ms
  static constexpr int imagesPerMinute = 60 * 1000 / imagePeriod;

  Pose2D pose;
  OdometryData odometry;
  LandmarksPercept percept;
  LinesPercept lines;
  CameraMatrix camera;  ///< Only the position is filled in.
  FieldDimensions field;
  Player player;
  Time time;

 private:
  Pose2D placeOnField();
  void chooseGoal();
  Pose2D towardsGoal();
  void walk(Pose2D step);
  void perceive();
  void turnHead();
  void see();
  void seeFlag(FlagType type);
  void seeGoal(GoalColor color);
  void seeEdges();
  void seeEdges(double angle, double tiltError);
  void placeRobotsInTheWay();
  bool isHidden(double angle) const;
  /// Clips an interval of angles to the camera's field of view. Returns false if too little
  /// remains.
  bool cutToImage(ConditionalBoundary& boundary);
  double seconds() const { return static_cast<double>(time.ms) / 1000; }

  SyntheticWorld world_;
  Random random_;
  Random seeing_;  ///< Separate, so that edges do not change the walk and the landmarks.
  bool moving_;
  Pose2D goal_, slip_;
  double headPan_ = 0, ballPan_ = 0;
  Time blockedUntil_ = never(), modeUntil_ = never();
  bool tracksBall_ = false;
  double commonError_ = 0;
  FieldEdges edges_;
  std::array<Vector2d, 6> flagErrors_;  ///< Displacement of each flag, mm.
  std::vector<double> crossings_;
  /// Sectors around the robot that are hidden by other robots.
  std::array<bool, 24> hiddenSectors_{};
  Time robotsMoveAt_ = never();
  struct Hidden {
    Time until = never();
    double left = 0, right = 0;  ///< Hidden part, as shares of the goal.
  };
  std::array<Hidden, 2> hidden_;
};

}  // namespace gt
