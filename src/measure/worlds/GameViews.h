#pragma once
#include <memory>
#include <vector>

#include "representations/infrastructure/SensorData.h"
#include "representations/perception/CameraMatrix.h"
#include "simulation/Simulation.h"
#include "simulation/camera/CameraRenderer.h"
#include "simulation/scene/Scene.h"
#include "simulation/sensors/Sensors.h"
#include "simulation/world/World.h"

namespace gt {

/// What one robot sees and feels in one moment, and what is true then.
struct GameView {
  std::size_t robot = 0;
  Image image;
  ImageTruth truth;
  SensorDataBuffer sensors;
  Pose2D step;          ///< How far the robot believes to have walked in the last tick.
  CameraMatrix camera;  ///< The true one.
};

/// What the camera matrix of a robot should be that stands there and takes this image.
CameraMatrix trueMatrix(const CameraView& camera, const Pose2D& robot);

/// Random moments of matches as the robots of a scene see them: robots and ball are anywhere, some
/// robots walk, legs differ, heads look around. For experiments and for learning colors.
class GameViews {
 public:
  static Result<GameViews> make(const SceneDescription& scene, std::uint64_t seed);

  /// Puts everything somewhere else and lets the heads turn for a while.
  void shuffle();
  /// What a robot sees now. The pointer is valid until the next call.
  const GameView& look(std::size_t robot, const CameraEffects& effects);
  const World& world() const { return *world_; }
  const SceneDescription& scene() const { return scene_; }

 private:
  GameViews(SceneDescription scene, std::unique_ptr<World> world, std::uint64_t seed);
  Vector2d somewhere(double x, double y);
  void placeRobot(std::size_t robot);
  void placeBall();
  void placeReferees();
  void step();

  SceneDescription scene_;
  std::unique_ptr<World> world_;
  Random random_;
  std::unique_ptr<CameraScene> cameraScene_;
  CameraRenderer renderer_;
  std::vector<Sensors> sensors_;
  std::vector<SensorDataBuffer> buffers_;
  std::vector<RobotCommand> commands_, driven_;  ///< As requested, and as the motors understand it.
  std::vector<Random> delays_;
  GameView view_;
};

}  // namespace gt
