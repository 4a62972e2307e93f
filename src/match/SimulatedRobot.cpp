#include "match/SimulatedRobot.h"

#include <algorithm>
#include <utility>

#include "base/CrashNotes.h"
#include "observer/robots/LocalLink.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/PlayersCollection.h"
#include "robot/Solutions.h"

namespace gt {

SimulatedRobot::SimulatedRobot(std::string name, std::unique_ptr<Robot> robot)
    : name_{std::move(name)}, robot_{std::move(robot)} {
  bind();
  truth_ = hadTruth_ =
      std::ranges::count(robot_->platform(), &representation<OracledWorldState>()) > 0;
  if (const auto* camera = commands_.place<CameraSettings>()) commands_.camera = *camera;
}

Result<SimulatedRobot*> SimulatedRobot::enter(Simulation& simulation, std::size_t index,
                                              const RobotSetup& setup) {
  auto robot = Robot::make(setup);
  if (!robot) return robot.error();
  auto entered =
      std::make_unique<SimulatedRobot>(simulation.scene().robots[index].name, std::move(*robot));
  SimulatedRobot* const made = entered.get();
  simulation.setCamera(index, setup.configuration->of<CameraSettings>(setup.address));
  simulation.attach(index, std::move(entered));
  return made;
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
  const auto look = [this]<typename T>(const T*& place) { place = robot_->provided<T>(); };
  std::apply([&](auto&... places) { (look(places), ...); }, commands_.places);
  belief_.forEach(look);
  look(decision_);
  const auto image = robot_->value(representation<Image>().name);
  image_ = image ? static_cast<const Image*>(image->data()) : nullptr;
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
    if (const auto type = robot_->watch(name); !type) return settings.missing(name);
  log->keepPixels(pixels);
  for (const std::string& name : perceptsOfImages(solutions()))
    static_cast<void>(robot_->watch(name));  // a robot that does not see needs none
  static_cast<void>(robot_->request(DebugRequest{traceKey, DebugKeyMode::always, 0}));
  loggedImagePeriod_ = settings.imagePeriod;
  log_ = std::move(*log);
  return {};
}

Result<void> SimulatedRobot::giveTruth(bool on) {
  if (on)
    if (auto done = robot_->addToPlatform(representation<OracledWorldState>()); !done) return done;
  bind();
  truth_ = on;
  hadTruth_ |= on;
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

void SimulatedRobot::cycle(const RobotInput& input, RobotOutput& output) {
  const CrashContext context{name_.c_str()};
  const bool lost = input.image && slowness_ > 0 && isBusy(input.now);
  const bool withImage = input.image && !lost;
  lostImages_ += lost;
  Stopwatch watch{"cycle"};
  {
    const Stopwatch::Lap lap{watch};
    send(input, withImage);
    robot_->step(input.now);
  }
  if (withImage && slowness_ > 0)
    busyUntil_ = static_cast<double>(input.now.ms) + slowness_ * watch.totalMs;
  bind();
  commands_.give(output, belief_, withImage);
  handleMessages();
}

void SimulatedRobot::send(const RobotInput& input, bool withImage) {
  if (withImage && truth_) {
    robot_->send(input.oracle);
    layTruth(input.oracle);
  }
  input.forEach([&](const auto& package) { send(input.now, package); }, withImage);
  if (!withImage || !log_) return;
  const Stopwatch::Lap lap{logTime_};
  log_->write(input.now, input.oracle);
  if (loggedImagePeriod_ == 0 || input.now < nextLoggedImage_) return;
  log_->write(*input.image);
  nextLoggedImage_ = input.now + loggedImagePeriod_;
}

/// Sets the outputs of disabled tasks to the truth.
void SimulatedRobot::layTruth(const OracledWorldState& truth) {
  const FrameInfo frame{truth.time};
  RobotPose pose;
  oracledPose_.update(truth, pose);
  robot_->layIfDisabled(pose);
  BallModel ball;
  oracledBall_.update(truth, frame, ball);
  robot_->layIfDisabled(ball);
  robot_->layIfDisabled(TeamBallModel{truth.ballPosition, truth.time, 0, 0});
  PlayersCollection players;
  oracledPlayers_.update(truth, robot_->setup().player, frame, players);
  robot_->layIfDisabled(players);
}

void SimulatedRobot::handleMessages() {
  MessageQueue& messages = robot_->toTools();
  if (log_) {
    const Stopwatch::Lap lap{logTime_};
    log_->write(messages);
  }
  for (const Observer& observer : observers_) observer(messages);
  messages.clear();
}

}  // namespace gt
