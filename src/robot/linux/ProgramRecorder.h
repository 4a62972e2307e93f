#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "framework/Layout.h"
#include "logs/RecordedSetup.h"
#include "logs/RobotLog.h"
#include "representations/infrastructure/Image.h"
#include "robot/linux/RobotProgram.h"

namespace gt {

class Wire;

/// Records a robot's log in its Debug process, as defined by config/log.cfg: messages of the other
/// processes, and images of the platform's camera.
class ProgramRecorder {
 public:
  static Result<std::unique_ptr<ProgramRecorder>> open(const RobotProgramOptions& options,
                                                       const Layout& layout,
                                                       const RobotModules& modules);

  /// Subscribes to the packages that the platform sends.
  void connect(Wire& wire);
  /// Requests the contents of the log from each process, and again after a process was restarted.
  void ask(const Wire& wire, MessageQueue& requests);
  /// Writes the received data; `now` in ms. If the log can no longer be written, because the disk
  /// is full or the file was truncated, starts another log as soon as that is possible.
  void write(const Wire& wire, const MessageQueue& messages, std::int64_t now);
  /// Returns the events concerning the log that were not yet reported, one per line.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  ProgramRecorder(RobotLog log, const RobotProgramOptions& options, RecordedSetup setup,
                  const Layout& layout)
      : log_{std::move(log)}, options_{options}, setup_{std::move(setup)}, layout_{layout} {}
  struct Input {
    explicit Input(const RepresentationType& t)
        : type{t}, value{t.make()}, receiver{t, value.get()} {}
    const RepresentationType& type;
    std::shared_ptr<void> value;
    PackageReceiver receiver;
  };

  void choose(const Configuration::LogSettings& settings, const SolutionTable& table);
  void writePicture(std::int64_t now);
  void beginAnew(const Error& reason);

  RobotLog log_;
  const RobotProgramOptions& options_;
  const RecordedSetup setup_;
  const Layout& layout_;
  std::vector<WatchRequest> requests_;
  std::map<std::string, std::uint64_t> sessions_;
  std::int64_t nextFlush_ = 0;
  std::vector<std::unique_ptr<Input>> inputs_;
  Image picture_;
  PackageReceiver pictures_{representation<Image>(), &picture_};
  std::int64_t imagePeriod_ = 0, nextRequest_ = 0;
  Time lastPicture_ = never();
  bool broken_ = false;  ///< Whether the log failed and no other one could be started.
  std::vector<std::string> news_;
};

}  // namespace gt
