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

/// The targets of one robot's motors in a tick, and the motion that it believes to make.
struct RobotCommand {
  JointAngles joints{};  ///< rad
  Pose2D step;           ///< mm, rad, relative to the robot
  /// The kick that it performs, or null. In the kinematic fidelity it determines the balls' motion.
  const KickDescription* kick = nullptr;
  JointGains gains{};  ///< Only the dynamic fidelity has servos for them.
};

/// A step of one tick, limited to the longest one that a robot can make (mm, rad).
Pose2D possibleStep(const Pose2D& step);

/// The postures of a robot.
enum class Posture { standing, onLeftSide, onRightSide, onNose, onBack, sitting };

/// The initial lean of a body that is put into a posture.
struct Lean {
  double tilt = 0;  ///< rad, + nose up
  double roll = 0;  ///< rad, + right side down
};
Lean leanOf(Posture posture);
/// The posture of a body with a rotation (from the body's to the world's axes).
Posture postureOf(const Matrix3d& rotation);

/// The true state of a robot, in the field's coordinates.
struct RobotBody {
  Pose2D pose;           ///< mm, rad: the body's center on the ground
  double height = 150;   ///< mm: the body's origin above the ground
  double tilt = 0;       ///< rad, + nose up
  double roll = 0;       ///< rad, + right side down
  JointAngles joints{};  ///< rad
  double walked = 0;     ///< mm since the start, over ground
  Posture posture = Posture::standing;
  std::array<bool, 4> footOnGround{};  ///< in the order of Leg
  /// Index of the robot that it walks into; -1: none.
  int pushes = -1;
  /// Whether something kept it from doing all that was requested in the last tick (report 5.1.1).
  bool blocked = false;
  Vector3d specificForce{0, 0, 9810};  ///< mm/s^2, in the body's axes: felt acceleration

  /// The body's origin in space.
  Pose3D origin() const;
};

/// The true state of a ball, in the field's coordinates.
struct BallState {
  Vector2d position = Vector2d::Zero();  ///< mm
  Vector2d speed = Vector2d::Zero();     ///< mm/s
  int lastToucher = -1;  ///< Index of the robot that touched it last; -1 if none did.
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
/// first, those of `extras` behind them. The fidelity determines how bodies move (`makeWorld`).
class World {
 public:
  /// Number of ticks for which the camera's pose is stored: more than an image's exposure and its
  /// delay.
  static constexpr std::size_t cameraHistory =
      static_cast<std::size_t>(CameraEffects::longestImage + CameraEffects::longestDelay) / tickMs +
      1;

  virtual ~World() = default;

  /// Simulates one tick of 8 ms, with one command for each active robot. Commands that are no
  /// numbers are ignored.
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
  /// The radius of a ball (mm).
  double ballRadius(std::size_t i) const { return ballParts_[i].radius; }
  int ballBody(std::size_t i) const { return ballParts_[i].body; }

  /// The pose of a robot's camera on the field (mm; x along the optical axis, y left, z up), now or
  /// up to `cameraHistory` - 1 ticks ago.
  const Pose3D& camera(std::size_t robot, std::size_t ticksAgo = 0) const;

  // Robots and balls are placed at the nearest free place. With each placement, all things placed
  // since the last tick are settled in their order; each blocks its place for others only once it
  // is settled. So two things can be placed at the places of each other.

  /// Places a robot (mm, rad, on the field); it stands on its feet.
  void placeRobot(std::size_t robot, const Pose2D& pose);
  /// Places a ball (mm, on the field) with a speed (mm/s), which is limited to
  /// `BallParameters::maxSpeed`. If `forget`, clears who touched it last.
  void placeBall(std::size_t ball, const Vector2d& position, const Vector2d& speed = {0, 0},
                 bool forget = true);
  /// Puts a robot into another posture; `placeRobot` or `standUp` puts it back on its feet.
  void throwOver(std::size_t robot, Posture posture);
  void standUp(std::size_t robot);
  /// The placements since the last tick, in their order; at first all those of the scene.
  std::span<const Put> puts() const { return puts_; }
  /// The number of all placements.
  std::size_t putCount() const { return putCount_; }
  /// How often the physics diverged; each time everything resumed from its last good position.
  std::int64_t divergences() const { return divergences_; }
  /// Whether a ball at a place (mm, on the field) would touch a robot.
  bool wouldTouch(std::size_t ball, const Vector2d& place, std::size_t robot);
  /// Pushes a robot's body during the next tick, with a force (N, along the field's axes) at a
  /// point (mm, in the body's axes). Has an effect in the dynamic fidelity only.
  virtual void push(std::size_t /*robot*/, const Vector3d& /*force*/, const Vector3d& /*at*/) {}
  /// Puts a joint that belongs to no robot and no ball at coordinates of MuJoCo, at rest.
  void moveJoint(int joint, std::span<const double> coordinates);
  /// Moves an immobile geom to a position (mm); robots and balls collide with it there.
  virtual void moveGeom(int geom, const Vector3d& position);
  /// Sets how strongly a light of the model shines: 0 to 1 times the model's value.
  void emit(int light, double share);
  double emission(int light) const { return shares_[static_cast<std::size_t>(light)]; }
  /// The intensity that reaches all surfaces: red, green, blue in 0 to 1.
  void setAmbient(const Vector3d& rgb);
  /// Turns a robot's joint by hand (rad), within its limits.
  void turnJoint(std::size_t robot, Joint joint, double angle);
  /// Lets MuJoCo measure with the model's sensors that depend on positions only.
  void measureSensors();
  /// Applies the scene's parameters of motion and noise from now on; each fidelity uses some of
  /// them.
  virtual void change(const SceneDescription& scene);
  /// Takes over the state and the time from another world of the same scene.
  void continueFrom(const World& other);

 protected:
  /// Things that overlap by less than this only touch (mm).
  static constexpr double touching = 0.1;

  World(const SceneDescription& scene, Model model);
  Result<void> findParts(const SceneDescription& scene);
  /// Places everything where it is, robots first.
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
  /// Computes the poses of all geoms from the state.
  void updateKinematics();
  void advanceTime();

  Model model_;
  ModelData data_;
  Obstacles obstacles_;
  std::vector<RobotParts> parts_;
  std::vector<BallParts> ballParts_;
  std::vector<RobotBody> robots_;
  std::vector<BallState> balls_;
  std::vector<bool> placed_;  ///< By hand since the last tick, which causes no speed.
  std::vector<bool> placedBalls_;
  std::int64_t divergences_ = 0;

 private:
  void put(const Put& put);
  void settle(Put& put);
  bool isFree(const Put& put) const;
  bool robotIsFree(std::size_t robot) const;
  bool ballIsFree(std::size_t ball) const;
  void moveBall(std::size_t ball, const Vector2d& place);
  /// Whether a robot or a ball blocks its place for others.
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
  std::vector<double> shares_;   ///< Present emission of each light, as a share of `emission_`.
  std::vector<std::array<Pose3D, cameraHistory>> cameras_;  ///< Newest first.
};

/// Whether the distance of two geoms is less than `gap` (m; negative: they overlap by more).
bool geomsTouch(const World& world, int a, int b, double gap);

/// The world of a scene, with the fidelity that it asks for.
Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, const Random& random);
/// As above, with the scene's model composed before.
Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, Model model,
                                         const Random& random);

}  // namespace gt
