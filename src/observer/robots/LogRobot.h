#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/TemporaryFolder.h"
#include "observer/RobotLink.h"
#include "robot/replay/ReplayPlatform.h"

namespace gt {

/// Where logs without a setup have it from.
struct LogRobotOptions {
  DataRoot root{};
  std::shared_ptr<const Configuration> configuration{};
  /// For logs of 2009, in other formats; empty: the one that lies beside the log.
  std::string colorTable{};
};

/// A log that is replayed, of this system (.mcap) or of a real robot of 2009.
struct OpenedLog {
  std::string file;                            ///< As it was named.
  std::unique_ptr<TemporaryFolder> converted;  ///< Holds a log of 2009 in our format.
  ReplayPlatform platform;
  std::vector<Error> warnings{};  ///< What of a log of 2009 was left out.
};
/// Opens a log with its own setup, or else with the options', as far as what was recorded suffices;
/// with other solutions of tasks.
Result<OpenedLog> openLog(const std::string& file, const LogRobotOptions& options,
                          const std::vector<Configuration::SolutionChoice>& solutions = {});

/// A robot that runs on a log as it is played: played on, back, from elsewhere, faster, again and
/// again. Whenever it is not simply played on, the robot begins anew some seconds before, with all
/// that it has received by messages. What the log's robot drew, plotted and decided is shown as it
/// was recorded, unless the robot is asked to draw it anew.
class LogRobot {
 public:
  static Result<std::unique_ptr<LogRobot>> open(const std::string& file,
                                                const LogRobotOptions& options);

  /// The robot's message queues. What this log cannot do is refused. The robot must outlive it.
  std::unique_ptr<RobotLink> link();

  /// Lets time pass, in ms: plays what is due, and hands over what the robot sends.
  Result<void> pass(double ms, const RobotLink::Taker& take);
  /// Plays so many moments more; negative: those before the one that was played last.
  Result<void> step(int moments, const RobotLink::Taker& take);
  /// Goes to the first moment that is not before a time, or to the one of a message. What follows
  /// waits until the time from there on has passed.
  Result<void> goToTime(Time time, const RobotLink::Taker& take);
  Result<void> goToMessage(std::uint64_t message, const RobotLink::Taker& take);

  /// The log's name; the player's is another one if the log was of another format.
  const std::string& file() const { return file_; }
  LogPlayer& player() { return platform_.player(); }
  Robot& robot() { return platform_.robot(); }
  /// What of the log is damaged or cannot be read, each once; nothing if all has been taken.
  std::optional<Error> takeWarning();
  /// Counts how often the robot began anew.
  int beginnings() const { return beginnings_; }

 private:
  class Link;

  explicit LogRobot(OpenedLog log);
  Result<bool> playNext(const RobotLink::Taker& take);
  Result<void> goTo(std::size_t moment, const RobotLink::Taker& take);
  void handOver(const RobotLink::Taker& take);
  bool refuses(const Message& message, MessageQueue& answers) const;
  void runsAnother(const SolutionRequest& request);

  std::string file_;
  std::unique_ptr<TemporaryFolder> converted_;
  ReplayPlatform platform_;
  std::vector<Error> warnings_;
  MessageQueue toRobot_, requests_{4 << 20};
  int beginnings_ = 0;
};

}  // namespace gt
