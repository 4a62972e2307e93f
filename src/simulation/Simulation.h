#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "debug/Stopwatch.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "robot/platform/Body.h"
#include "simulation/Radio.h"
#include "simulation/WorkerPool.h"
#include "simulation/camera/CameraRenderer.h"
#include "simulation/rules/Referee.h"
#include "simulation/scene/Scene.h"
#include "simulation/sensors/FieldSensors.h"
#include "simulation/sensors/Sensors.h"
#include "simulation/world/Actuators.h"
#include "simulation/world/World.h"

namespace gt {

class Simulation;

/// The controller of one robot (report 5.1.3): senses, thinks and acts once a tick.
class RobotController {
 public:
  virtual ~RobotController() = default;

  /// Runs with the input of this tick. Controllers of different robots run at the same time on
  /// several threads: they share nothing that changes.
  virtual void cycle(const RobotInput& input, RobotOutput& output) = 0;
};

/// A controller of the scene itself, beside those of the robots: it may move, switch and watch
/// anything.
class SceneController {
 public:
  virtual ~SceneController() = default;

  /// Runs before each tick.
  virtual void control(Simulation& simulation) = 0;
};

/// A scene that runs. Everything that happens follows from the scene, the seed and the controllers:
/// the same in, the same bits out, with any number of threads.
///
/// A tick of 8 ms: (1) the world moves by the commands of the last tick; (2) the referee looks and
/// acts; (3) for each robot, in parallel: sensors are read, the radio delivers, if a picture is due
/// it is taken, the controller runs; the world is only read meanwhile, and a
/// robot touches only what is its own; (4) in the order of the robots, commands and messages are
/// taken from the outputs. So a command takes effect in the tick after that whose readings it
/// answers. Pictures are due every fifth tick (40 ms) for all robots at once; each row sees the
/// world from where the camera was when the row was exposed.
class Simulation {
 public:
  static constexpr int ticksPerPicture = 5;

  /// Fails if the scene's models are wrong. `threads` counts the calling thread.
  static Result<std::unique_ptr<Simulation>> make(const SceneDescription& scene, std::uint64_t seed,
                                                  std::size_t threads = 1,
                                                  const FieldDimensions& field = {});

  /// Gives an active robot its controller. A robot without one stands still.
  void attach(std::size_t robot, std::unique_ptr<RobotController> controller);
  /// Adds a controller of the scene; all run in the order in which they came.
  void add(std::unique_ptr<SceneController> controller) {
    sceneControllers_.push_back(std::move(controller));
  }
  /// What a robot's controller threw, after which it was not called again; empty if it did not.
  const std::string& failure(std::size_t robot) const { return robots_[robot].failure; }
  /// Goes on in the other fidelity: all stands where it stood. Fails if the scene's models cannot
  /// be read any more.
  Result<void> changeFidelity(Fidelity fidelity);
  void changeNoise(const NoiseParameters& noise);
  /// Sets an active robot's camera in its own way; at the start all are as the scene says.
  void setCamera(std::size_t robot, const CameraEffects& effects) {
    robots_[robot].camera = effects;
  }
  const CameraEffects& camera(std::size_t robot) const { return robots_[robot].camera; }
  /// Pictures are taken unless switched off.
  void takePictures(bool on) { takePictures_ = on; }
  /// The same for the camera of one active robot (report I.5.3: ci): instead of new pictures it
  /// gets its last one again and again, so that what works on pictures goes on.
  void takePictures(std::size_t robot, bool on) { robots_[robot].cameraOn = on; }

  /// One tick.
  void step();

  Time time() const { return world_->time(); }
  bool finished() const { return referee_.state() == GameState::finished; }
  const SceneDescription& scene() const { return scene_; }
  /// All robots, the active ones first.
  const std::vector<Player>& players() const { return players_; }
  const World& world() const { return *world_; }
  /// For moving things by hand, between ticks.
  World& world() { return *world_; }
  Referee& referee() { return referee_; }
  const Referee& referee() const { return referee_; }
  Radio& radio() { return radio_; }
  const Radio& radio() const { return radio_; }
  Actuators& actuators() { return actuators_; }
  FieldSensors& fieldSensors() { return fieldSensors_; }
  Sensors& sensors(std::size_t robot) { return robots_[robot].sensors; }
  RobotController* controller(std::size_t robot) { return robots_[robot].controller.get(); }
  /// What a robot got and gave in the last tick; `image` is its last picture even between pictures.
  const RobotInput& input(std::size_t robot) const { return robots_[robot].input; }
  const RobotOutput& output(std::size_t robot) const { return robots_[robot].output; }
  const Image& image(std::size_t robot) const { return robots_[robot].image; }
  /// A number that follows from the state of world, game and radio and from what the robots sense
  /// and do: two runs that are the same have the same, others hardly ever.
  std::uint64_t fingerprint() const;
  /// The time that the parts of the simulator have taken: the world, and for each robot its sensors
  /// and its camera.
  std::vector<const Stopwatch*> times() const;

 private:
  /// An active robot's own part of the simulation.
  struct SimulatedRobot {
    std::unique_ptr<RobotController> controller;
    Sensors sensors;
    bool cameraOn = true;
    Random pictureSeeds;
    CameraEffects camera;
    RobotInput input;
    RobotOutput output;
    Image image;
    Pose2D odometry;
    Stopwatch sensorTime{"sensors"}, cameraTime{"camera"};
    std::string failure{};
  };

  Simulation(const SceneDescription& scene, std::unique_ptr<World> world, const Random& random,
             std::size_t threads, const FieldDimensions& field);

  void prepareCameras();
  void sense(std::size_t robot);
  void takePicture(std::size_t robot, CameraRenderer& renderer);
  void act();

  SceneDescription scene_;
  std::vector<Player> players_;
  Random random_;
  std::unique_ptr<World> world_;
  Referee referee_;
  Radio radio_;
  Actuators actuators_;
  FieldSensors fieldSensors_;
  std::vector<std::unique_ptr<SceneController>> sceneControllers_;
  std::unique_ptr<CameraScene> cameraScene_;
  std::vector<CameraRenderer> renderers_;  ///< One for each thread.
  std::vector<SimulatedRobot> robots_;
  std::vector<RobotCommand> commands_;
  std::int64_t tick_ = 0;
  bool takePictures_ = true;
  Stopwatch worldTime_{"world"};
  WorkerPool pool_;
};

/// From where a picture is taken whose last row is exposed now.
CameraView cameraView(const World& world, std::size_t robot, const CameraInfo& info);

}  // namespace gt
