#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/TemporaryFolder.h"
#include "observer/RobotLink.h"
#include "robot/replay/ReplayPlatform.h"

namespace gt {

/// Replacements for logs without a setup.
struct LogRobotOptions {
  DataRoot root{};
  std::shared_ptr<const Configuration> configuration{};
  /// For logs of 2009, in other formats; empty: use the one beside the log.
  std::string colorTable{};
};

/// A log that is replayed, of this system (.mcap) or of a real robot of 2009.
struct OpenedLog {
  std::string file;                            ///< Name as given by the user.
  std::unique_ptr<TemporaryFolder> converted;  ///< Contains a log of 2009 in the format of this
                                               ///< system.
  ReplayPlatform platform;
  std::vector<Error> warnings{};  ///< Skipped parts of a log of 2009.
};
/// Opens a log with its own setup, or otherwise with that of the options, as far as the recorded
/// data is sufficient. `solutions` replace those of the log.
Result<OpenedLog> openLog(const std::string& file, const LogRobotOptions& options,
                          const std::vector<Configuration::SolutionChoice>& solutions = {});

/// A robot that runs on a log. The log can be played forward, backward, from another position,
/// faster, and repeatedly. Unless the log simply continues, a new robot is started some seconds
/// before the position, with all messages that the previous one has received. Drawings, plots and
/// decisions of the log's robot are shown as recorded, unless the robot is requested to compute
/// them again.
class LogRobot {
 public:
  static Result<std::unique_ptr<LogRobot>> open(const std::string& file,
                                                const LogRobotOptions& options);

  /// The robot's message queues. Requests that this log cannot fulfill are refused. The robot must
  /// outlive the link.
  std::unique_ptr<RobotLink> link();

  /// Advances the time by `ms`: plays the moments that are due, and passes the robot's messages to
  /// `take`.
  Result<void> pass(double ms, const RobotLink::Taker& take);
  /// Plays a number of further moments; a negative number goes back from the moment played last.
  Result<void> step(int moments, const RobotLink::Taker& take);
  /// Goes to the first moment that is not before a time, or to the moment of a message. Later
  /// moments wait until the time from there on has passed.
  Result<void> goToTime(Time time, const RobotLink::Taker& take);
  Result<void> goToMessage(std::uint64_t message, const RobotLink::Taker& take);

  /// Name of the log; the player's name differs if the log was converted.
  const std::string& file() const { return file_; }
  LogPlayer& player() { return platform_.player(); }
  Robot& robot() { return platform_.robot(); }
  /// Returns damaged or unreadable parts of the log, each once; empty if all have been returned.
  std::optional<Error> takeWarning();
  /// Number of times that a new robot was started.
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
