#pragma once
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/Result.h"
#include "debug/Drawing.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/infrastructure/Image.h"
#include "streams/MessageQueue.h"

namespace gt {

/// What a robot told its tools, as far as a console shows it: the newest drawings, plots over time,
/// texts, the behavior's state, and all of it while it is recorded (report I.3.3, I.5.3: log).
class RobotMemory {
 public:
  struct Sample {
    Time time;
    double value;
  };

  /// Takes what came in one cycle, and the picture that the robot saw in it, if any.
  void take(const MessageQueue& messages, const Image* picture);

  /// The newest of each key.
  const std::map<std::string, Drawing>& drawings() const { return drawings_; }
  /// Whether drawings of a key are kept, as they are at first; those that were are forgotten if
  /// not.
  void showDrawing(const std::string& key, bool on);
  /// What was plotted, and the times of stopwatches in us.
  const std::map<std::string, std::deque<Sample>>& plots() const { return plots_; }
  const BehaviorState& behavior() const { return behavior_; }
  const Image& picture() const { return picture_; }
  /// The texts that came since this was called last.
  std::vector<std::string> takeTexts();

  /// Keeps all messages from now on, or no more of them. Some hundred megabytes are kept at most.
  void record(bool on) { recording_ = on; }
  void clearRecord();
  std::size_t recordedMessages() const { return recordedMessages_; }
  /// Writes what was recorded as a log (MCAP) that viewers show and `sl` replays: what a robot gets
  /// from its platform goes to /input/NAME, all else to /NAME, pictures also as JPEG.
  Result<void> saveRecord(const std::string& file, const std::string& robot) const;

 private:
  void keep(Time time, Drawing drawing);
  void keep(const std::string& plot, Sample sample);
  void keep(std::string text);
  void keepAll(const MessageQueue& messages);

  std::map<std::string, Drawing> drawings_;
  std::map<std::string, Time> drawnAt_;
  std::set<std::string> hidden_;  ///< Keys of drawings that are not kept.
  std::map<std::string, std::deque<Sample>> plots_;
  BehaviorState behavior_;
  Image picture_;
  std::vector<std::string> texts_;
  bool recording_ = false;
  std::vector<std::vector<std::byte>> record_;  ///< Queues, a cycle each.
  std::size_t recordedBytes_ = 0, recordedMessages_ = 0;
};

}  // namespace gt
