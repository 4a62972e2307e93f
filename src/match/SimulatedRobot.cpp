#include "match/SimulatedRobot.h"

#include <utility>

#include "representations/modeling/PlayersCollection.h"
#include "robot/LocalLink.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

/// The drawings of a report page's pictures.
constexpr const char* pictureKeys[] = {"ImageProcessor/horizon", "ImageProcessor/percepts"};

/// Tells the robot the truth in place of its disabled tasks.
void layOracle(const OracledWorldState& truth, Robot& robot) {
  robot.layIfDisabled(RobotPose{truth.robotPose, 1});
  BallModel ball;
  ball.position = truth.robotPose.inverse() * truth.ballPosition;
  ball.speed = rotated(truth.ballSpeed, -truth.robotPose.rotation);
  ball.lastSeen = truth.time;
  ball.consecutiveTimeSeen = 1000;
  robot.layIfDisabled(ball);
  robot.layIfDisabled(TeamBallModel{truth.ballPosition, truth.time, 0, 0});
  PlayersCollection players;
  players.time = truth.time;
  for (const OracledRobot& other : truth.others)
    (other.teamColor == robot.setup().player.teamColor ? players.ownTeam : players.opponents)
        .push_back({other.pose.translation, truth.time, 1, other.number});
  robot.layIfDisabled(players);
}

}  // namespace

SimulatedRobot::SimulatedRobot(std::string name, std::unique_ptr<Robot> robot)
    : name_{std::move(name)}, robot_{std::move(robot)} {
  bind();
  if (const auto* camera = command<CameraSettings>()) camera_ = *camera;
}

void SimulatedRobot::saveTo(const std::string& base) {
  robot_->onSave([this, base](const MessageQueue& messages) {
    const auto file = saveQueue(messages, base);
    robot_->toTools().write(robot_->processes().front()->now(),
                            Text{file ? "saved " + *file : file.error().text()});
  });
}

void SimulatedRobot::bind() {
  if (layoutChanges_ == robot_->layoutChanges()) return;
  layoutChanges_ = robot_->layoutChanges();
  const auto look = [this]<typename T>(const T*& command) { command = robot_->provided<T>(); };
  std::apply([&](auto&... commands) { (look(commands), ...); }, commands_);
  pose_ = robot_->provided<RobotPose>();
  ball_ = robot_->provided<BallModel>();
  state_ = robot_->provided<RobotState>();
  motion_ = robot_->provided<MotionInfo>();
}

Result<void> SimulatedRobot::record(const std::string& path, const McapWriter::Metadata& about,
                                    const Configuration::LogSettings& settings,
                                    const SetupFiles& files, bool pixels) {
  auto log = RobotLog::open(path, about);
  if (!log) return log.error();
  const auto setup = recordSetup(files);
  if (!setup) return setup.error();
  attach(*setup, log->file());
  for (const std::string& name : settings.representations)
    if (const auto type = robot_->watch(name); !type)
      return settings.missing(name);
  log->keepPixels(pixels);
  if (!pixels)
    for (const std::string& name : perceptsOfImages(solutions()))
      static_cast<void>(robot_->watch(name));  // a robot that does not see needs none
  picturePeriod_ = settings.picturePeriod;
  log_ = std::move(*log);
  return {};
}

std::unique_ptr<RobotLink> SimulatedRobot::link() {
  return std::make_unique<LocalLink>(*robot_, [this] { bind(); });
}

Result<void> SimulatedRobot::closeLog() {
  if (!log_) return {};
  auto done = log_->close();
  log_.reset();
  return done;
}

template <typename T>
void SimulatedRobot::send(Time now, const T& package) {
  robot_->send(package);
  if (!log_) return;
  const Stopwatch::Lap lap{logTime_};
  log_->writeInput(now, package);
}

void SimulatedRobot::live(const RobotInput& input, bool picture) {
  input.forEach([&](const auto& package) { send(input.now, package); }, picture);
  if (picture && oracle_) layOracle(input.oracle, *robot_);
  pictures_ += picture;
  robot_->step(input.now);
}

void SimulatedRobot::cycle(const RobotInput& input, RobotOutput& output) {
  const bool picture = input.image && !(slowness_ > 0 && isBusy(input.now));
  if (input.image && !picture) ++lostPictures_;
  if (slowness_ > 0 && picture) {
    Stopwatch watch{"picture"};
    {
      const Stopwatch::Lap lap{watch};
      live(input, picture);
    }
    busyUntil_ = static_cast<double>(input.now.ms) + slowness_ * watch.totalMs;
  } else {
    live(input, picture);
  }
  bind();
  if (const auto* joints = command<JointData>()) output.joints = *joints;
  if (const auto* odometry = command<OdometryData>()) output.odometry = *odometry;
  if (const auto* leds = command<LedValue>()) output.leds = *leds;
  if (const auto* message = command<TeamMessage>();
      message && picture && pictures_ % picturesPerTeamMessage == 0)
    output.message = *message;
  if (const auto* camera = command<CameraSettings>(); camera && *camera != camera_)
    output.camera = camera_ = *camera;
  handleMessages(input);
}

void SimulatedRobot::handleMessages(const RobotInput& input) {
  MessageQueue& messages = robot_->toTools();
  messages.handleAllMessages([this](const Message& message) {
    Drawing drawing;
    if (message.is<Drawing>() && message.read(drawing) && drawing.space == DrawingSpace::image)
      drawings_.push_back(std::move(drawing));
  });
  if (log_) {
    const Stopwatch::Lap lap{logTime_};
    log_->write(messages);
    if (input.image && picturePeriod_ > 0 && input.now >= nextPicture_) {
      log_->write(*input.image);
      nextPicture_ = input.now + picturePeriod_;
    }
  }
  if (observer_) observer_(messages);
  messages.clear();
}

void SimulatedRobot::requestDrawings() {
  for (const char* key : pictureKeys)
    if (DebugKey::find(key))
      static_cast<void>(robot_->request(DebugRequest{key, DebugKeyMode::times, 1}));
}

std::vector<Drawing> SimulatedRobot::takeDrawings() {
  return std::exchange(drawings_, {});
}

}  // namespace gt
