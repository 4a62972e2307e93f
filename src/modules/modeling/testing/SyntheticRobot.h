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

/// How the world treats the SyntheticRobot.
struct SyntheticWorld {
  double walkingSpeed = 200;         ///< mm/s at most, in any direction
  double slip = 0.06;                ///< of each component of a walk, at most
  double stepNoise = 0.15;           ///< of each component, from image to image
  double commonNoise = 0.010;        ///< rad, on all bearings of an image
  double edgeNoise = 0.007;          ///< rad, on each edge
  double sway = 0.010;               ///< rad, amplitude of a yaw in the rhythm of the steps
  double outliers = 0.01;            ///< landmarks with a wrong name or at a wrong place
  double hiddenPosts = 0.10;         ///< share of time in which a robot hides a goal's edge
  double range = 4500;               ///< mm
  double secondsBetweenBlocks = 30;  ///< after which the robot walks against an obstacle
  double secondsBlocked = 3;
  double tiltNoise = 0.010;        ///< rad, of the camera, common to an image
  double pointNoise = 0.004;       ///< rad, vertically, on each point on an edge
  double lineRange = 1300;         ///< mm, farther away lines are too thin to be seen
  double edgeRange = 3200;         ///< mm, the same for border and goals
  bool flags = true;               ///< false: there are no beacons on the field
  std::uint64_t missingFlags = 0;  ///< as many of the six beacons were taken away
  double misplacedFlags = 0;       ///< mm, by which each stands elsewhere
  double lostPictures = 0;         ///< share in which nothing is found
  double hidden = 0;               ///< share of what is seen that other robots hide
  bool turnsHeadAlways = false;    ///< else it looks at a ball for half of the time
  bool walks = true;
};

/// A robot that walks about the field, turns its head and sees landmarks and edges, with its true
/// pose: a test bench for self-locators that needs neither images nor physics. One step is one
/// image.
class SyntheticRobot {
 public:
  explicit SyntheticRobot(std::uint64_t seed, const SyntheticWorld& world = {});

  void step();
  /// The same, but walks as requested: in the robot's system, mm/s and rad/s.
  void step(const Pose2D& speed);
  /// The referee puts the robot somewhere else; its odometry knows nothing of it.
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
  /// Cuts an interval of angles to what the camera sees; false where too little remains.
  bool cutToImage(ConditionalBoundary& boundary);
  double seconds() const { return static_cast<double>(time.ms) / 1000; }

  SyntheticWorld world_;
  Random random_;
  Random seeing_;  ///< Of its own, so that edges change nothing of the walk and the landmarks.
  bool moving_;
  Pose2D goal_, slip_;
  double headPan_ = 0, ballPan_ = 0;
  Time blockedUntil_ = never(), modeUntil_ = never();
  bool tracksBall_ = false;
  double commonError_ = 0;
  FieldEdges edges_;
  std::array<Vector2d, 6> flagErrors_;  ///< How far each flag stands elsewhere.
  std::vector<double> crossings_;
  std::array<bool, 24> hiddenSectors_{};  ///< Around the robot, by others in the way.
  Time robotsMoveAt_ = never();
  struct Hidden {
    Time until = never();
    double left = 0, right = 0;  ///< Shares of the goal.
  };
  std::array<Hidden, 2> hidden_;
};

}  // namespace gt
