#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "base/DataRoot.h"
#include "base/Random.h"
#include "base/Result.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"
#include "simulation/Simulation.h"

namespace gt {

/// The differences of a SimulatedWalker's world to the match scene.
struct WalkerWorld {
  Profile profile = Profile::padova;
  double slip = 0, motion = 0;                      ///< Lower bounds of these elements of the
                                                    ///< scene's noise.
  std::function<void(SceneDescription&)> change{};  ///< Changes other parts of the scene.
  bool flags = true;
  WalkType walkType = WalkType::normal;
  double walkingSpeed = 150;  ///< mm/s; limited to what the robot can reach.
  bool walks = true;
  bool legsOnly = false;           ///< Whether tilt and roll are those of stiff legs.
  std::uint64_t missingFlags = 0;  ///< Number of the six beacons that are removed.
  double misplacedFlags = 0;       ///< Displacement of each beacon, in mm.
  double wrong = 0;                ///< Share of percepts that are replaced by wrong ones.
  double lostPictures = 0;         ///< Share of images in which nothing is found.
  std::size_t others = 0;          ///< Number of robots that stand in the way at changing places.
  bool leansOnWalls = false;       ///< Whether it walks against walls half of the time, while its
                                   ///< feet slip.
};

/// A robot alone on the simulated field that walks around and turns its head from left to right and
/// back (report 3.3.3.4), with its own walking engine and vision. One step is one image. It has the
/// members of a SyntheticRobot, so that the same experiments can use both.
class SimulatedWalker {
 public:
  static Result<std::unique_ptr<SimulatedWalker>> make(const DataRoot& root, std::uint64_t seed,
                                                       const WalkerWorld& world = {});
  ~SimulatedWalker();

  /// Simulates up to the next image, walking to random places.
  void step();
  /// Simulates up to the next image, walking with the requested speed (mm/s, rad/s), relative to
  /// the robot.
  void step(const Pose2D& speed);
  /// Moves the robot to a random pose, without any change of its odometry.
  void kidnap();
  /// Whether the robot has fallen, which is possible in the dynamic fidelity only.
  bool hasFallen() const;

  Pose2D pose;
  OdometryData odometry;
  LandmarksPercept percept;
  LinesPercept lines;
  CameraMatrix camera;
  CameraMatrix trueCamera;  ///< The true value of `camera`.
  FieldDimensions field;
  Player player;
  Time time;

 private:
  class Body;

  SimulatedWalker(std::uint64_t seed, const WalkerWorld& world);
  Pose2D placeOnField();
  Vector2d chooseGoal();
  void placeFlags();
  void placeOthers();
  void disturbPercepts();

  WalkerWorld world_;
  Random random_;
  std::unique_ptr<Simulation> simulation_;
  Body* body_ = nullptr;  ///< Owned by the simulation.
  Vector2d goal_;
  Time othersMoveAt_ = never();
};

}  // namespace gt
