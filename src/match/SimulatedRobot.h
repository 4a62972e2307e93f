#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "match/MatchRobot.h"
#include "match/MatchSummary.h"
#include "observer/RobotLink.h"
#include "observer/RobotLog.h"
#include "robot/Robot.h"
#include "robot/SetupFiles.h"

namespace gt {

/// The platform of a robot in the simulator: hands what the simulated hardware measured to the
/// robot's processes and takes their commands. Writes the robot's log.
class SimulatedRobot : public MatchRobot {
 public:
  SimulatedRobot(std::string name, std::unique_ptr<Robot> robot);

  /// Records from now on, so that a replay does the same again: with the images' pixels if
  /// `pixels`, or else with what is seen in them.
  Result<void> record(const std::string& path, const McapWriter::Metadata& about,
                      const Configuration::LogSettings& settings, const SetupFiles& setup,
                      bool pixels);
  Result<void> closeLog();
  /// Where messages go that a QueueFillRequest asks to save: BASE.saved.mcap, BASE.saved.2.mcap.
  void saveTo(const std::string& base);

  void cycle(const RobotInput& input, RobotOutput& output) override;

  /// The robot's message queues, between its cycles. The robot must outlive it.
  std::unique_ptr<RobotLink> link();
  /// Called after each cycle with what the robot sends to its tools, in the thread of the cycle.
  using Observer = std::function<void(const MessageQueue& messages)>;
  void observe(Observer observer) { observer_ = std::move(observer); }
  /// Whether what disabled tasks would provide comes from the oracle: oracled world states
  /// (report I.5.3: so). A console has them sent; without one they are not.
  void sendOracle(bool on) { oracle_ = on; }
  /// Gives the robot a computer of its own, so many times slower than this one: pictures that come
  /// while it is busy are lost, as on the real one (report I.5.2: st off). 0: it takes no time.
  void setSlowness(double slowness) { slowness_ = slowness; }
  std::int64_t lostPictures() const { return lostPictures_; }

  /// Has the percepts of the next picture drawn, for the report page.
  void requestDrawings();
  /// The drawings that came since, on the picture.
  std::vector<Drawing> takeDrawings();

  const std::string& name() const { return name_; }
  const Robot& robot() const { return *robot_; }
  Robot& robot() { return *robot_; }
  const RobotPose* pose() const override { return pose_; }
  const BallModel* ball() const override { return ball_; }
  const RobotState* state() const override { return state_; }
  const MotionInfo* motion() const override { return motion_; }
  /// The time that writing the log has taken.
  const Stopwatch& logTime() const { return logTime_; }

 private:
  void bind();
  template <typename T>
  void send(Time now, const T& package);
  bool isBusy(Time now) const { return static_cast<double>(now.ms) < busyUntil_; }
  void live(const RobotInput& input, bool picture);
  template <typename T>
  const T* command() const {
    return std::get<const T*>(commands_);
  }
  void handleMessages(const RobotInput& input);

  std::string name_;
  std::unique_ptr<Robot> robot_;
  // What the robot provides, until its layout changes.
  int layoutChanges_ = -1;
  template <typename T>
  using Provided = const T*;
  CommandSlots<Provided> commands_;
  CameraSettings camera_;  ///< As the camera is set.
  const RobotPose* pose_ = nullptr;
  const BallModel* ball_ = nullptr;
  const RobotState* state_ = nullptr;
  const MotionInfo* motion_ = nullptr;
  std::int64_t pictures_ = 0;
  Observer observer_;
  bool oracle_ = false;
  double slowness_ = 0;
  double busyUntil_ = 0;  // ms
  std::int64_t lostPictures_ = 0;
  std::optional<RobotLog> log_;
  std::int64_t picturePeriod_ = 0;
  Time nextPicture_;
  std::vector<Drawing> drawings_;
  Stopwatch logTime_{"logs"};
};

}  // namespace gt
