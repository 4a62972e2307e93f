#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/ConnectedProgram.h"
#include "match/BodyCommands.h"
#include "robot/linux/Lockstep.h"

namespace gt {

/// A robot whose program, of this or another version of the sources, runs in lockstep with the
/// simulation: each tick waits for its answer. So the match is determined by scene, seed and
/// programs, independent of their speed. After a failure the robot stays as it stood.
class LockstepRobot : public MatchRobot {
 public:
  /// Communicates over a socket with a program, which is a child of this one if `program` is given.
  /// If the program does not answer within `patience`, it has failed.
  LockstepRobot(std::string name, FileDescriptor socket, std::chrono::milliseconds patience,
                std::optional<ConnectedProgram> program = {});
  /// Starts the program of a robot: its path, then its arguments.
  static Result<std::unique_ptr<LockstepRobot>> start(std::string name,
                                                      const std::vector<std::string>& command,
                                                      std::chrono::milliseconds patience);
  /// Waits until the program can play. To be called once, before the first cycle.
  Result<void> greet();

  /// Sends the measurements; the program works while the cycles of other robots run.
  void cycle(const RobotInput& input, RobotOutput& output) override;
  /// Waits for the program's answer.
  void finish(RobotOutput& output) override;
  Image* nextImage() override { return &image_; }
  const Image* lastImage() const override { return &image_; }

  const std::string& name() const { return name_; }
  /// The greeting that the robot sent at the beginning.
  const LockstepGreeting& greeting() const { return greeting_; }
  const CameraSettings& camera() const { return commands_.camera; }
  /// The error because of which it no longer plays; empty while it plays.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  template <typename T>
  struct Received {
    T value;

    /// Reads the value if the message holds one, and lets `place` point to it from then on.
    Result<void> take(const Message& message, const T*& place);
  };

  template <typename Slots, typename T>
  static auto& slot(Slots& slots, const T* place);
  Result<void> send(const RobotInput& input);
  Result<void> takeAnswer();
  Result<void> receive();
  Error named(Error error);

  std::string name_;
  std::optional<ConnectedProgram> program_;  ///< Ends after the stream.
  QueueStream stream_;
  MessageQueue messages_{lockstepQueueSize};
  LockstepGreeting greeting_;
  Image image_;
  CommandSlots<Received> received_;
  BeliefSlots<Received> believed_;
  BodyCommands commands_;
  bool withImage_ = false;  ///< In this tick.
  std::optional<Error> failure_;
};

}  // namespace gt
