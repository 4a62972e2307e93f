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
/// simulation: each tick waits for its answer. So the match follows from scene, seed and programs,
/// however fast they are. After a failure it stands as it stood.
class LockstepRobot : public MatchRobot {
 public:
  /// Talks over a socket with a program, which is a child of this one if `program` is given. If it
  /// does not answer for so long, it has failed.
  LockstepRobot(std::string name, FileDescriptor socket, std::chrono::milliseconds patience,
                std::optional<ConnectedProgram> program = {});
  /// Starts the program of a robot: its path, then its arguments.
  static Result<std::unique_ptr<LockstepRobot>> start(std::string name,
                                                      const std::vector<std::string>& command,
                                                      std::chrono::milliseconds patience);
  /// Waits until the program can play. To be called once, before the first cycle.
  Result<void> greet();

  /// Sends what is measured; the program works while the cycles of other robots run.
  void cycle(const RobotInput& input, RobotOutput& output) override;
  /// Waits for the answer.
  void finish(RobotOutput& output) override;
  Image* nextImage() override { return &image_; }
  const Image* lastImage() const override { return &image_; }

  const std::string& name() const { return name_; }
  /// What the robot told at the beginning.
  const LockstepGreeting& greeting() const { return greeting_; }
  const CameraSettings& camera() const { return commands_.camera; }
  /// Why it does not play any more.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  template <typename T>
  struct Received {
    T value;

    /// Reads it if the message holds one, and sets the place where it lies from then on.
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
