#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Random.h"
#include "base/Result.h"
#include "base/Time.h"
#include "representations/infrastructure/JointGains.h"
#include "representations/motion/KickTable.h"
#include "simulation/scene/MuJoCo.h"
#include "simulation/scene/Scene.h"
#include "simulation/world/Obstacles.h"
#include "simulation/world/RobotParts.h"

namespace gt {

/// The length of a tick: sensors and joints work at this pace (facts, 1.3).
constexpr std::int64_t tickMs = 8;
constexpr double tickSeconds = tickMs / 1000.0;

/// What one robot's motors shall do in a tick, and how far it believes to walk in it.
struct RobotCommand {
  JointAngles joints{};
  Pose2D step;
  /// That it performs, or null: in the kinematic fidelity balls go where this says.
  const KickDescription* kick = nullptr;
  JointGains gains{};  ///< Only the dynamic fidelity has servos for them.
};

/// A step of one tick, at most as long as a robot could ever make it.
Pose2D possibleStep(const Pose2D& step);

/// How a robot lies or stands.
enum class Posture { standing, onLeftSide, onRightSide, onNose, onBack, sitting };

/// How a body that is put into a posture leans at first.
struct Lean {
  double tilt = 0;  ///< rad, + nose up
  double roll = 0;  ///< rad, + right side down
};
Lean leanOf(Posture posture);
/// How a body lies or stands whose axes point so in the world.
Posture postureOf(const Matrix3d& rotation);

/// Where a robot truly is, in the field's coordinates.
struct RobotBody {
  Pose2D pose;           ///< mm, rad: the body's center on the ground
  double height = 150;   ///< mm: the body's origin above the ground
  double tilt = 0;       ///< rad, + nose up
  double roll = 0;       ///< rad, + right side down
  JointAngles joints{};  ///< rad
  double walked = 0;     ///< mm since the start, over ground
  Posture posture = Posture::standing;
  std::array<bool, 4> footOnGround{};  ///< in the order of Leg
  /// The other robot that it walks into; -1: none.
  int pushes = -1;
  /// Whether something kept it from doing all that was requested in the last tick (report 5.1.1).
  bool blocked = false;
  Vector3d specificForce{0, 0, 9810};  ///< mm/s^2, in the body's axes: what is felt

  /// The body's origin in space.
  Pose3D origin() const;
};

/// Where a ball truly is, in the field's coordinates.
struct BallState {
  Vector2d position = Vector2d::Zero();  ///< mm
  Vector2d speed = Vector2d::Zero();     ///< mm/s
  int lastToucher = -1;  ///< Index of the robot that touched it last; -1 nobody yet.
  Time lastTouched = never();
};

/// A robot or a ball that was put by hand since the last tick.
struct Put {
  bool ball = false;
  std::size_t index = 0;              ///< Of the robot or the ball.
  Vector2d asked = Vector2d::Zero();  ///< mm
  Vector2d place = Vector2d::Zero();  ///< mm: `asked`, or the nearest free place.
  double askedSpeed = 0;              ///< mm/s, of a ball.
};

/// The simulated world: field, robots and balls. The robots of the scene's group `robots` come
/// first, those of `extras` behind them. How bodies move is up to the fidelity (`makeWorld`).
class World {
 public:
  /// Ticks back that the camera's pose can be asked for: more than an image's exposure, which may
  /// have ended some time ago.
  static constexpr std::size_t cameraHistory =
      static_cast<std::size_t>(CameraEffects::longestImage + CameraEffects::longestDelay) / tickMs +
      1;

  virtual ~World() = default;

  /// One tick of 8 ms. One command for each active robot. Commands that are no numbers are ignored.
  virtual void step(std::span<const RobotCommand> commands) = 0;

  const mjModel& model() const { return *model_; }
  /// The poses of all geoms at the end of the last tick. Only `step` and the `place` functions
  /// change it, so it may be read by many threads between them.
  const mjData& data() const { return *data_; }
  Time time() const { return time_; }

  std::size_t activeRobots() const { return active_; }
  std::size_t robotCount() const { return robots_.size(); }
  const RobotBody& robot(std::size_t i) const { return robots_[i]; }
  const RobotParts& parts(std::size_t i) const { return parts_[i]; }
  std::size_t ballCount() const { return balls_.size(); }
  const BallState& ball(std::size_t i) const { return balls_[i]; }
  double ballRadius(std::size_t i) const { return ballParts_[i].radius; }
  int ballBody(std::size_t i) const { return ballParts_[i].body; }

  /// The pose of a robot's camera on the field (mm; x along the optical axis, y left, z up), now or
  /// up to `cameraHistory` - 1 ticks ago.
  const Pose3D& camera(std::size_t robot, std::size_t ticksAgo = 0) const;

  // All that puts robots and balls goes to the nearest free place: what was put since the last tick
  // in its order, none of it into what stands or lies there. So who puts two things at the places
  // of each other gets what was asked for.

  /// Puts a robot by hand; it stands on its feet.
  void placeRobot(std::size_t robot, const Pose2D& pose);
  /// Puts a ball; it rests, and nobody has touched it, if `forget`. Its speed (mm/s) is at most
  /// `BallParameters::maxSpeed`.
  void placeBall(std::size_t ball, const Vector2d& position, const Vector2d& speed = {0, 0},
                 bool forget = true);
  /// Puts a robot into another posture; `placeRobot` or `standUp` puts it back on its feet.
  void throwOver(std::size_t robot, Posture posture);
  void standUp(std::size_t robot);
  /// What was put since the last tick, in its order; at first all that the scene puts.
  std::span<const Put> puts() const { return puts_; }
  /// How often something was put.
  std::size_t putCount() const { return putCount_; }
  /// How often the physics' numbers diverged; each time all went on from where it last was.
  std::int64_t divergences() const { return divergences_; }
  /// Whether a ball would touch a robot at a place (mm).
  bool wouldTouch(std::size_t ball, const Vector2d& place, std::size_t robot);
  /// Pushes a robot's body during the next tick, with a force (N, along the field's axes) at a
  /// point (mm, in the body's axes). Only where bodies have forces: in the dynamic fidelity.
  virtual void push(std::size_t /*robot*/, const Vector3d& /*force*/, const Vector3d& /*at*/) {}
  /// Puts a joint that belongs to no robot and no ball at coordinates of MuJoCo, at rest.
  void moveJoint(int joint, std::span<const double> coordinates);
  /// Puts a geom that stands still somewhere else (mm); robots and balls meet it there.
  virtual void moveGeom(int geom, const Vector3d& position);
  /// Sets how strongly a light of the model shines: 0 to 1 times the model's value.
  void emit(int light, double share);
  double emission(int light) const { return shares_[static_cast<std::size_t>(light)]; }
  /// The intensity that reaches all surfaces: red, green, blue in 0 to 1.
  void setAmbient(const Vector3d& rgb);
  /// Turns a robot's joint by hand (rad), within its limits.
  void turnJoint(std::size_t robot, Joint joint, double angle);
  /// Has MuJoCo measure with the model's sensors that depend on positions only.
  void measureSensors();
  /// How far motions are from perfect from now on: the scene's value. Not all fidelities use all.
  virtual void change(const SceneDescription& scene);
  /// Takes over how all stands and lies, and the time, from another world of the same scene.
  void continueFrom(const World& other);

 protected:
  /// What overlaps by less only touches (mm).
  static constexpr double touching = 0.1;

  World(const SceneDescription& scene, Model model);
  Result<void> findParts(const SceneDescription& scene);
  /// Puts all that there is where it is, robots first.
  void putAll();
  /// Puts a robot down at its place in its posture: height, tilt and roll, and all its parts.
  virtual void putDown(std::size_t robot) = 0;
  // Whether two things overlap, as `robots_`, `balls_` and the geoms are now.
  virtual bool robotsOverlap(std::size_t a, std::size_t b) const = 0;
  virtual bool robotOverlapsField(std::size_t robot) const = 0;
  virtual bool ballOverlapsRobot(std::size_t ball, std::size_t robot) const = 0;
  virtual bool ballOverlapsField(std::size_t ball) const = 0;

  void writeRobot(std::size_t i);
  void writeBall(std::size_t i);
  /// Poses of all geoms from the state.
  void updateKinematics();
  void advanceTime();

  Model model_;
  ModelData data_;
  Obstacles obstacles_;
  std::vector<RobotParts> parts_;
  std::vector<BallParts> ballParts_;
  std::vector<RobotBody> robots_;
  std::vector<BallState> balls_;
  std::vector<bool> placed_;  ///< By hand since the last tick: no speed follows from that.
  std::vector<bool> placedBalls_;
  std::int64_t divergences_ = 0;

 private:
  void put(const Put& put);
  void settle(Put& put);
  bool isFree(const Put& put) const;
  bool robotIsFree(std::size_t robot) const;
  bool ballIsFree(std::size_t ball) const;
  void moveBall(std::size_t ball, const Vector2d& place);
  /// Whether a robot or a ball stands where others must not be put.
  std::vector<bool>::reference counts(const Put& put) {
    return put.ball ? ballCounts_[put.index] : robotCounts_[put.index];
  }

  std::size_t active_;
  Time time_;
  double fastestBall_;  ///< mm/s
  std::vector<Put> puts_;
  std::size_t putCount_ = 0;
  std::vector<bool> robotCounts_, ballCounts_;  ///< False while they wait for being put.
  std::vector<float> emission_;  ///< Of the model's lights: diffuse red, green, blue.
  std::vector<double> shares_;   ///< How strongly they shine now.
  std::vector<std::array<Pose3D, cameraHistory>> cameras_;  ///< Newest first.
};

/// Whether two geoms come nearer to each other than `gap` (m; negative: overlap by more).
bool geomsTouch(const World& world, int a, int b, double gap);

/// The world of a scene, with the fidelity that it asks for.
Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, const Random& random);
/// The same, with the scene's model, which was composed before.
Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, Model model,
                                         const Random& random);

}  // namespace gt
