#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// Plays a log: what was recorded at one time belongs together and is a moment. Time passes by
/// `pass`; whoever listens to the log plays the moments that are due.
class LogPlayer {
 public:
  /// Messages that were recorded at one time.
  struct Moment {
    Time time;
    std::uint64_t first;  ///< Number of its first message in the log, from 0.
  };
  using Handler = std::function<Result<void>(const McapChannel&, const McapMessage&)>;

  /// Reads the log once, to find its moments. A damaged log is played as far as it is whole; what
  /// is lost stands in its reader's damage().
  static Result<LogPlayer> open(const std::string& path);

  const std::string& path() const { return path_; }
  const McapReader& log() const { return log_; }
  /// How many messages a channel has.
  std::uint64_t messagesOf(std::uint16_t channel) const;
  const std::vector<Moment>& moments() const { return moments_; }
  std::uint64_t messages() const { return messages_; }
  /// Of the first and the last moment.
  Time begin() const { return moments_.front().time; }
  Time end() const { return moments_.back().time; }

  /// The moment that is played next; that behind the last one at the log's end.
  std::size_t position() const { return position_; }
  bool atEnd() const { return position_ == moments_.size(); }
  /// When the moment was recorded that was played last; the log's begin if none was.
  Time now() const;

  void play() { playing_ = true; }
  void pause() { playing_ = false; }
  bool playing() const { return playing_; }
  /// How fast the log's time passes; 1 as it was recorded.
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }
  /// Whether the log begins anew at its end.
  void setLoop(bool on) { loop_ = on; }
  bool loop() const { return loop_; }

  /// Goes to a moment, to the first one that is not before a time, or to the one of a message.
  void seek(std::size_t moment);
  void seekTime(Time time);
  void seekMessage(std::uint64_t message);
  /// Lets the log's time be this one: later moments wait until it has passed.
  void waitFrom(Time time) { passed_ = static_cast<double>(time - begin()); }
  /// The log's time: all moments up to it are due.
  Time time() const { return begin() + static_cast<std::int64_t>(passed_); }

  /// Lets some of the listener's time pass, in ms.
  void pass(double ms);
  /// Whether the next moment is due. At the end of a loop it is the first one.
  bool due();
  /// Hands over the messages of the next moment in their order, in any case; false at the end. If
  /// another program has changed the log, that is its end, and an error once.
  Result<bool> next(const Handler& handle);

 private:
  LogPlayer(std::string path, McapReader log) : path_{std::move(path)}, log_{std::move(log)} {}
  bool read();
  Error cutOff();

  std::string path_;
  McapReader log_;
  std::vector<Moment> moments_;
  std::uint64_t messages_ = 0;
  std::map<std::uint16_t, std::uint64_t> messagesOf_;
  std::size_t position_ = 0;
  bool playing_ = true;
  bool loop_ = false;
  double speed_ = 1;
  double passed_ = 0;  ///< Of the log's time up to which all moments are due, ms since its begin.
  // The message that was read last but not handed over yet, of all in the order of the file.
  McapMessage message_;
  std::uint64_t number_ = 0;
  bool hasMessage_ = false;
};

}  // namespace gt
