#pragma once
#include <array>
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
#include "simulation/sensors/CeilingCamera.h"
#include "simulation/sensors/CeilingTracker.h"
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
  /// Completes the cycle, after `cycle` was called for all robots. Controllers whose program runs
  /// in another process wait for it here, so that these programs run at the same time.
  virtual void finish(RobotOutput&) {}

  /// Memory into which the camera writes the next image, so that it is not copied; null if the
  /// simulation shall provide it.
  virtual Image* nextImage() { return nullptr; }
  /// The image that the robot works on, if `nextImage` is not null.
  virtual const Image* lastImage() const { return nullptr; }
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
/// acts; (3) for each robot, in parallel: sensors are read, the radio delivers, if an image is due
/// it is taken, the controller runs; the world is only read meanwhile, and a robot touches only
/// what is its own; (4) in the order of the robots, cycles are finished, and commands and messages
/// are taken from the outputs. So a command takes effect in the tick after that whose readings it
/// answers. Images are due every fifth tick (40 ms) for all robots at once; each row sees the world
/// from where the camera was when the row was exposed.
class Simulation {
 public:
  static constexpr int ticksPerImage = 5;

  /// Fails if the scene's models are wrong. `threads` counts the calling thread.
  static Result<std::unique_ptr<Simulation>> make(const SceneDescription& scene, std::uint64_t seed,
                                                  std::size_t threads = 1,
                                                  const FieldDimensions& field = {});
  /// As above, with the scene's model composed before (`composeModel`).
  static Result<std::unique_ptr<Simulation>> make(const SceneDescription& scene, Model model,
                                                  std::uint64_t seed, std::size_t threads,
                                                  const FieldDimensions& field);

  /// Parts of the scene's model files that were left out of the scene. Empty if the model was
  /// passed to `make`.
  const std::vector<Error>& modelWarnings() const { return modelWarnings_; }

  /// Gives an active robot its controller. A robot without one stands still.
  void attach(std::size_t robot, std::unique_ptr<RobotController> controller);
  /// Sets the effects of an active robot's kicks in the kinematic fidelity. To be called before the
  /// first step; by default they are those of the scene's configuration, `kicks.cfg`.
  void setKicks(std::size_t robot, std::shared_ptr<const KickTable> kicks) {
    robots_[robot].kicks = std::move(kicks);
  }
  /// Adds a controller of the scene; all run in the order in which they came.
  void add(std::unique_ptr<SceneController> controller) {
    sceneControllers_.push_back(std::move(controller));
  }
  /// The error that a robot's controller threw, after which it was not called again; empty if it
  /// threw none.
  const std::string& failure(std::size_t robot) const { return robots_[robot].failure; }
  /// Continues in the other fidelity with everything where it is. Fails if the scene's models
  /// cannot be read any more.
  Result<void> changeFidelity(Fidelity fidelity);
  /// Applies profile, noise, body, walking, dynamics, camera, ball (`physics`) and radio parameters
  /// of `scene`, which must equal the running scene in all else. Spectators are not changed.
  void change(const SceneDescription& scene);
  /// Applies the camera settings that an active robot's program requested (report B.4.3).
  void setCamera(std::size_t robot, const CameraSettings& settings) {
    robots_[robot].settings = settings;
    robots_[robot].camera = withSettings(scene_.camera, settings);
  }
  /// Sets the effects of one active robot's camera. At the start they are those of the scene.
  void setCamera(std::size_t robot, const CameraEffects& effects) {
    robots_[robot].camera = effects;
  }
  const CameraEffects& camera(std::size_t robot) const { return robots_[robot].camera; }
  /// Switches all cameras on or off. They are on at the start.
  void takeImages(bool on) { takeImages_ = on; }
  /// Switches the camera of one active robot on or off (report I.5.3: ci). While it is off, the
  /// robot gets its last image repeatedly, so that the processes that wait for images still run.
  void takeImages(std::size_t robot, bool on);

  /// Simulates one tick (8 ms).
  void step();

  Time time() const { return world_->time(); }
  bool finished() const { return referee_.over(time()); }
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
  /// The last values of a sensor of the field. A sensor that is costly (a facette) measures now.
  const std::vector<double>& readFieldSensor(std::size_t sensor) {
    return fieldSensors_.read(sensor, *world_, *cameraScene_);
  }
  /// The percept of the scene's ceiling camera in this tick; null if the scene has no such camera,
  /// or it took no image in this tick.
  const CeilingCameraPercept* ceilingPercept() const {
    return ceilingCamera_ && ceilingPercept_.time == time() ? &ceilingPercept_ : nullptr;
  }
  /// The last percept of the ceiling camera, also in ticks without a new one.
  const CeilingCameraPercept& lastCeilingPercept() const { return ceilingPercept_; }
  Sensors& sensors(std::size_t robot) { return robots_[robot].sensors; }
  RobotController* controller(std::size_t robot) { return robots_[robot].controller.get(); }
  /// Input and output of an active robot's controller in the last tick.
  const RobotInput& input(std::size_t robot) const { return robots_[robot].input; }
  const RobotOutput& output(std::size_t robot) const { return robots_[robot].output; }
  /// From now on, keeps the true class and geom of each pixel of one active robot's images.
  void keepTruth(std::size_t robot);
  /// The truth about a robot's last image; null if it is not kept (`keepTruth`), or there was no
  /// image since then.
  const ImageTruth* truth(std::size_t robot) const;
  /// A robot's last image, also in ticks without a new one; without pixels before the first.
  const Image& image(std::size_t robot) const;
  /// The view from which the robot's last image was taken.
  const CameraView& lastView(std::size_t robot) const { return robots_[robot].view; }
  /// Takes an image with a robot's camera now, with all its errors, and the truth about it if
  /// `truth` is not null. The robot does not get the image.
  void takeImage(std::size_t robot, CameraRenderer& renderer, Image& image, ImageTruth* truth);
  /// A hash of the state of world, game and radio and of what the robots sense and do. Equal runs
  /// have equal fingerprints; different ones almost never.
  std::uint64_t fingerprint() const;
  /// The computing times of the simulator's parts: the world, and for each robot its sensors and
  /// its camera.
  std::vector<const Stopwatch*> times() const;

 private:
  static constexpr std::size_t mostDue =
      static_cast<std::size_t>(BodyParameters::longestDelay) / tickMs + 1;

  /// An active robot's own part of the simulation: its controller and its simulated hardware.
  struct Hardware {
    std::unique_ptr<RobotController> controller;
    Sensors sensors;
    std::shared_ptr<const KickTable> kicks;
    bool cameraOn = true;
    Random imageSeeds;
    CameraEffects camera;
    RobotInput input;
    RobotOutput output;
    Image image;  ///< The last one, unless it lies at the controller.
    Pose2D odometry;
    Random delays;              ///< Of the images.
    CameraSettings settings{};  ///< The camera settings that the robot requested last.
    CameraView view{};          ///< Of the last image.
    /// Ring of the commands that the motors do not act on yet, and the number of all commands.
    std::array<RobotCommand, mostDue> due{};
    std::size_t commands = 0;
    Stopwatch sensorTime{"sensors"}, cameraTime{"camera"};
    Stopwatch imageTime{"image"};  ///< All work on the robot in a tick with an image.
    std::string failure{};
    std::unique_ptr<ImageTruth> truth{};  ///< Of the last image, if it is kept.
  };

  Simulation(const SceneDescription& scene, std::unique_ptr<World> world, const Random& random,
             std::size_t threads, const FieldDimensions& field);

  void prepareCameras();
  /// Starts with the robots whose last images took longest, so that no thread works on one of them
  /// alone at the end.
  void orderByWork();
  /// Runs a robot for one tick. `renderer` is null if no image is due.
  void run(std::size_t robot, CameraRenderer* renderer);
  void sense(std::size_t robot);
  void lookFromTheCeiling();
  void takeImage(std::size_t robot, CameraRenderer& renderer);
  void act();
  void command(std::size_t robot, const RobotCommand& command);
  RobotBuild buildOf(std::size_t robot) const;
  CameraView viewOf(std::size_t robot);

  SceneDescription scene_;
  std::vector<Error> modelWarnings_;
  std::vector<Player> players_;
  Random random_;
  std::unique_ptr<World> world_;
  Referee referee_;
  Radio radio_;
  Actuators actuators_;
  FieldSensors fieldSensors_;
  std::optional<CeilingCamera> ceilingCamera_;
  CeilingCameraPercept ceilingPercept_;
  CeilingTracker ceilingTracker_;
  std::vector<std::unique_ptr<SceneController>> sceneControllers_;
  std::unique_ptr<CameraScene> cameraScene_;
  std::vector<CameraRenderer> renderers_;  ///< One for each thread.
  std::vector<Hardware> robots_;
  std::vector<std::size_t> order_;  ///< In which robots run; it does not influence the results.
  std::vector<RobotCommand> commands_;
  std::int64_t tick_ = 0;
  bool takeImages_ = true;
  Stopwatch worldTime_{"world"};
  WorkerPool pool_;
};

/// The view of a robot's camera for an image whose last row was exposed `delay` (ms) ago, at most
/// CameraEffects::longestDelay.
CameraView cameraView(const World& world, std::size_t robot, const CameraInfo& info,
                      double delay = 0);

}  // namespace gt
