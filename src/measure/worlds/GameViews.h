#pragma once
#include <memory>
#include <vector>

#include "base/DataRoot.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/CameraMatrix.h"
#include "simulation/Simulation.h"

namespace gt {

/// The sensor data of one robot at one moment, with the ground truth.
struct GameView {
  std::size_t robot = 0;
  Image image;
  ImageTruth truth;
  SensorDataBuffer sensors;
  Pose2D odometry;      ///< Pose that the robot's odometry has reached after all ticks.
  Pose2D step;          ///< Odometry step of the last tick.
  CameraMatrix camera;  ///< The true camera matrix.
};

/// The true camera matrix of a robot at a pose that takes this image.
CameraMatrix trueMatrix(const CameraView& camera, const Pose2D& robot);

/// Random moments of matches, as seen by the robots of a scene. Robots and ball have random
/// positions, some robots walk, the legs of the others differ, heads move. Bodies, sensors and
/// cameras are those of a simulation, with all errors of the scene. For experiments and for
/// learning colors.
class GameViews {
 public:
  /// Returns an error if the scene's models or the configuration of the walk are invalid.
  static Result<GameViews> make(const DataRoot& root, const SceneDescription& scene,
                                std::uint64_t seed);

  /// Places all objects at random and simulates walking and head motion for a while.
  void shuffle();
  /// Continues the simulation until cameras deliver the next image.
  void waitForImage();
  /// The present view of a robot. The reference is valid until the next call.
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
