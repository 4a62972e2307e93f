#include "measure/worlds/MovedRobot.h"

#include <cmath>

#include "robot/Robot.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

constexpr const char* motionLayout = R"(
process Motion on SensorDataBuffer
  WalkingEngine
  SpecialActions
  GetupEngine
  MotionControl
)";

const RobotModules& motionModules() {
  static const RobotModules modules = [] {
    RobotModules made = tasks();
    addMotion(made);
    return made;
  }();
  return modules;
}

}  // namespace

/// The robot's program: its motion, and this in place of all that decides.
class MovedRobot::Program : public RobotController {
 public:
  Program(const MovedRobot& owner, std::unique_ptr<Robot> robot)
      : owner_{owner}, robot_{std::move(robot)} {}

  void cycle(const RobotInput& input, RobotOutput& output) override {
    robot_->send(owner_.request);
    robot_->send(owner_.head);
    robot_->send(input.sensors);
    robot_->step(input.now);
    output.joints = *robot_->provided<JointData>();
    output.gains = *robot_->provided<JointGains>();
    output.odometry = *robot_->provided<OdometryData>();
    output.specialAction = robot_->provided<MotionInfo>()->executed.specialAction;
  }

  Robot& robot() { return *robot_; }

 private:
  const MovedRobot& owner_;
  std::unique_ptr<Robot> robot_;
};

Result<std::unique_ptr<MovedRobot>> MovedRobot::make(const DataRoot& root,
                                                     const SceneDescription& scene,
                                                     std::uint64_t seed,
                                                     const std::string& motions) {
  const auto layout = parseLayout(motionLayout, "motion");
  if (!layout) return layout.error();
  const auto wanted = configurationOf(layout->processes.front(), motionModules().solutions);
  const auto configuration = loadConfiguration(
      {scene.resolve(scene.config), motions.empty() ? root.path("motions") : motions, {}},
      motionModules(), &wanted);
  if (!configuration) return configuration.error();
  auto simulation = Simulation::make(scene, seed);
  if (!simulation) return simulation.error();
  const SceneRobot& player = scene.robots.front();
  auto robot = Robot::make({*configuration,
                            *layout,
                            player.player(),
                            seed,
                            {&representation<SensorDataBuffer>(), &representation<MotionRequest>(),
                             &representation<HeadMotionRequest>()},
                            player.address},
                           motionModules(), {layout->processes.front().name});
  if (!robot) return robot.error();

  std::unique_ptr<MovedRobot> made{new MovedRobot};
  made->simulation_ = std::move(*simulation);
  made->simulation_->takeImages(false);
  auto program = std::make_unique<Program>(*made, std::move(*robot));
  made->program_ = program.get();
  made->simulation_->attach(0, std::move(program));
  return made;
}

MovedRobot::~MovedRobot() = default;

Result<void> MovedRobot::configure(const std::string& task, const std::string& solution,
                                   const std::string& text) {
  for (const auto& process : program_->robot().processes())
    if (process->solves(task)) return process->configure(task, solution, text, task);
  return Error{.field = task, .what = "is no task of the motion"};
}

void MovedRobot::step() {
  simulation_->step();
}

void MovedRobot::run(double seconds) {
  for (int i = static_cast<int>(std::lround(seconds / tickSeconds)); i > 0; --i) step();
}

void MovedRobot::standUp() {
  do step();
  while (motion().arriving && simulation_->time().ms < 5000);
}

bool MovedRobot::hasFallen() const {
  return body().posture != Posture::standing;
}

const MotionInfo& MovedRobot::motion() const {
  return *program_->robot().provided<MotionInfo>();
}

const OdometryData& MovedRobot::odometry() const {
  return *program_->robot().provided<OdometryData>();
}

}  // namespace gt
