#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logs/LogPlayer.h"
#include "logs/RecordedSetup.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"
#include "robot/Robot.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// Names, in a log's metadata, that a robot's program recorded itself from its begin on: then its
/// modules remembered nothing, whenever the platform had begun.
constexpr const char* beginsWithProgram = "begins with";

/// How a log is replayed; by default as it was recorded.
struct ReplayOptions {
  std::string log;
  /// Another configuration than the log's own, where it has one. It runs on what was recorded: what
  /// the robot decided comes from the log, since its body did that.
  std::shared_ptr<const Configuration> configuration{};
  std::string layout{};  ///< Another layout; needed where the log has none.
  /// Other solutions of tasks. They run on what was recorded, too.
  std::vector<Configuration::SolutionChoice> solutions{};
  /// With another configuration or other solutions, the robot decides anew, too. Its odometry is
  /// then that of a walk which the recorded sensors never saw.
  bool wholeRobot = false;
  /// Called with what of the log is damaged or cannot be read.
  std::function<void(const Error&)> warn{};
};

/// The platform of a robot that runs on a log: sends what the log's robot got from its platform
/// (/input/…), at the recorded times, into whatever modules the layout has, as fast as it goes.
/// With the same modules all that they compute is the same, bit for bit. What they cannot compute,
/// since what it is made of was not recorded, comes from the log, as far as it was recorded itself:
/// the log stands for tasks that are disabled. Recorded types may have changed since: they are read
/// by name.
class ReplayPlatform {
 public:
  static Result<ReplayPlatform> make(const ReplayOptions& options);

  /// Sends what belongs to the next moment and lets the robot step; false at the log's end.
  Result<bool> step();
  /// Begins anew with a new robot, which runs through the log up to a moment from some seconds
  /// before it on. References to the robot that was are no longer valid.
  Result<void> goTo(std::size_t moment);
  /// Called with each such robot before it runs.
  void onNewRobot(std::function<void(Robot&)> prepare) { newRobot_ = std::move(prepare); }
  /// Also has the robot send to its tools what the log's robot sent under debug keys: drawings,
  /// plots, what the behavior did; unless it computes that itself, since the key is on.
  void showRecorded() { showsRecorded_ = true; }
  /// Called with all that is sent to the robot, as its platform does.
  using InputHandler = std::function<void(Time, const RepresentationType&, const void* package)>;
  void onInput(InputHandler handle) { input_ = std::move(handle); }
  /// What makes the robot: as recorded, with what is wanted instead.
  const RecordedSetup& recorded() const { return recorded_; }
  /// Why what the robot computes may differ from what it computed when the log was recorded,
  /// although its modules are the same; one sentence each.
  const std::vector<std::string>& caveats() const { return caveats_; }
  /// Has the robot run another solution of a task from now on, on what was recorded; see
  /// ReplayOptions.
  void runsAnother(const std::string& task);

  /// What of the log is damaged or cannot be read, each once; nothing if all has been taken.
  std::optional<Error> takeWarning();

  LogPlayer& player() { return player_; }
  Time now() const { return now_; }
  Robot& robot() { return *robot_; }
  const Robot& robot() const { return *robot_; }
  /// Why a task cannot be solved on this log; empty if it can.
  std::string missingFor(std::string_view task) const;
  /// What the robot sends to its tools: the recorded representations that it has, too, and all that
  /// its modules compute, if `watchAll` was called.
  const std::vector<const RepresentationType*>& watched() const { return watched_; }
  void watchAll();

 private:
  /// A recorded channel.
  struct Channel {
    const RepresentationType* type;
    std::optional<MessageDefinition> definition;  ///< If the recorded type is another one.
    std::shared_ptr<void> value;
    bool input = false;       ///< From the platform; otherwise what the robot sent.
    bool provided = false;    ///< By a task of the robot that runs on the log.
    bool sent = false;        ///< To that robot, as from its platform.
    bool unreadable = false;  ///< A message was; it has been reported.
  };

  explicit ReplayPlatform(LogPlayer player) : player_{std::move(player)} {}
  Result<void> findChannels();
  Result<void> chooseSetup(const ReplayOptions& options);
  void dropStandingProcesses();
  void disableUnrecorded();
  Result<void> lookForMemory();
  Result<void> makeRobot();
  void takeDecisions();
  bool disableFor(const Task& task, std::vector<const RepresentationType*>& gaps);
  bool isRecorded(std::string_view name, bool input) const;
  Result<void> take(const McapChannel& channel, const McapMessage& message);
  bool decode(Channel& channel, const McapMessage& message);
  void send(const RepresentationType& type, const void* package);
  void send(const Channel& channel);
  void sendImage();
  void show(const Channel& channel);
  Error damaged(std::string field, std::string what) const;

  LogPlayer player_;
  RecordedSetup recorded_;
  RobotSetup setup_;
  std::unique_ptr<Robot> robot_;
  std::vector<std::optional<Channel>> channels_;  ///< By the channels' ids.
  std::vector<Configuration::SolutionChoice> solutions_;
  std::set<std::string> chosen_;  ///< Tasks with another solution than the log's.
  bool otherFiles_ = false;       ///< Than those in the log.
  bool wholeRobot_ = false;
  std::vector<std::string> caveats_;
  std::vector<const RepresentationType*> watched_;
  std::function<void(Robot&)> newRobot_;
  InputHandler input_;
  std::deque<Error> warnings_;
  SensorDataBuffer sensors_;
  Image image_;  ///< Without what the robot saw: only its header was recorded.
  bool showsRecorded_ = false;
  bool pixels_ = true;           ///< Whether whole images were recorded.
  std::string perceptOfImages_;  ///< Comes with each image, if not even headers were recorded.
  Time now_;
};

}  // namespace gt
