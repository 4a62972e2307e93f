#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logs/RobotLog.h"
#include "match/BodyCommands.h"
#include "match/MatchRobot.h"
#include "modules/modeling/OracledLocators.h"
#include "observer/RobotLink.h"
#include "robot/Robot.h"
#include "robot/SetupFiles.h"

namespace gt {

/// The platform of a robot in the simulator: passes the simulated measurements to the robot's
/// processes and takes their commands. Writes the robot's log.
///
/// A robot gets the truth (report 5.1) only on explicit request: from the start if its platform
/// sends it (`representationsWithTruth`), or by `giveTruth`. Its log always holds the simulator's
/// truth: /OracledWorldState.
///
/// The camera writes each image into the package that the process with the ImageProcessor receives
/// (`nextImage`), so it is not copied; docs/image-path.md describes the whole path.
class SimulatedRobot : public MatchRobot {
 public:
  SimulatedRobot(std::string name, std::unique_ptr<Robot> robot);
  /// Makes the robot for one of a simulation's bodies, with the body's name, and attaches it to the
  /// simulation, which owns it. The only function that adds robots with programs.
  static Result<SimulatedRobot*> enter(Simulation& simulation, std::size_t index,
                                       const RobotSetup& setup);

  /// Records a log from now on, so that a replay gives the same results: with the images' pixels if
  /// `pixels`, otherwise with the percepts from them.
  Result<void> record(const std::string& path, const McapWriter::Metadata& about,
                      const Configuration::LogSettings& settings, const SetupFiles& setup,
                      bool pixels);
  Result<void> closeLog();
  /// Returns once the first error while the log was written.
  std::optional<Error> takeLogError() { return log_ ? log_->takeError() : std::nullopt; }
  /// Sets the files of the messages that a QueueFillRequest requests to save: BASE.saved.mcap,
  /// BASE.saved.2.mcap and so on.
  void saveTo(const std::string& base);

  void cycle(const RobotInput& input, RobotOutput& output) override;
  Image* nextImage() override { return robot_->place<Image>(); }
  const Image* lastImage() const override { return image_; }

  /// The robot's message queues, between its cycles. The robot must outlive it.
  std::unique_ptr<RobotLink> link();
  /// Adds a solution of a task, between two cycles; see Robot::add.
  Result<void> add(const std::string& task, Solution solution) {
    auto done = robot_->add(task, std::move(solution));
    bind();
    return done;
  }
  /// Called after each cycle with what the robot sends to its tools, in the thread of the cycle, in
  /// the order in which they were added.
  using Observer = std::function<void(const MessageQueue& messages)>;
  void observe(Observer observer) { observers_.push_back(std::move(observer)); }
  /// Starts or stops sending the robot the truth with each image (report I.5.3: so), for solutions
  /// that use the oracle, which can be selected from then on, and in place of the results of
  /// disabled tasks. To be called between two cycles.
  Result<void> giveTruth(bool on);
  /// Whether it has ever been given the truth.
  bool hadTruth() const { return hadTruth_; }
  /// Sets how many times slower than this computer the robot's computer is: images that come while
  /// it is busy are lost, as on the real one (report I.5.2: st off). 0: its cycles take no time.
  void setSlowness(double slowness) { slowness_ = slowness; }
  std::int64_t lostImages() const { return lostImages_; }

  const std::string& name() const { return name_; }
  const Robot& robot() const { return *robot_; }
  Robot& robot() { return *robot_; }
  const BehaviorTeamMessage* decision() const override { return decision_; }
  /// The time that writing the log has taken.
  const Stopwatch& logTime() const { return logTime_; }

 private:
  void bind();
  bool isBusy(Time now) const { return static_cast<double>(now.ms) < busyUntil_; }
  template <typename T>
  void send(Time now, const T& package);
  void send(const RobotInput& input, bool withImage);
  void layTruth(const OracledWorldState& truth);
  void handleMessages();

  std::string name_;
  std::unique_ptr<Robot> robot_;
  // Pointers to the robot's values, valid until its layout changes.
  int layoutChanges_ = -1;
  BodyCommands commands_;
  const BehaviorTeamMessage* decision_ = nullptr;
  const Image* image_ = nullptr;  ///< Of the first process that reads images.
  std::vector<Observer> observers_;
  bool truth_ = false, hadTruth_ = false;
  OracledSelfLocator oracledPose_;
  OracledBallLocator oracledBall_;
  OracledPlayersLocator oracledPlayers_;
  double slowness_ = 0;
  double busyUntil_ = 0;  // ms
  std::int64_t lostImages_ = 0;
  std::optional<RobotLog> log_;
  std::int64_t loggedImagePeriod_ = 0;  ///< ms; 0: none are logged.
  Time nextLoggedImage_;
  Stopwatch logTime_{"logs"};
};

}  // namespace gt
