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

/// Metadata name which states that a robot's program recorded the log from its own start on. In
/// this case the modules had no internal state at the begin, regardless of when the platform had
/// started.
constexpr const char* beginsWithProgram = "begins with";

/// Options of a replay; the default is to replay the log as it was recorded.
struct ReplayOptions {
  std::string log;
  /// A configuration that replaces the log's own. It is applied to the recorded data; the robot's
  /// decisions are taken from the log, because its body executed those.
  std::shared_ptr<const Configuration> configuration{};
  std::string layout{};  ///< Another layout; needed where the log has none.
  /// Other solutions of tasks. They are also applied to the recorded data.
  std::vector<Configuration::SolutionChoice> solutions{};
  /// If set, the robot also makes its decisions again with another configuration or other
  /// solutions. Its odometry is then that of a walk which the recorded sensors never measured.
  bool wholeRobot = false;
  /// Called with damaged or unreadable parts of the log.
  std::function<void(const Error&)> warn{};
};

/// The platform of a robot that runs on a log. Sends the packages that the log's robot received
/// from its platform (/input/…), at the recorded times, to the modules of the layout, as fast as
/// possible. With the same modules all results are the same, bit for bit. Results that cannot be
/// computed because their inputs were not recorded are taken from the log, if they were recorded:
/// the log replaces disabled tasks. Recorded types may have changed since: they are read by name.
class ReplayPlatform {
 public:
  static Result<ReplayPlatform> make(const ReplayOptions& options);

  /// Sends the data of the next moment and executes a step of the robot. Returns false at the log's
  /// end.
  Result<bool> step();
  /// Starts again with a new robot, which replays the log up to a moment, beginning some seconds
  /// before it. References to the previous robot become invalid.
  Result<void> goTo(std::size_t moment);
  /// Called with each new robot before it runs.
  void onNewRobot(std::function<void(Robot&)> prepare) { newRobot_ = std::move(prepare); }
  /// Also lets the robot send to its tools the output of the log's robot under debug keys:
  /// drawings, plots, behavior states. Not used for keys that are on, because the robot computes
  /// their output itself.
  void showRecorded() { showsRecorded_ = true; }
  /// Called with all packages that are sent to the robot by its platform.
  using InputHandler = std::function<void(Time, const RepresentationType&, const void* package)>;
  void onInput(InputHandler handle) { input_ = std::move(handle); }
  /// The robot's setup: as recorded, with the replacements of the options.
  const RecordedSetup& recorded() const { return recorded_; }
  /// The reasons why the robot's results may differ from the recorded ones although its modules are
  /// the same; one sentence each.
  const std::vector<std::string>& caveats() const { return caveats_; }
  /// Lets the robot use another solution of a task from now on, on the recorded data; see
  /// ReplayOptions.
  void runsAnother(const std::string& task);

  /// Returns damaged or unreadable parts of the log, each once; empty if all have been returned.
  std::optional<Error> takeWarning();

  LogPlayer& player() { return player_; }
  Time now() const { return now_; }
  Robot& robot() { return *robot_; }
  const Robot& robot() const { return *robot_; }
  /// The reason why a task cannot be solved on this log; empty if it can.
  std::string missingFor(std::string_view task) const;
  /// The representations that the robot sends to its tools: the recorded ones that it has, and also
  /// all results of its modules if `watchAll` was called.
  const std::vector<const RepresentationType*>& watched() const { return watched_; }
  void watchAll();

 private:
  /// A recorded channel.
  struct Channel {
    const RepresentationType* type;
    std::optional<MessageDefinition> definition;  ///< Set if the recorded type differs.
    std::shared_ptr<void> value;
    bool input = false;       ///< Whether it came from the platform; otherwise the robot sent it.
    bool provided = false;    ///< Whether a task of the robot that runs on the log provides it.
    bool sent = false;        ///< Whether it is sent to that robot as from its platform.
    bool unreadable = false;  ///< Whether an unreadable message was found and reported.
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
  std::set<std::string> chosen_;  ///< Tasks with another solution than in the log.
  bool otherFiles_ = false;       ///< Whether other files than those in the log are used.
  bool wholeRobot_ = false;
  std::vector<std::string> caveats_;
  std::vector<const RepresentationType*> watched_;
  std::function<void(Robot&)> newRobot_;
  InputHandler input_;
  std::deque<Error> warnings_;
  SensorDataBuffer sensors_;
  Image image_;  ///< Without pixels and percepts: only its header was recorded.
  bool showsRecorded_ = false;
  bool pixels_ = true;           ///< Whether whole images were recorded.
  std::string perceptOfImages_;  ///< Representation that triggers a cycle with each image, if not
                                 ///< even headers were recorded.
  Time now_;
};

}  // namespace gt
