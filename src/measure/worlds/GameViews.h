#pragma once
#include <memory>
#include <vector>

#include "base/DataRoot.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/CameraMatrix.h"
#include "simulation/Simulation.h"

namespace gt {

/// What one robot sees and feels in one moment, and what is true then.
struct GameView {
  std::size_t robot = 0;
  Image image;
  ImageTruth truth;
  SensorDataBuffer sensors;
  Pose2D odometry;      ///< Where the robot believes to have walked to in all ticks,
  Pose2D step;          ///< and in the last one.
  CameraMatrix camera;  ///< The true one.
};

/// What the camera matrix of a robot should be that stands there and takes this image.
CameraMatrix trueMatrix(const CameraView& camera, const Pose2D& robot);

/// Random moments of matches as the robots of a scene see them: robots and ball are anywhere, some
/// robots walk, legs of the others differ, heads look around. Bodies, sensors and cameras are those
/// of a simulation, with all errors of the scene. For experiments and for learning colors.
class GameViews {
 public:
  /// Fails if the scene's models or the configuration of the walk are wrong.
  static Result<GameViews> make(const DataRoot& root, const SceneDescription& scene,
                                std::uint64_t seed);

  /// Puts everything somewhere else and lets robots walk and heads turn for a while.
  void shuffle();
  /// Lets all go on until cameras deliver the next image.
  void waitForImage();
  /// What a robot sees now. The reference is valid until the next call.
  const GameView& look(std::size_t robot, const CameraEffects& effects);
  const World& world() const { return simulation_->world(); }
  const SceneDescription& scene() const { return simulation_->scene(); }

 private:
  class Body;

  GameViews(std::unique_ptr<Simulation> simulation, const WalkTypes& walk, std::uint64_t seed);
  Vector2d somewhere(double x, double y);
  void placeRobot(std::size_t robot);
  void placeBall();
  void placeReferees();
  void run(std::size_t ticks);

  std::unique_ptr<Simulation> simulation_;
  Random random_;
  std::unique_ptr<CameraScene> cameraScene_;
  CameraRenderer renderer_;
  std::vector<Body*> bodies_;  ///< Of the active robots; owned by the simulation.
  GameView view_;
};

}  // namespace gt
