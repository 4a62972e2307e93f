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

/// What is different from the match scene around a SimulatedWalker.
struct WalkerWorld {
  Profile profile = Profile::padova;
  double slip = 0, motion = 0;                      ///< At least, as in the scene's element noise.
  std::function<void(SceneDescription&)> change{};  ///< All else of the scene.
  bool flags = true;
  WalkType walkType = WalkType::normal;
  double walkingSpeed = 150;  ///< mm/s; faster than it can: as fast as it can.
  bool walks = true;
  bool legsOnly = false;           ///< Tilt and roll are those of stiff legs.
  std::uint64_t missingFlags = 0;  ///< As many of the six beacons were taken away.
  double misplacedFlags = 0;       ///< mm, by which each stands elsewhere.
  double wrong = 0;                ///< Share of what is seen that is made something else.
  double lostPictures = 0;         ///< Share in which nothing is found.
  std::size_t others = 0;          ///< Robots that stand in the way, now here, now there.
  bool leansOnWalls = false;       ///< Walks against them for half of the time; its feet slip.
};

/// A robot alone on the simulated field that walks about and turns its head from left to right and
/// back (report 3.3.3.4), with its own walking engine and vision. One step is one image. It has
/// the members of a SyntheticRobot, so that the same experiments run on both.
class SimulatedWalker {
 public:
  static Result<std::unique_ptr<SimulatedWalker>> make(const DataRoot& root, std::uint64_t seed,
                                                       const WalkerWorld& world = {});
  ~SimulatedWalker();

  /// To the next image, walking to random places.
  void step();
  /// The same, but walks as requested: in the robot's system, mm/s and rad/s.
  void step(const Pose2D& speed);
  /// The referee puts the robot somewhere else; its odometry knows nothing of it.
  void kidnap();
  /// Whether it lies, which it can in the dynamic fidelity only.
  bool hasFallen() const;

  Pose2D pose;
  OdometryData odometry;
  LandmarksPercept percept;
  LinesPercept lines;
  CameraMatrix camera;
  CameraMatrix trueCamera;  ///< What `camera` should be.
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
